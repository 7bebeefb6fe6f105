#include "host/effects/pane_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/csg/box_index.h"
#include "host/emit/halfspaces.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;

/// The number of the node that each primitive is a piece of.
std::vector<std::uint32_t> node_numbers(const model::Tree& tree) {
  std::vector<std::uint32_t> nodes;
  std::uint32_t node = 0;
  for (const model::Primitive& one : tree.primitives) nodes.push_back(one.continues ? node : ++node);
  return nodes;
}

/// The box slightly enlarged, so that rounding never separates touching pieces.
csg::BoxIndex::Box enlarged_box(const facet::Box& box, std::uint32_t node) {
  constexpr float far = std::numeric_limits<float>::infinity();
  csg::BoxIndex::Box found;
  for (int i = 0; i < 3; ++i) {
    found.low.at(static_cast<std::size_t>(i)) = std::nextafter(static_cast<float>(box.low[i]), -far);
    found.high.at(static_cast<std::size_t>(i)) = std::nextafter(static_cast<float>(box.high[i]), far);
  }
  found.low[3] = found.high[3] = static_cast<float>(node);
  return found;
}

/// Leaves E at 1 where the front of the piece is in front of Z1 and its back is not.
void emit_within(const emit::Context& context, emit::Broadcast& out, std::uint32_t piece, const csg::Block& block) {
  emit_edges(context, out, piece, block);
  // A piece that begins in front of the near plane is entered at depth 0.
  if (block.z_low <= 0) out.surface(Opcode::linear_lt, context.layout.candidate, {0, 0, 0}, block.pixels);
  // deciding_facets() drops half-spaces that contain the whole block. The block starts one step earlier here because
  // the front test is strict.
  const csg::Block before{block.pixels, block.z_low - 1, block.z_high};
  for (const view::Side side : {view::Side::front, view::Side::back}) {
    const Opcode compare = side == view::Side::front ? Opcode::linear_lt : Opcode::linear_ge;
    for (const emit::Facet& facet : emit::deciding_facets(context, {&piece, 1}, side, before).facets)
      out.surface(compare, context.layout.candidate, context.linear_plane(facet.halfspace), block.pixels);
  }
}

}  // namespace

std::vector<std::vector<std::uint32_t>> touching_pieces(const emit::Drawing& drawing, const std::vector<bool>& drawn) {
  const std::vector<std::uint32_t> nodes = node_numbers(*drawing.tree);
  const csg::PositiveTree& positive = drawing.plan.positive;
  std::vector<csg::BoxIndex::Entry> entries;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const bool has_others = (i > 0 && nodes[i - 1] == nodes[i]) || (i + 1 < nodes.size() && nodes[i + 1] == nodes[i]);
    const bool is_piece = has_others && drawn[i] && !positive.nodes[positive.leaf_of[i]].complemented;
    if (is_piece) entries.push_back({enlarged_box(drawing.geometry->solids[i].box, nodes[i]), i});
  }
  std::vector<std::vector<std::uint32_t>> touching(nodes.size());
  const csg::BoxIndex index(entries);
  for (const csg::BoxIndex::Entry& one : entries) {
    std::vector<std::uint32_t>& found = touching[one.number];
    index.meeting(one.box, found);
    std::erase(found, one.number);
  }
  return touching;
}

void emit_outside(const emit::Context& context, emit::Broadcast& out, const emit::PlannedSurface& planned,
                  const std::vector<std::uint32_t>& pieces, isa::Field spare) {
  const csg::Block& block = planned.block;
  for (const std::uint32_t piece : pieces) {
    const view::Extent& extent = context.view.extents[piece];
    const view::PixelRect shared = common(block.pixels, extent.pixels);
    if (extent.empty() || shared.empty()) continue;
    out.origin = {isa::Purpose::stack, planned.primitive(), isa::no_node};
    out.plain(Opcode::enable_store, spare);
    out.origin = {isa::Purpose::classify, planned.primitive(), piece};
    out.clip(shared, block.pixels);
    emit_within(context, out, piece, {shared, block.z_low, block.z_high});
    out.origin = {isa::Purpose::stack, planned.primitive(), isa::no_node};
    out.plain(Opcode::enable_xor, spare);
    ++out.counts.classified;
  }
}

}  // namespace csgsim::effects
