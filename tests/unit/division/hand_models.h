#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hw/division/display_model.h"
#include "hw/division/divide.h"

namespace csgsim::testing {

/// An empty model for 16 x 16 pixels: 4 bits of depth without fraction, 3 of colour, a stack of 2.
inline division::DisplayModel empty_model() {
  division::DisplayModel model;
  model.width = 16;
  model.height = 16;
  model.z_bits = 4;
  model.colour_bits = 3;
  model.background = 6;
  model.fields = {{0, 4}, {4, 4}, {8, 3}, {0, 0}, {11, 1}, 12, 2};
  return model;
}

/// A slab in the left half of the picture with depths in [front, back).
inline division::Primitive slab(std::uint32_t front_plane, std::uint32_t back_plane, std::int64_t front,
                                std::int64_t back) {
  division::Primitive one;
  one.box = {{0, 0, 7, 15}, front, back - 1};
  one.near_colour = 1;
  one.halfspaces = {{front_plane, true, 5}, {back_plane, false, 0}};
  return one;
}

/// A slab with depths in [3, 9).
inline division::DisplayModel one_slab() {
  division::DisplayModel model = empty_model();
  model.planes = {{false, 0, 0, 3}, {false, 0, 0, 9}};
  model.primitives = {slab(0, 1, 3, 9)};
  model.nodes = {{}};
  return model;
}

/// The same slab with a hole: another slab at depths [2, 5) and columns 2 to 5 is subtracted.
inline division::DisplayModel slab_with_hole() {
  division::DisplayModel model = one_slab();
  model.planes.push_back({false, 0, 0, 2});
  model.planes.push_back({false, 0, 0, 5});
  division::Primitive hole = slab(2, 3, 2, 5);
  hole.box.pixels = {2, 0, 5, 15};
  hole.complemented = true;
  hole.near_colour = 0;
  hole.halfspaces[0].colour = 0;
  hole.halfspaces[1].colour = 3;
  model.primitives.push_back(hole);
  model.nodes = {{}, {}, {2, division::Operator::intersect}};
  return model;
}

/// A divider whose reads of the model take no time.
struct ModelDivider {
  explicit ModelDivider(division::DisplayModel given) : model(std::move(given)), divider(model), path(model) {}

  division::SquareDivision divide(const isa::Region& square) { return divider.divide(square, path); }
  division::SquareDivision divide(const isa::Region& square, const division::Candidates& from) {
    return divider.divide(square, from, path);
  }
  division::Candidates survivors(const isa::Region& group) { return divider.survivors(group, path); }
  division::DividedGroup divide_group(const isa::Region& group, const std::vector<isa::Region>& squares,
                                      std::uint64_t list_entries) {
    return division::divide_group(divider, group, squares, list_entries, path);
  }

  division::DisplayModel model;
  division::Divider divider;
  division::PlainDatapath path;
};

}  // namespace csgsim::testing
