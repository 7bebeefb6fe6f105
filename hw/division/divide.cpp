#include "hw/division/divide.h"

#include <optional>
#include <utility>

#include "hw/division/active_tree.h"
#include "hw/division/classification.h"
#include "hw/division/rendering.h"
#include "hw/division/surfaces.h"
#include "hw/division/writer.h"

namespace csgsim::division {

namespace {

using isa::Opcode;

void write_setup(Writer& out, const DisplayModel& model) {
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  out.plain(Opcode::enable_all);
  out.set(model.fields.depth, static_cast<std::uint64_t>(model.farthest()));
  out.set(model.fields.colour, model.background);
}

/// A surface where it is nearer than Z2 and inside its active tree. The depth test comes first.
void write_visible(Writer& out, const DisplayModel& model, const Surface& surface, const ActiveTree& active,
                   const Rectangle& square, Counts& counts) {
  const Rendering rendering(model, surface, counts);
  if (rendering.nothing()) return;
  rendering.write_surface(out, square);
  rendering.write_depth_test(out);
  if (!active.operands.empty()) {
    write_classification(out, model, active, surface, counts);
    out.origin = {isa::Purpose::merge, surface.first, isa::no_node};
    out.plain(Opcode::enable_load, model.fields.mask);
  }
  rendering.write_merge(out);
}

}  // namespace

Divider::Divider(DisplayModel model) : model_(std::move(model)), tree_(make_tree(model_)), all_(all_of(model_)) {}

Divided Divider::divide(const isa::Region& square, const Candidates& from) const {
  Divided divided;
  const Rectangle pixels = rectangle_of(square);
  const bool is_picture = square == isa::Region{0, 0, model_.width, model_.height};
  Writer out(model_, square);
  write_setup(out, model_);
  const std::size_t setup = out.written().size();
  divided.counts.boxes = from.primitives.size();
  for (std::uint32_t first = 0, count = 0; first < model_.primitives.size(); first += count) {
    count = joined_from(model_, first);
    Counts counts;
    if (const std::optional<Surface> surface = surface_in(model_, from, first, count, pixels, counts)) {
      const ActiveTree active = active_tree_of(model_, tree_, from, *surface, counts);
      if (!active.nothing) write_visible(out, model_, *surface, active, pixels, counts);
    }
    divided.at_hand.take(counts);
    divided.counts += counts;
  }
  if (out.written().size() > setup || is_picture) divided.instructions = out.take();
  divided.counts.instructions = divided.instructions.size();
  return divided;
}

DividedGroup divide_group(const Divider& divider, const isa::Region& group, const std::vector<isa::Region>& squares,
                          std::uint64_t list_entries) {
  DividedGroup divided;
  const Candidates survivors = divider.survivors(group, divided.group);
  divided.fits = survivors.entries() <= list_entries;
  const Candidates& from = divided.fits ? survivors : divider.all();
  divided.entries = from.entries();
  for (const isa::Region& square : squares) divided.squares.push_back(divider.divide(square, from));
  return divided;
}

}  // namespace csgsim::division
