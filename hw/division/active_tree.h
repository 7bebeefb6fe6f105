#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/corners.h"
#include "hw/division/datapath.h"
#include "hw/division/surfaces.h"
#include "hw/division/tree.h"

namespace csgsim::division {

/// A primitive that a surface must be compared with, and its half-spaces, tested at the corners of the pixels that
/// primitive and surface can both occupy.
struct Comparison {
  std::uint32_t primitive = 0;
  Rectangle pixels;
  std::vector<TestedHalfspace> tested;
};

/// A node of an active tree: an operator with at least two operands, or the intersection of some primitives.
struct Term {
  bool is_leaf = false;
  bool complemented = false;  ///< the leaf is the space outside the intersection
  Operator op = Operator::unite;
  std::uint32_t bits = 0;  ///< result bits needed to evaluate the term, including one for its result; 0 for a leaf
  std::vector<Comparison> comparisons;
  std::vector<std::uint32_t> operands;  ///< indices of terms
};

/// Conditions for a surface to be visible: it must be inside every operand of the intersections on the path from it to
/// the root that the corner tests do not decide (thesis 6.2).
struct ActiveTree {
  bool is_empty = false;  ///< the surface is outside everywhere
  std::vector<Term> terms;
  std::vector<std::uint32_t> operands;
};

ActiveTree find_active_tree(Datapath& path, const Tree& tree, const Candidates& candidates, const Surface& surface);

}  // namespace csgsim::division
