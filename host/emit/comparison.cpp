#include "host/emit/comparison.h"

#include <optional>

#include "host/emit/halfspaces.h"
#include "host/emit/stored.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

void emit_comparison(const Context& context, Broadcast& out, std::uint32_t primitive, const PlannedSurface& surface) {
  out.origin = {isa::Purpose::classify, surface.primitive(), primitive};
  const view::PixelRect shared = common(surface.block.pixels, context.view.extents[primitive].pixels);
  if (shared.empty()) {
    out.disable_all();
    return;
  }
  if (context.stored != nullptr) {
    if (const std::optional<StoredFields> fields = context.stored->of(primitive))
      return emit_stored_comparison(context, out, primitive, *fields, surface);
  }
  out.clip(shared, surface.block.pixels);
  const csg::Block part{shared, surface.block.z_low, surface.block.z_high};
  emit_edges(context, out, primitive, part);
  for (const view::Side side : {view::Side::front, view::Side::back}) {
    for (const Facet& facet : deciding_facets(context, {&primitive, 1}, side, part).facets) {
      out.surface(side == view::Side::front ? isa::Opcode::linear_le : isa::Opcode::linear_gt, context.layout.candidate,
                  context.linear_plane(facet.halfspace), shared);
    }
  }
  for (const QuadricBound& bound : quadric_bounds(context, primitive)) emit_comparison(context, out, bound, part);
}

std::uint32_t emit_comparison(const Context& context, Broadcast& out, const csg::ActiveNode& leaf,
                              const PlannedSurface& surface) {
  emit_comparison(context, out, leaf.primitive, surface);
  for (const std::uint32_t other : leaf.others) emit_comparison(context, out, other, surface);
  return leaf.primitives();
}

std::uint32_t emit_intersection(const Context& context, Broadcast& out, const csg::ActiveNode& leaf,
                                const PlannedSurface& surface, isa::Field bit) {
  emit_stack(out, isa::Opcode::enable_load, bit);
  const std::uint32_t compared = emit_comparison(context, out, leaf, surface);
  if (leaf.complemented) {
    emit_stack(out, isa::Opcode::set_constant, bit, 0);
  } else {
    emit_stack(out, isa::Opcode::enable_store, bit);
  }
  return compared;
}

void emit_stack(Broadcast& out, isa::Opcode opcode, isa::Field field, std::uint64_t constant) {
  out.origin = {isa::Purpose::stack, out.origin.primitive, isa::no_node};
  out.plain(opcode, field, {}, constant);
}

}  // namespace csgsim::emit
