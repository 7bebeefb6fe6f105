// Option values shared by several studies.
// Used by the studies' options.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/emit/options.h"
#include "sim/session/options/lists.h"

namespace csgsim::studies {

/// Names of strategies, colourings and similar choices.
template <class Choices>
std::vector<std::string> names_of(const Choices& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto choice : choices) names.emplace_back(emit::name_of(choice));
  return names;
}

/// Names without `auto`, which chooses by the available memory.
template <class Choices>
std::vector<std::string> fixed_names_of(const Choices& choices) {
  std::vector<std::string> names;
  for (const auto choice : choices) {
    if (choice != Choices::value_type::automatic) names.emplace_back(emit::name_of(choice));
  }
  return names;
}

/// Removes duplicates and keeps the order.
std::vector<std::string> without_duplicates(const std::vector<std::string>& names);

/// Parses faceting tolerances in model units, separated by commas. Throws UsageError for a word that is not a
/// number, and InputError for a number that is not positive.
std::vector<double> parse_tolerances(const std::string& text);

/// Whether --stack-bits affects the strategy with this name.
bool has_stack_bits(std::string_view strategy_name);

}  // namespace csgsim::studies
