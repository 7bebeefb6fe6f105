#include "hw/division/display_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"

namespace csgsim::division {

namespace {

__extension__ using Wide = __int128;

template <class... Args>
void require(bool holds, fmt::format_string<Args...> message, Args&&... args) {
  if (!holds) throw InputError("the display model: " + fmt::format(message, std::forward<Args>(args)...));
}

void check_sampling(const DisplayModel& model) {
  require(model.width >= 1 && model.width <= isa::max_array_side && model.height >= 1 &&
              model.height <= isa::max_array_side,
          "the picture has {}x{} pixels; each side must be 1 to {}", model.width, model.height, isa::max_array_side);
  require(model.z_bits >= min_z_bits && model.z_bits <= max_z_bits, "depth has {} bits; it must have {} to {}",
          model.z_bits, min_z_bits, max_z_bits);
  require(model.fraction_bits <= max_fraction_bits, "depth has {} fraction bits; it must have 0 to {}",
          model.fraction_bits, max_fraction_bits);
  require(model.colour_bits >= isa::minimum_colour_bits && model.colour_bits <= isa::max_colour_bits,
          "colour has {} bits; it must have {} to {}", model.colour_bits, isa::minimum_colour_bits,
          isa::max_colour_bits);
  require(model.background >> model.colour_bits == 0, "the background does not fit {} bits", model.colour_bits);
}

void check_fields(const DisplayModel& model) {
  const Fields& fields = model.fields;
  const std::array all{fields.depth, fields.candidate, fields.colour, fields.candidate_colour, fields.mask};
  const std::array<unsigned, 5> widths{model.z_bits, model.z_bits, model.colour_bits,
                                       fields.candidate_colour.width > 0 ? model.colour_bits : 0, 1};
  for (std::size_t i = 0; i < all.size(); ++i) {
    require(all[i].width == widths[i], "field {} is {} bits wide instead of {}", i, all[i].width, widths[i]);
    require(all[i].end() <= isa::max_memory_bits, "field {} ends at bit {}, but pixel memory has {} bits", i,
            all[i].end(), isa::max_memory_bits);
    require(all[i].width == 0 || fields.stack_bits == 0 || all[i].end() <= fields.stack_base ||
                fields.stack_base + fields.stack_bits <= all[i].base,
            "field {} overlaps the stack", i);
    for (std::size_t j = 0; j < i; ++j) require(!all[i].overlaps(all[j]), "fields {} and {} overlap", j, i);
  }
  require(fields.stack_base <= isa::max_memory_bits && fields.stack_bits <= isa::max_memory_bits - fields.stack_base,
          "the stack ends beyond the {} bits of pixel memory", isa::max_memory_bits);
}

void check_planes(const DisplayModel& model) {
  const auto magnitude = [](std::int64_t value) { return value < 0 ? -static_cast<Wide>(value) : Wide{value}; };
  for (std::size_t i = 0; i < model.planes.size(); ++i) {
    const Plane& plane = model.planes[i];
    const Wide reach = magnitude(plane.a) * model.width + magnitude(plane.b) * model.height + magnitude(plane.c);
    require(reach < Wide{1} << reach_bits, "plane {} reaches 2^{}", i, reach_bits);
  }
}

void check_primitive(const DisplayModel& model, std::size_t index) {
  const Primitive& one = model.primitives[index];
  const Rectangle& pixels = one.box.pixels;
  require(!pixels.empty() || pixels == Rectangle{}, "primitive {} has an empty rectangle in non-canonical form", index);
  require(pixels.empty() || (pixels.x0 >= 0 && pixels.y0 >= 0 && pixels.x1 < static_cast<std::int32_t>(model.width) &&
                             pixels.y1 < static_cast<std::int32_t>(model.height)),
          "primitive {} extends beyond the picture", index);
  require(one.box.z_low >= 0 && one.box.z_low <= model.farthest() + 1 && one.box.z_high >= -1 &&
              one.box.z_high <= model.farthest(),
          "primitive {} extends beyond the depth range", index);
  require(!one.joined || (index > 0 && !one.complemented && !model.primitives[index - 1].complemented),
          "primitive {} cannot be joined with the previous one", index);
  require(one.near_colour >> model.colour_bits == 0 && (!one.complemented || one.near_colour == 0),
          "primitive {} has an invalid colour at depth 0", index);
  for (const Halfspace& halfspace : one.halfspaces) {
    require(halfspace.plane < model.planes.size(),
            "primitive {} refers to plane {}, but there are {} planes, counted from 0", index, halfspace.plane,
            model.planes.size());
    const bool coloured = is_visible_side(side_of(model.planes[halfspace.plane], halfspace.forward), one.complemented);
    require(halfspace.colour >> model.colour_bits == 0 && (coloured || halfspace.colour == 0),
            "primitive {} has a facet with an invalid colour", index);
  }
}

void check_tree(const DisplayModel& model) {
  std::size_t leaves = 0;
  std::size_t open = 0;  ///< subtrees without an operator
  for (const Node& node : model.nodes) {
    if (node.operands == 0) {
      ++leaves;
    } else {
      require(node.operands >= 2 && node.operands <= open, "an operator has {} operands, but {} subtrees precede it",
              node.operands, open);
      open -= node.operands;
    }
    ++open;
  }
  require(open == (model.nodes.empty() ? 0 : 1), "the nodes form {} trees", open);
  require(leaves == model.primitives.size(), "the tree has {} leaves for {} primitives", leaves,
          model.primitives.size());
}

}  // namespace

void validate(const DisplayModel& model) {
  require(std::max({model.planes.size(), model.primitives.size(), model.nodes.size()}) <= max_records,
          "there are more than {} records of a kind", max_records);
  check_sampling(model);
  check_fields(model);
  check_planes(model);
  for (std::size_t i = 0; i < model.primitives.size(); ++i) check_primitive(model, i);
  check_tree(model);
}

}  // namespace csgsim::division
