#include "sim/studies/design/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/instruction.h"
#include "hw/machines/names.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/prunings.h"
#include "sim/studies/csv.h"
#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

using Texts = std::vector<std::string>;
using session::ModelRequest;

std::string text_of(const std::string& value) { return value; }
std::string text_of(unsigned value) { return std::to_string(value); }
std::string text_of(const std::optional<std::uint32_t>& value) { return value ? std::to_string(*value) : ""; }

/// Title and prefix of an axis in plots.
struct Words {
  std::string_view key;
  const char* title;
  const char* prefix;
  std::string_view default_value{};
};

/// An axis that copies a member of the request to a member of the point.
template <auto option, auto of_point>
constexpr Axis axis(const Words& words, Texts (*values)(const std::string& list)) {
  using Value = std::remove_reference_t<decltype(std::declval<DesignPoint&>().*of_point)>;
  return {words.key,
          words.title,
          words.prefix,
          !std::is_same_v<Value, std::string>,
          words.default_value,
          values,
          [](ModelRequest& options, const std::string& value) { from_cell(value, options.*option); },
          [](const ModelRequest& options, DesignPoint& point) { point.*of_point = options.*option; },
          [](const DesignPoint& point) { return text_of(point.*of_point); }};
}

template <unsigned minimum, unsigned maximum>
Texts parse_number_list(const std::string& list) {
  Texts texts;
  for (const unsigned number : session::parse_numbers(list, minimum, maximum)) texts.push_back(std::to_string(number));
  return texts;
}

constexpr Axis size_axis{
    "size",
    "picture size",
    "",
    false,
    "",
    [](const std::string& value) { return Texts{value}; },
    [](ModelRequest& options, const std::string& value) { options.size = value; },
    [](const ModelRequest& /*options*/, DesignPoint& /*point*/) {},
    [](const DesignPoint& point) { return fmt::format("{}x{}", point.width, point.height); },
};

/// Only strategies with a stack have this value.
constexpr Axis stack_bits_axis{
    "stack-bits",
    "stack bits (m)",
    "m = ",
    true,
    "",
    parse_number_list<emit::min_stack_bits, session::max_stack_bits>,
    [](ModelRequest& options, const std::string& value) { from_cell(value, options.stack_bits); },
    [](const ModelRequest& options, DesignPoint& point) {
      point.stack_bits = has_stack_bits(options.strategy) ? options.stack_bits : 0;
    },
    [](const DesignPoint& point) { return point.stack_bits == 0 ? "" : std::to_string(point.stack_bits); },
};

constexpr std::array all_axes{
    size_axis,
    axis<&ModelRequest::memory_bits, &DesignPoint::memory_bits>({"memory-bits", "memory bits per pixel", "memory "},
                                                                parse_number_list<1, isa::max_memory_bits>),
    axis<&ModelRequest::z_bits, &DesignPoint::z_bits>({"z-bits", "depth bits", "z "},
                                                      parse_number_list<view::min_z_bits, view::max_z_bits>),
    axis<&ModelRequest::fraction_bits, &DesignPoint::fraction_bits>(
        {"fraction-bits", "fraction bits of the coefficients", "fraction "},
        parse_number_list<0, view::max_fraction_bits>),
    axis<&ModelRequest::colour_bits, &DesignPoint::colour_bits>(
        {"colour-bits", "colour bits", "colour "}, parse_number_list<isa::minimum_colour_bits, isa::max_colour_bits>),
    axis<&ModelRequest::strategy, &DesignPoint::strategy>({"strategy", "strategy", ""},
                                                          [](const std::string& list) {
                                                            return session::parse_names(
                                                                list, "strategy", fixed_names_of(emit::strategies));
                                                          }),
    stack_bits_axis,
    axis<&ModelRequest::colouring, &DesignPoint::colouring>({"colouring", "colouring", ""},
                                                            [](const std::string& list) {
                                                              return session::parse_names(
                                                                  list, "colouring", fixed_names_of(emit::colourings));
                                                            }),
    axis<&ModelRequest::curves, &DesignPoint::curves>(
        {"curves", "curved surfaces", "curves ", "auto"},
        [](const std::string& list) { return session::parse_names(list, "way", names_of(emit::curve_choices)); }),
    axis<&ModelRequest::pruning, &DesignPoint::pruning>(
        {"pruning", "pruning", "pruning ", "auto"},
        [](const std::string& list) { return session::parse_prunings(list); }),
};

}  // namespace

