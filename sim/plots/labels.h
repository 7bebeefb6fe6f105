// Placement of labels next to points without overlap.
// Used by the layout of charts.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

/// A label to be placed next to a point.
struct LabelRequest {
  Pixel at;
  double width = 0;
  double clearance = 4;  ///< maximum distance in pixels from the point to the edge of its mark
};

/// The area that labels must stay in, and the boxes and segments that they must avoid.
struct Surroundings {
  Box area;
  std::vector<Box> boxes;
  std::vector<Segment> segments;
};

/// Position of a label.
struct PlacedLabel {
  std::size_t request = 0;  ///< index of the label's request
  Box box;
  std::optional<Segment> leader;   ///< line from the point to the label, if they are not adjacent
  std::optional<unsigned> number;  ///< replaces the text if the text does not fit: 1, 2, ...
};

/// Places labels one after the other: next to their point, or else at the end of a short leader line, or else as a
/// number in place of the text. Requests that do not fit even as a number are missing from the result. Boxes do not
/// overlap one another, stay in the area and avoid the obstacles; a leader crosses no label, no other leader, and no
/// box except its point's.
std::vector<PlacedLabel> place_labels(std::span<const LabelRequest> requests, const Surroundings& surroundings);

}  // namespace csgsim::plots
