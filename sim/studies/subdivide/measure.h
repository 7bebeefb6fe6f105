#pragma once

#include <cstdint>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"

namespace csgsim::studies {

/// A picture cut into squares: what is left to do in each (thesis 7.3.3, 7.4.3). Means are over the squares that
/// something touches.
struct Squares {
  std::uint64_t count = 0;
  std::uint64_t touched = 0;             ///< by the rectangle of pixels of a primitive
  double primitives = 0;                 ///< mean of those that touch a square
  double halfspaces = 0;                 ///< mean of theirs
  double kept_primitives = 0;            ///< mean of those that pruning leaves to be drawn
  double kept_halfspaces = 0;            ///< mean of those that pruning leaves to their surfaces
  double comparisons = 0;                ///< mean, of primitives with Z1
  std::uint64_t clocks = 0;              ///< of the frame, on the machine with renderers as large as the squares
  std::uint64_t instruction_clocks = 0;  ///< of the renderers, in all
};

/// Where the seconds of a frame of a multi-processor go (thesis table 7.3).
struct StageSeconds {
  double transformation = 0;  ///< of half-spaces
  double first_pruning = 0;
  double second_pruning = 0;
  double communication = 0;  ///< the model from the host, broadcasting and sharing
  double rendering = 0;      ///< of it what follows, in proportion to the nodes' clocks at pixels
  double scan_conversion = 0;
  double classification = 0;
  double depth_sort = 0;
  double total = 0;
};

/// A picture drawn by a multi-processor.
struct Stages {
  Squares segments;
  Squares subsegments;
  StageSeconds seconds;
  std::uint64_t halfspace_tests = 0;      ///< of the first pruning, that the machine spends time on
  std::uint64_t halfspaces_touching = 0;  ///< all that there are to test: of the primitives that touch a segment
  double broadcast_halfspaces = 0;        ///< mean, of the segments that are drawn
};

/// What is looked at, and how.
struct Subdivided {
  const model::Tree& tree;
  const facet::Geometry& scene;
  const view::View& view;
  machines::Machine machine;  ///< of kind pixel-square, whose squares are replaced, or multi-processor
  emit::Options options;
};

/// Squares of that many pixels a side. Throws InputError where the model does not fit the machine.
Squares measure_squares(const Subdivided& subdivided, const machines::Size& square);

/// So many binary subdivisions into segments, which the machine's nodes share. Throws InputError as above.
Stages measure_stages(const Subdivided& subdivided, unsigned levels);

}  // namespace csgsim::studies
