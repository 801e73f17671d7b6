// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/unknown_words.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace {

typedef std::vector<std::string> Names;

// Returns how many letters must be inserted, removed, exchanged or swapped with the next one.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> before, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, std::exchange(row, {i}));
    for(std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      row.push_back(
        (std::min)({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])}));
      if(is_swap)
        row[j] = (std::min)(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

// Returns a name that begins with the word, or differs from it in at most a third of its letters.
// Returns an empty text if none exists.
std::string nearest(const std::string& word, const Names& names)
{
  std::string result;
  std::size_t least = word.size() / 3 + 1;
  for(const std::string& name : names) {
    const bool is_beginning = word.size() > 2 && name.compare(0, word.size(), word) == 0;
    const std::size_t distance = is_beginning ? 0 : edit_distance(word, name);
    if(distance < least) {
      least = distance;
      result = name;
    }
  }
  return result;
}

bool has(const Names& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

Names command_names(const CLI::App& app)
{
  Names result;
  for(const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    result.push_back(command->get_name());
  return result;
}

// Adds the names of options, also of groups, which are commands without a name.
void add_options(const CLI::App& app, Names& names)
{
  for(const CLI::Option* option : app.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  for(const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    if(group->get_name().empty())
      add_options(*group, names);
}

std::string message(const std::string& what, const std::string& word, const std::string& prefix,
                    const Names& names)
{
  const std::string meant = nearest(word, names);
  return "there is no " + what + " '" + prefix + word + "'" +
         (meant.empty() ? "" : "; did you mean '" + prefix + meant + "'?");
}

std::string unknown_command(const CLI::App& app, const Names& words)
{
  const Names commands = command_names(app);
  for(std::size_t i = 0; i < words.size(); ++i)
    if(words[i] == "--threads")
      ++i;
    else if(words[i].compare(0, 1, "-") != 0)
      return has(commands, words[i]) ? "" : message("command", words[i], "", commands);
  return "";
}

bool is_value(const std::string& word) { return word.compare(0, 1, "-") != 0; }

// Removes the words that are not in `unexpected`. Keeps the last of equal words.
Names in_order(const Names& words, Names unexpected)
{
  Names result;
  for(auto word = words.rbegin(); word != words.rend(); ++word)
    if(const auto found = std::find(unexpected.begin(), unexpected.end(), *word);
       found != unexpected.end()) {
      unexpected.erase(found);
      result.insert(result.begin(), *word);
    }
  return result;
}

// Returns the first repeatable option of the command that two values follow, or an empty text.
std::string option_with_two_values(const CLI::App& command, const Names& words)
{
  for(std::size_t i = 0; i + 2 < words.size(); ++i)
    if(const CLI::Option* const option = command.get_option_no_throw(words[i]);
       option != nullptr && !is_value(words[i]) && is_repeatable(*option) &&
       is_value(words[i + 1]) && is_value(words[i + 2]))
      return words[i];
  return "";
}

} // namespace

bool is_repeatable(const CLI::Option& option)
{
  return !option.get_positional() && !option.get_allow_extra_args() &&
         option.get_expected_max() == CLI::detail::expected_max_vector_size;
}

std::string unexpected_words(const CLI::App& app, int argc, const char* const* argv)
{
  const Names words(argv + 1, argv + argc);
  const Names unexpected = in_order(words, app.remaining(true));
  if(unexpected.empty())
    return "";
  std::string result = "unexpected:";
  for(const std::string& word : unexpected)
    result += " " + word;
  for(const CLI::App* command : app.get_subcommands())
    if(const std::string option = option_with_two_values(*command, words); !option.empty())
      result += "; " + option + " takes one value: give " + option + " again for each further one";
  return result;
}

std::string unknown_word(const CLI::App& app, int argc, const char* const* argv)
{
  const Names words(argv + 1, argv + argc);
  if(std::string result = unknown_command(app, words); !result.empty())
    return result;
  Names names;
  add_options(app, names);
  for(const CLI::App* command : app.get_subcommands())
    add_options(*command, names);
  for(const std::string& word : words)
    if(word.compare(0, 2, "--") == 0 && word.size() > 2)
      if(const std::string name = word.substr(2, word.find('=') - 2); !has(names, name))
        return message("option", name, "--", names);
  return "";
}
