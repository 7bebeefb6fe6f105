// Ordered Boolean lists: active trees as short-circuit code over labels.
// Used by host/emit.
#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::csg {

inline constexpr std::uint32_t no_label = 0xffffffffU;

/// The destination of a pixel after a leaf.
enum class Destination : std::uint8_t {
  leaf,     ///< the next leaf with that label
  visible,  ///< TRUE: past all remaining leaves, waiting with a label that none of them has
  hidden    ///< FALSE: removed from the mask, so that it needs no label
};

struct Target {
  Destination to = Destination::hidden;
  std::uint32_t label = no_label;  ///< the pixel's new label; no_label if hidden

  bool operator==(const Target&) const = default;
};

/// A leaf of the list: pixels in the mask with the label `name` are compared with the primitive.
struct ListLeaf {
  std::uint32_t primitive = model::no_index;
  std::uint32_t name = no_label;
  Target if_in;                          ///< target if in the primitive itself; the targets of complements are swapped
  Target if_out;                         ///< target if outside the primitive itself
  std::uint32_t node = model::no_index;  ///< node of the active tree

  bool operator==(const ListLeaf&) const = default;
};

/// An active tree as an ordered Boolean list (J. Rossignac, "Ordered Boolean List (OBL): Reducing the Footprint for
/// Evaluating Boolean Expressions", IEEE TVCG 17(9), 2011): short-circuit code that examines each leaf once.
///
/// All pixels start in the mask with label 0. At each leaf, the pixels with its label go to `if_in` or `if_out`, and
/// the others wait. After the last leaf, the tree is TRUE at the pixels still in the mask; they have `true_label`.
///
/// A label is reused: it means the next leaf with that label, or TRUE after the last one. If no pixel waits for a
/// leaf's target yet, the target gets the leaf's label, so that the pixels that go there keep theirs; of two such
/// targets, the one examined sooner gets it. The other one gets the free label that differs from it in the fewest bits.
/// Only a leaf with other targets has to rewrite the label of every pixel that stays in the mask.
struct OrderedList {
  std::vector<ListLeaf> leaves;  ///< empty: no pixel leaves the mask
  std::uint32_t true_label = 0;
  std::uint32_t labels = 1;      ///< the labels 0 ... labels - 1 are in use
  std::uint32_t label_bits = 0;  ///< ceil(log2(labels))
};

/// The list with the minimum number of labels over all orders of operands, where FALSE needs none. Operands stay in the
/// tree's order unless another one needs fewer labels. The worst trees of n leaves need ceil(log2(2n/3 + 4/3)) labels
/// (by enumeration up to 11 leaves; not proved). Time is linear in the number of nodes. The tree must not be `nothing`.
OrderedList make_ordered_list(const ActiveTree& active);

/// Maximum number of labels in use at once in the best order, counting TRUE and FALSE from where a pixel can first
/// reach them. The published bound for n > 0 leaves is ceil(log2(2n/3 + 2)). The tree must not be `nothing`.
std::uint32_t footprint(const ActiveTree& active);

}  // namespace csgsim::csg
