// Fragments of the boundary.
// Used by boundary.cpp, division.h and exact_outlines.h.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/csg/positive_tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/planes/sheet.h"

namespace csgsim::software::convert {

/// A corner of a fragment.
struct FragmentCorner {
  Triple planes{};                   ///< three planes that contain it
  std::uint32_t along = 0;           ///< plane of the side to the next corner, other than the fragment's
  std::uint32_t vertex = no_vertex;  ///< vertex of the body that the corner represents
};

/// A convex part of the boundary. The corners run counter-clockwise as seen from outside of the solid.
struct Fragment {
  std::uint32_t plane = 0;
  bool is_front = true;  ///< whether the solid is behind the plane; otherwise in front of it
  std::uint32_t body = 0;
  std::vector<FragmentCorner> corners;
};

/// Converts a region of the sheet, whose first corners are those of the face of a body with these sides.
Fragment fragment_of(const Sheet& sheet, const Region& region, bool is_front, std::uint32_t body,
                     std::span<const BodySide> sides);

/// Called with the fragments of one body.
using FragmentSink = std::function<void(std::span<const Fragment>)>;

/// Computes the boundary of the solid exactly, in convex parts that do not overlap, body by body in order; `sink` is
/// called by one thread at a time. A face is divided only by those bodies that intersect it and that affect the tree
/// there; for coplanar faces, the sides behind and in front of the plane are evaluated together. Throws WorkError
/// beyond the work limit. Bodies that are `whole` yield no fragments and must not touch others. The result does not
/// depend on the number of threads.
void find_fragments(const Bodies& bodies, const csg::PositiveTree& tree, const std::vector<bool>& whole,
                    const FragmentSink& sink, const Work& work, unsigned threads = 1);

}  // namespace csgsim::software::convert
