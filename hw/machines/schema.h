// Schema of machine parameters.
// Used by hw/multi_processor and sim/session.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Schema of one parameter of a machine description: a table with `value`, `unit`, `provenance` and `source`.
struct FigureSchema {
  std::string_view key;
  std::string_view unit;
  std::int64_t least;  ///< minimum value
  std::int64_t most;   ///< maximum value
  std::string_view meaning;
  void (*store)(Machine& machine, std::int64_t value);  ///< stores a value within the range in the machine
  std::int64_t (*load)(const Machine& machine);         ///< returns the stored value
  std::span<const std::string_view> names{};            ///< if not empty, the value is one of these, counted from 0
  std::optional<std::int64_t> ideal{};                  ///< meaning of `value = "ideal"`, if that is allowed
  std::optional<std::int64_t> priced{};                 ///< meaning of `value = "processor"`, if that is allowed
};

/// Value of a parameter for hardware without limit or delay.
inline constexpr std::string_view ideal_value = "ideal";

/// Value in a description of a parameter that Kind::complete() derives from the operation costs of a processor.
inline constexpr std::string_view priced_value = "processor";
/// Number stored for such a parameter until Kind::complete() replaces it.
inline constexpr std::int64_t not_priced = 0xffff'ffff;

/// Returns the schema with the additional value "processor": Kind::complete() then derives the value from the operation
/// costs of a processor.
constexpr FigureSchema or_priced(FigureSchema figure) {
  figure.priced = not_priced;
  return figure;
}

/// Returns the schema with the additional value "ideal", which is stored as `ideal`.
constexpr FigureSchema or_ideal(FigureSchema figure, std::int64_t ideal) {
  figure.ideal = ideal;
  return figure;
}

/// Returns the schema with values written as one of `names`, which are counted from 0.
constexpr FigureSchema with_names(FigureSchema figure, std::span<const std::string_view> names) {
  figure.names = names;
  return figure;
}

inline constexpr std::int64_t max_parameter_clocks = 1'000'000;  ///< maximum of parameters in clocks

/// Schema of a parameter that is stored in a member of Machine, or in a member of a member.
template <auto... members>
constexpr FigureSchema figure(std::string_view key, std::string_view unit, std::int64_t least, std::int64_t most,
                              std::string_view meaning) {
  return {key,
          unit,
          least,
          most,
          meaning,
          [](Machine& machine, std::int64_t value) {
            auto& member = (machine.*....*members);
            member = static_cast<std::remove_reference_t<decltype(member)>>(value);
          },
          [](const Machine& machine) { return static_cast<std::int64_t>((machine.*....*members)); }};
}

/// Schema of a parameter that only one kind has, stored in a member of its Figures, or in a member of a member.
template <class Figures, auto... members>
constexpr FigureSchema own_figure(std::string_view key, std::string_view unit, std::int64_t least, std::int64_t most,
                                  std::string_view meaning, std::span<const std::string_view> names = {}) {
  return {
      key,
      unit,
      least,
      most,
      meaning,
      [](Machine& machine, std::int64_t value) {
        auto& stored = (kind_figures<Figures>(machine).*....*members);
        stored = static_cast<std::remove_reference_t<decltype(stored)>>(value);
      },
      [](const Machine& machine) { return static_cast<std::int64_t>((kind_figures<Figures>(machine).*....*members)); },
      names};
}

/// Schema of a parameter whose single possible value is built into the simulator.
constexpr FigureSchema built_in_figure(std::string_view key, std::string_view unit, std::int64_t value,
                                       std::string_view meaning) {
  return {key,
          unit,
          value,
          value,
          meaning,
          [](Machine& /*machine*/, std::int64_t /*value*/) {},
          [](const Machine& /*machine*/) { return std::int64_t{0}; }};
}

}  // namespace csgsim::machines