std::span<const Axis> axes() { return all_axes; }

const Axis* find_axis(std::string_view key) {
  const auto* const found = std::ranges::find(all_axes, key, &Axis::key);
  return found == all_axes.end() ? nullptr : found;
}

std::vector<std::string> axis_keys() {
  Texts keys;
  for (const Axis& axis : all_axes) keys.emplace_back(axis.key);
  return keys;
}

void put(ModelRequest& request, const std::string& key, const std::string& value) {
  if (const Axis* const axis = find_axis(key)) return axis->put(request, value);
  request.machine += fmt::format("+{}={}", key, value);
}

void set_option(ModelRequest& request, const std::string& key, const std::string& value) {
  const Axis* const axis = find_axis(key);
  if (axis == nullptr) return put(request, key, value);
  const Texts values = axis->values(value);
  if (axis->is_number && values.size() != 1) throw InputError("'" + value + "' is not a single number; give one value");
  axis->put(request, values.front());
}

DesignPoint point_of(const ModelRequest& design, const machines::Size& size) {
  DesignPoint point;
  for (const Axis& axis : all_axes) axis.read(design, point);
  point.model = escaped(design.model);
  point.machine = escaped(design.machine);
  point.memory_bits.reset();
  point.width = size.width;
  point.height = size.height;
  return point;
}

std::string strategy_name(const DesignPoint& point) {
  return has_stack_bits(point.strategy) ? fmt::format("{} {}", point.strategy, point.stack_bits) : point.strategy;
}

std::vector<std::pair<std::string, std::string>> distinguishing_options(const DesignPoint& point) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const std::string& change : machines::changes_of(point.machine)) {
    const std::size_t equals = change.find('=');
    texts.emplace_back(change.substr(0, equals), equals == change.npos ? "" : change.substr(equals + 1));
  }
  for (const Axis& axis : all_axes) texts.emplace_back(axis.key, axis.text(point));
  return texts;
}

std::string shell_option(const std::string& name, const std::string& value) {
  std::string text;
  for (const std::string& word : session::option_words(name, value)) text += " " + shell_word(word);
  return text;
}

std::string render_options(const DesignPoint& point, std::span<const std::string_view> excluded_keys) {
  std::string words;
  std::size_t strategy = std::string::npos;
  for (const Axis& axis : all_axes) {
    const std::string value = axis.text(point);
    if (value.empty() || value == axis.default_value ||
        std::ranges::find(excluded_keys, axis.key) != excluded_keys.end())
      continue;
    if (axis.key == "strategy") strategy = words.size();
    // The strategy precedes the colouring in a point's list, but follows it in a command.
    words.insert(axis.key == "colouring" ? std::min(strategy, words.size()) : words.size(),
                 shell_option(std::string(axis.key), value));
  }
  return words;
}

std::string join_given_options(const session::OptionList& command, const std::vector<std::string>& command_options,
                               const std::vector<std::string>& set_values) {
  std::string words;
  for (const session::GivenOption& option : command.given()) {
    if (option.is_default || std::ranges::find(command_options, option.name) != command_options.end()) continue;
    words += option.value == "true" ? " --" + option.name : shell_option(option.name, option.value);
  }
  for (const std::string& set : set_values) words += shell_option("set", set);
  return words;
}

}  // namespace csgsim::studies
