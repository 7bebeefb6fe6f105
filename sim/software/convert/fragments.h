#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/csg/positive_tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"

namespace csgsim::software::convert {

/// A corner of a fragment.
struct FragmentCorner {
  Triple planes{};      ///< three that it is on
  glm::dvec3 place{0};  ///< in units
};

/// A part of the boundary, convex or all of a polygon of a body. The corners run counter-clockwise as seen from outside
/// of the solid.
struct Fragment {
  std::uint32_t plane = 0;
  bool is_front = true;  ///< the solid is behind the plane, else it is before it
  std::vector<FragmentCorner> corners;
  std::uint32_t body = 0;
  const BodyPolygon* polygon = nullptr;  ///< of the body, if it is all of one: then it has no corners of its own
};

/// The boundary of what a tree leaves of the bodies, exactly, in convex parts that do not overlap. The face of a body
/// is divided by those others alone that meet it and that the tree depends on there; where faces are in one plane, what
/// is behind them and before them is asked at once. A face that lies clearly in or out of all others, as told by a ball
/// about it, is not worked out. Fragments name polygons of the bodies, which have to stay. Throws WorkError past the
/// limit on work. Bodies that are `whole` give none, and have nothing to do with others. The outcome is the same on any
/// number of threads.
std::vector<Fragment> fragments(const Bodies& bodies, const csg::PositiveTree& tree, const std::vector<bool>& whole,
                                const Work& work, unsigned threads = 1);

}  // namespace csgsim::software::convert
