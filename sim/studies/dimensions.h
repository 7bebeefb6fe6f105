#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/emit/options.h"
#include "sim/session/options/lists.h"

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

/// Each once, in their order.
std::vector<std::string> different(const std::vector<std::string>& names);

/// Faceting tolerances in model units, with commas between them. Throws InputError or UsageError.
std::vector<double> tolerances_in(const std::string& text);

/// Whether --stack-bits has an effect on the strategy of that name.
bool has_stack_bits(std::string_view name);

}  // namespace csgsim::studies
