#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::csg {

inline constexpr std::uint32_t no_label = 0xffffffffU;

/// Where a pixel goes from a leaf.
enum class Destination : std::uint8_t {
  leaf,     ///< on to the next leaf that bears the label
  visible,  ///< TRUE: past all leaves that are left; waits with a label that none of them bears
  hidden    ///< FALSE: out of the mask, so that it needs no label
};

struct Target {
  Destination to = Destination::hidden;
  std::uint32_t label = no_label;  ///< the pixel's new label; no_label if hidden

  bool operator==(const Target&) const = default;
};

/// A leaf of the list: the pixels that are in the mask and hold the label `name` are compared with the primitive.
struct ListLeaf {
  std::uint32_t primitive = model::no_index;
  std::uint32_t name = no_label;
  Target if_in;                          ///< in the primitive itself: complements have their targets swapped
  Target if_out;                         ///< out of the primitive itself
  std::uint32_t node = model::no_index;  ///< of the active tree

  bool operator==(const ListLeaf&) const = default;
};

/// An active tree as an ordered Boolean list (J. Rossignac, "Ordered Boolean List (OBL): Reducing the Footprint for
/// Evaluating Boolean Expressions", IEEE TVCG 17(9), 2011): short-circuit code that looks at each leaf once.
///
/// All pixels start in the mask and with label 0. At each leaf those that hold its name go to `if_in` or `if_out`, and
/// the others wait. After the last leaf the pixels still in the mask are the visible ones; all of them hold
/// `true_label`.
///
/// A label names several things one after another, so it is no index: it means the next leaf that bears it, or TRUE
/// after the last of these. A leaf with a target that no pixel waits for yet gives that target its own name, so that
/// the pixels that go there keep their label; of two such targets it is the one looked at sooner. The other one gets,
/// of the labels that are free, the one that differs from the name in the fewest bits. A leaf with other targets only
/// has to rewrite the label of every pixel that stays in the mask.
struct OrderedList {
  std::vector<ListLeaf> leaves;  ///< empty: visible at once
  std::uint32_t true_label = 0;
  std::uint32_t labels = 1;      ///< 0 ... labels - 1 are in use
  std::uint32_t label_bits = 0;  ///< ceil(log2(labels))
};

/// The list with the fewest labels, FALSE having none, that any order of operands has. An operator's operands stay in
/// the tree's order where no other one needs fewer. The worst trees of n leaves need ceil(log2(2n/3 + 4/3)) labels (by
/// enumeration up to 11 leaves; not proved). Time is linear in the nodes. Not for a tree of `nothing`.
OrderedList make_ordered_list(const ActiveTree& active);

/// Labels alive at once, at most, in the order that has the fewest, with TRUE and FALSE counted from where a pixel can
/// first be there. The published bound for n > 0 leaves is ceil(log2(2n/3 + 2)). Not for a tree of `nothing`.
std::uint32_t footprint(const ActiveTree& active);

}  // namespace csgsim::csg
