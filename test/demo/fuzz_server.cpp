// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program many times without loading it again. Each line of the input has a directory and
// arguments, with tabs between them. A child process works in that directory, with its output in
// <directory>.txt; the answer is a line with its exit code, or with the negative of the signal that
// ended it: SIGALRM after a minute.

#include "program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> fields(const std::string& line)
{
  std::vector<std::string> result;
  for(std::string::size_type begin = 0, end; begin != std::string::npos;
      begin = end == std::string::npos ? end : end + 1) {
    end = line.find('\t', begin);
    result.push_back(line.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return result;
}

// Runs the child. The first field becomes the name of the program.
[[noreturn]] void run_child(const std::vector<std::string>& call)
{
  const int output = open((call[0] + ".txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int input = open("/dev/null", O_RDONLY);
  if(output < 0 || input < 0 || dup2(input, 0) < 0 || dup2(output, 1) < 0 || dup2(output, 2) < 0 ||
     chdir(call[0].c_str()) != 0)
    std::abort();
  alarm(60);
  std::vector<const char*> arguments;
  for(const std::string& text : call)
    arguments.push_back(text.c_str());
  const int code = run_program(static_cast<int>(arguments.size()), arguments.data());
  std::cout.flush();
  std::fflush(nullptr);
  std::_Exit(code); // under the address sanitizer, std::exit() takes a quarter of the time of a run
}

int run(const std::vector<std::string>& call)
{
  const pid_t child = fork();
  if(child == 0)
    run_child(call);
  int status = 0;
  if(child < 0 || waitpid(child, &status, 0) != child)
    std::abort();
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace

int main()
{
  for(std::string line; std::getline(std::cin, line);)
    std::cout << run(fields(line)) << std::endl;
}
