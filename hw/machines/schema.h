#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// One key of a machine description: a table with `value`, `unit`, `provenance` and `source`.
struct FigureSchema {
  std::string_view key;
  std::string_view unit;
  std::int64_t least;  ///< of the value
  std::int64_t most;   ///< of the value
  std::string_view meaning;
  void (*store)(Machine& machine, std::int64_t value);  ///< puts a value within range where the simulator looks
  std::int64_t (*load)(const Machine& machine);         ///< from there
  std::span<const std::string_view> names{};            ///< the value is one of these strings, counted from 0
  std::optional<std::int64_t> ideal{};                  ///< what `value = "ideal"` stands for, where it may be said
};

/// As a value: a figure that no hardware limits, at no cost.
inline constexpr std::string_view ideal_value = "ideal";

/// The same figure, which may be ideal.
constexpr FigureSchema or_ideal(FigureSchema figure, std::int64_t ideal) {
  figure.ideal = ideal;
  return figure;
}

/// The same figure, whose values have these names, counted from 0.
constexpr FigureSchema named(FigureSchema figure, std::span<const std::string_view> names) {
  figure.names = names;
  return figure;
}

inline constexpr std::int64_t most_clocks = 1'000'000;  ///< of a figure

/// A figure that stands in a member of the machine, or in a member of one of its parts.
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

/// A figure that only one kind has, a member of its Figures, or of one of their parts.
template <class Figures, auto... members>
constexpr FigureSchema own_figure(std::string_view key, std::string_view unit, std::int64_t least, std::int64_t most,
                                  std::string_view meaning, std::span<const std::string_view> names = {}) {
  return {key,
          unit,
          least,
          most,
          meaning,
          [](Machine& machine, std::int64_t value) {
            auto& stored = (own<Figures>(machine).*....*members);
            stored = static_cast<std::remove_reference_t<decltype(stored)>>(value);
          },
          [](const Machine& machine) { return static_cast<std::int64_t>((own<Figures>(machine).*....*members)); },
          names};
}

/// A figure that can have one value only, which the simulator builds in.
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
