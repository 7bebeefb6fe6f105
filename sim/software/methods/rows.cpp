#include "sim/software/methods/rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/nearest.h"

namespace csgsim::software {

namespace {

constexpr std::array coherence_rows{
    CoherenceRow{Coherent::all_points, "all-points", "evaluates every point", "Jansen 1987, 4.3"},
    CoherenceRow{Coherent::first_point, "first-point", "looks up the first point of a ray", "Jansen 1987, 4.5.1"},
    CoherenceRow{Coherent::one_list, "one-list", "reuses the list of the previous ray", "Jansen 1987, 4.5.2"},
    CoherenceRow{Coherent::list_structure, "list-structure", "keeps all sequences as a tree", "Jansen 1987, 4.5.3"},
    CoherenceRow{Coherent::joined_lists, "joined-lists",
                 "list-structure with branches merged if the same primitives are active",
                 "Jansen 1987, 4.5.3, proposed"},
    CoherenceRow{Coherent::csg_buffer, "csg-buffer", "keeps a pointer into the tree of sequences for each pixel",
                 "Jansen 1987, 4.5.4, algorithm 4.1"}};

constexpr std::array pruning_rows{
    PruningRow{Pruning::none, "none", "the whole tree"},
    PruningRow{Pruning::cells, "cells",
               "a tree for each cell of 16 x 16 pixels, with the primitives that have pixels in it"},
    PruningRow{Pruning::inside, "inside",
               "while a ray is inside a primitive, the tree of the primitives that intersect it"}};

/// The row with that name; throws InputError if there is none.
template <class Rows>
const auto& found(const Rows& rows, const char* kind, const std::string& name) {
  const std::vector<std::string> names = row_names(rows);
  const auto place = std::ranges::find(names, name);
  if (place == names.end()) throw InputError(unknown_name_text(kind, name, names));
  return rows[static_cast<std::size_t>(place - names.begin())];
}

}  // namespace

std::span<const CoherenceRow> coherences() { return coherence_rows; }

Choice choice_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string method = text.substr(0, slash);
  const MethodRow* const row = found(methods(), "method", method);
  const bool is_crossed = row->takes == Takes::events;
  if (slash == std::string::npos) return {row, is_crossed ? coherence_rows.data() : nullptr};
  if (!is_crossed)
    throw InputError("method " + method + " processes whole rays and takes no coherence; remove the coherence");
  return {row, &found(coherence_rows, "coherence", text.substr(slash + 1))};
}

std::string name_of(const Choice& choice) {
  std::string name(choice.method->name);
  if (choice.coherence != nullptr) name += "/" + std::string(choice.coherence->name);
  return name;
}

std::unique_ptr<Method> make_method(const Choice& choice, const Subject& subject, bool counts) {
  const Coherent coherence = choice.coherence == nullptr ? Coherent::all_points : choice.coherence->coherence;
  return choice.method->make(coherence, subject, counts);
}

std::span<const PruningRow> prunings() { return pruning_rows; }

Pruning pruning_of(const std::string& name) { return found(pruning_rows, "reduction", name).pruning; }
Shape shape_of(const std::string& name) { return found(shapes(), "shape", name).shape; }

}  // namespace csgsim::software
