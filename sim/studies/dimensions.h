#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/emit/options.h"
#include "host/view/projection.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/option_list.h"
#include "sim/session/options/read_by.h"

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
  return session::parse_numbers(text, view::fewest_z_bits, view::most_z_bits);
}

inline std::vector<unsigned> stack_bits_of(const std::string& text) {
  return session::parse_numbers(text, emit::fewest_stack_bits, session::most_stack_bits);
}

/// Faceting tolerances in model units, with commas between them. Throws InputError or UsageError.
std::vector<double> tolerances_in(const std::string& text);

/// Whether a strategy has a stack whose bits are chosen.
inline bool has_stack_bits(std::string_view name) { return name == emit::name_of(emit::Strategy::bits); }

/// As `stack`, or `bits 5`.
std::string strategy_name(const std::string& strategy, unsigned stack_bits);

/// Calls use(point) with each strategy in the point; one other than bits once for all stack bits, which are 0 then.
template <class Ranges, class Point, class Use>
void for_each_strategy(const Ranges& ranges, Point point, const Use& use) {
  for (const std::string& strategy : ranges.strategies) {
    point.strategy = strategy;
    for (const unsigned stack_bits : has_stack_bits(strategy) ? ranges.stack_bits : std::vector<unsigned>{0}) {
      point.stack_bits = stack_bits;
      use(point);
    }
  }
}

/// An option whose text `parse` reads, or refuses.
template <class Parse>
void add_list(session::OptionList& command, const std::string& name, std::string& value, const Parse& parse,
              const std::string& help) {
  command.option(name, value, help).check(session::is_read_by(parse));
}

}  // namespace csgsim::studies
