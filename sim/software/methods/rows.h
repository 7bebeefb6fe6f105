// Tables of methods, coherences and prunings.
// Used by sim/app and sim/studies.
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

/// Data kept from one point to the next (see the help of coherences()).
enum class Coherent : std::uint8_t { all_points, first_point, one_list, list_structure, joined_lists, csg_buffer };

/// A row of the table of coherences.
struct CoherenceRow {
  Coherent coherence;
  std::string_view name;
  std::string_view help;
  std::string_view source;
};

/// Input of a method.
enum class Takes : std::uint8_t {
  events,     ///< sorted events of rays; combined with a coherence
  intervals,  ///< unsorted intervals of rays
  planes,     ///< intersects rays with primitives itself
};

/// A row of the table of methods.
struct MethodRow {
  std::string_view name;
  std::string_view help;
  std::string_view source;
  Takes takes = Takes::events;
  processors::Compiled compiled = processors::Compiled::general;  ///< compiler whose factor applies to the traversal
  /// Creates the method. With `counts`, it counts operations and is slower. Coherence and pruning apply to methods that
  /// take events only. Throws InputError if the tree has too many levels.
  std::unique_ptr<Method> (*make)(Coherent coherence, const Subject& subject, bool counts) = nullptr;
};

/// All methods in the order of the thesis.
std::span<const MethodRow* const> methods();
std::span<const CoherenceRow> coherences();

/// The names of a table of rows, or of pointers to rows.
template <class Rows>
std::vector<std::string> row_names(const Rows& rows) {
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
  const CoherenceRow* coherence = nullptr;  ///< nullptr if the method takes none
};

/// Parses METHOD or METHOD/COHERENCE; the default coherence is all-points. Throws InputError that lists the valid
/// names.
Choice choice_of(const std::string& text);

/// Name in the form that choice_of parses.
std::string name_of(const Choice& choice);

/// Creates the chosen method (MethodRow::make).
std::unique_ptr<Method> make_method(const Choice& choice, const Subject& subject, bool counts);

/// A row of the table of prunings.
struct PruningRow {
  Pruning pruning;
  std::string_view name;
  std::string_view help;
};
std::span<const PruningRow> prunings();

/// The pruning with this name. Throws InputError that lists the valid names.
Pruning pruning_of(const std::string& name);
/// The tree shape with this name. Throws InputError that lists the valid names.
Shape shape_of(const std::string& name);

}  // namespace csgsim::software
