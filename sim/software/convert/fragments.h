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
  Triple planes{};                   ///< three that it is on
  std::uint32_t along = 0;           ///< another plane than the fragment's: that of the side to the next corner
  std::uint32_t vertex = no_vertex;  ///< of the body, if the corner stands for one
};

/// A part of the boundary, convex. The corners run counter-clockwise as seen from outside of the solid.
struct Fragment {
  std::uint32_t plane = 0;
  bool is_front = true;  ///< the solid is behind the plane, else it is before it
  std::uint32_t body = 0;
  std::vector<FragmentCorner> corners;
};

/// A region of the sheet, whose first corners are those of the face of a body with those sides.
Fragment fragment_of(const Sheet& sheet, const Region& region, bool is_front, std::uint32_t body,
                     std::span<const BodySide> sides);

/// A function that is given the fragments of one body.
using TakeFragments = std::function<void(std::span<const Fragment>)>;

/// The boundary of what a tree leaves of the bodies, exactly, in convex parts that do not overlap, body by body in
/// their order; one thread at a time calls `take`. The face of a body is divided by those others alone that meet it and
/// that the tree depends on there; where faces are in one plane, what is behind them and before them is asked at once.
/// Throws WorkError past the limit on work. Bodies that are `whole` give none, and have nothing to do with others. The
/// outcome is the same on any number of threads.
void find_fragments(const Bodies& bodies, const csg::PositiveTree& tree, const std::vector<bool>& whole,
                    const TakeFragments& take, const Work& work, unsigned threads = 1);

}  // namespace csgsim::software::convert
