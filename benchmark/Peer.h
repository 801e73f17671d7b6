// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_PEER_H
#define INTRINSIC_BENCHMARK_PEER_H

#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

// Runs another program for the task of a benchmark: `--peer PROGRAM`. Its argument is the file of a
// mesh. On standard input it gets a line of numbers for each query. After a line of headings, it
// prints a line of numbers for each query. The benchmark defines these numbers.
class Peer
{
public:
  // Removes the option from the beginning of the arguments, if it exists.
  explicit Peer(std::vector<std::string>& arguments)
  {
    if(arguments.size() >= 2 && arguments[0] == "--peer") {
      m_program = arguments[1];
      arguments.erase(arguments.begin(), arguments.begin() + 2);
    }
  }

  // Returns `Columns` numbers for each query. Without the option, or if the program fails, it
  // returns none.
  template <std::size_t Columns, typename Queries>
  std::vector<std::array<double, Columns>> operator()(const std::string& mesh,
                                                      const Queries& queries) const
  {
    std::vector<std::array<double, Columns>> result;
    if(m_program.empty())
      return result;
    const auto folder = std::filesystem::temp_directory_path();
    const std::string name = "benchmark_peer." + std::to_string(std::random_device()());
    const auto input = folder / (name + ".in"), output = folder / (name + ".out");
    write(queries, input);
    const std::string command =
      "'" + m_program + "' '" + mesh + "' < '" + input.string() + "' > '" + output.string() + "'";
    if(std::system(command.c_str()) == 0)
      result = read<Columns>(output);
    if(result.size() != queries.size())
      std::cerr << m_program << " has answered " << result.size() << " queries of "
                << queries.size() << '\n';
    std::filesystem::remove(input);
    std::filesystem::remove(output);
    return result;
  }

private:
  template <typename Queries>
  static void write(const Queries& queries, const std::filesystem::path& path)
  {
    std::ofstream out(path);
    for(const auto& query : queries) {
      for(const auto& x : query)
        out << x << ' ';
      out << '\n';
    }
  }

  template <std::size_t Columns>
  static std::vector<std::array<double, Columns>> read(const std::filesystem::path& path)
  {
    std::vector<std::array<double, Columns>> result;
    std::ifstream in(path);
    std::string headings;
    std::getline(in, headings);
    for(std::array<double, Columns> row; in;) {
      for(double& x : row)
        if(std::string text; in >> text) // may be "nan"
          x = std::strtod(text.c_str(), nullptr);
      if(in)
        result.push_back(row);
    }
    return result;
  }

  std::string m_program;
};

#endif // INTRINSIC_BENCHMARK_PEER_H
