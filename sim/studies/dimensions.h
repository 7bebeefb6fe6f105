#pragma once

#include <string>
#include <vector>

#include "host/emit/options.h"
#include "host/view/projection.h"
#include "sim/shell/command_line.h"
#include "sim/shell/lists.h"
#include "sim/shell/model_options.h"
#include "sim/shell/read_by.h"

/// Dimensions that several studies vary: what their options take.
namespace csgsim::studies {

/// Names of strategies, colourings and the like.
template <class Choices>
std::vector<std::string> names_of(const Choices& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto choice : choices) names.emplace_back(emit::name_of(choice));
  return names;
}

/// Without `auto`, which chooses by the memory at hand.
template <class Choices>
std::vector<std::string> fixed_names_of(const Choices& choices) {
  std::vector<std::string> names;
  for (const auto choice : choices) {
    if (choice != Choices::value_type::automatic) names.emplace_back(emit::name_of(choice));
  }
  return names;
}

inline std::vector<unsigned> z_bits_of(const std::string& text) {
  return shell::parse_numbers(text, view::fewest_z_bits, view::most_z_bits);
}

inline std::vector<unsigned> stack_bits_of(const std::string& text) {
  return shell::parse_numbers(text, emit::fewest_stack_bits, shell::most_stack_bits);
}

/// An option whose text `parse` reads, or refuses.
template <class Parse>
void add_list(shell::Command& command, const std::string& name, std::string& value, const Parse& parse,
              const std::string& help) {
  command.option(name, value, help).check(shell::is_read_by(parse));
}

}  // namespace csgsim::studies
