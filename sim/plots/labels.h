#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

/// A text that is to stand beside a place.
struct LabelWish {
  Pixel at;
  double width = 0;
  double clearance = 4;  ///< pixels from the place to what is drawn there, at most
};

/// What labels keep clear of, and the area that they stay in.
struct Surroundings {
  Box area;
  std::vector<Box> boxes;
  std::vector<Segment> segments;
};

/// Where a label stands.
struct PlacedLabel {
  std::size_t wish = 0;  ///< number of the wish
  Box box;
  std::optional<Segment> leader;   ///< from the place to the box, where the box is not beside it
  std::optional<unsigned> number;  ///< stands for the text, where that has no room: 1, 2, ...
};

/// Places labels one after the other: beside their place if they meet nothing there, at the end of a line a little
/// away if they do; and a number instead of the text where that has no room. Wishes without a label have found no
/// room for their number. No two boxes overlap, none leaves the area or meets what it keeps clear of, and no leader
/// meets a label, another leader, or a box that does not hold its place.
std::vector<PlacedLabel> place_labels(std::span<const LabelWish> wishes, const Surroundings& surroundings);

}  // namespace csgsim::plots
