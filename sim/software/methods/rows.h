#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/processors/processor.h"
#include "sim/software/methods/method.h"

namespace csgsim::software {

/// What is kept from one point to the next.
enum class Coherent : std::uint8_t { all_points, first_point, one_list, list_structure, joined_lists, csg_buffer };

/// A row of the table of coherences.
struct CoherenceRow {
  Coherent coherence;
  std::string_view name;
  std::string_view help;
  std::string_view source;
};

/// What a method works on.
enum class Takes : std::uint8_t {
  events,     ///< of rays, in order; crossed with a coherence
  intervals,  ///< of rays, in any order
  planes,     ///< it finds what rays meet by itself
};

/// A row of the table of methods.
struct MethodRow {
  std::string_view name;
  std::string_view help;
  std::string_view source;
  Takes takes = Takes::events;
  processors::Compiled compiled = processors::Compiled::general;  ///< whose compiler's factor its traversal has
  /// `counts`: it tells what it does, and is slower. The coherence and the pruning are those of methods that take
  /// events. Throws InputError for a tree that has too many levels for it.
  std::unique_ptr<Method> (*make)(Coherent coherence, const Subject& subject, bool counts) = nullptr;
};

/// In the order of the thesis.
std::span<const MethodRow* const> methods();
std::span<const CoherenceRow> coherences();

/// The names of a table of rows, or of pointers to rows.
template <class Rows>
std::vector<std::string> names_in(const Rows& rows) {
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const auto& row : rows) {
    if constexpr (requires { row->name; }) {
      names.emplace_back(row->name);
    } else {
      names.emplace_back(row.name);
    }
  }
  return names;
}

/// A method and, if it takes one, its coherence.
struct Choice {
  const MethodRow* method = nullptr;
  const CoherenceRow* coherence = nullptr;  ///< nullptr where it takes none
};

/// METHOD or METHOD/COHERENCE; all-points where a method takes one and none is said. Throws InputError that lists what
/// there is.
Choice choice_of(const std::string& text);

/// As choice_of takes it.
std::string name_of(const Choice& choice);

std::unique_ptr<Method> made(const Choice& choice, const Subject& subject, bool counts);

/// A row of the table of prunings.
struct PruningRow {
  Pruning pruning;
  std::string_view name;
  std::string_view help;
};
std::span<const PruningRow> prunings();

/// By name. Throws InputError that lists what there is.
Pruning pruning_of(const std::string& name);
Shape shape_of(const std::string& name);

}  // namespace csgsim::software
