#include "hw/division/divide.h"

#include <cstddef>
#include <span>

#include "hw/division/active_tree.h"
#include "hw/division/classification.h"
#include "hw/division/rendering.h"
#include "hw/division/surfaces.h"
#include "hw/division/writer.h"

namespace csgsim::division {

namespace {

using isa::Opcode;

void write_setup(Writer& out, const ModelHeader& model) {
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  out.plain(Opcode::enable_all);
  out.set(model.fields.depth, static_cast<std::uint64_t>(model.farthest()));
  out.set(model.fields.colour, model.background);
}

/// Writes a surface where it is nearer than Z2 and inside its active tree. The depth test precedes the classification.
void write_visible(Writer& out, Datapath& path, const Surface& surface, const ActiveTree& active,
                   const Rectangle& square) {
  const Rendering rendering(path, surface);
  if (rendering.is_empty()) return;
  rendering.write_surface(out, square);
  rendering.write_depth_test(out);
  if (!active.operands.empty()) {
    write_classification(out, path, active, surface);
    out.origin = {isa::Purpose::merge, surface.first, isa::no_node};
    out.plain(Opcode::enable_load, path.header().fields.mask);
  }
  rendering.write_merge(out);
}

void write(std::span<const isa::Instruction> instructions, Datapath& path) {
  for (const isa::Instruction& one : instructions) path.write(one);
}

}  // namespace

Counts SquareDivision::counts() const {
  Counts all;
  for (const Counts& step : steps) all += step;
  return all;
}

Divider::Divider(const DisplayModel& model)
    : header_(model.header()), tree_(make_tree(model)), all_(all_candidates(model)) {
  for (const Primitive& one : model.primitives) joined_.push_back(one.joined);
}

SquareDivision Divider::divide(const isa::Region& square, const Candidates& candidates, Datapath& path) const {
  SquareDivision divided;
  const Rectangle pixels = rectangle_of(square);
  Writer out(header_, square);
  write_setup(out, header_);
  const std::size_t setup = out.written().size();
  std::size_t done = 0;
  for (std::uint32_t first = 0, next = 0; first < joined_.size(); first = next) {
    next = first + 1;
    while (next < joined_.size() && joined_[next]) ++next;
    Surface surface = intersect_boxes(path, candidates, first, next - first, pixels);
    if (surface.box.empty()) continue;
    if (test(path, candidates, surface)) {
      const ActiveTree active = find_active_tree(path, tree_, candidates, surface);
      if (!active.is_empty) write_visible(out, path, surface, active, pixels);
    }
    if (out.written().size() > setup) {
      write(std::span(out.written()).subspan(done), path);
      done = out.written().size();
    }
    divided.steps.push_back(path.take_counts());
  }
  const bool is_picture = square == isa::Region{0, 0, header_.width, header_.height};
  if (done == 0 && is_picture) write(out.written(), path);
  if (done > 0 || is_picture) divided.instructions = out.take();
  const Counts rest = path.take_counts();
  if (rest != Counts{}) divided.steps.push_back(rest);
  return divided;
}

DividedGroup divide_group(const Divider& divider, const isa::Region& group, const std::vector<isa::Region>& squares,
                          std::uint64_t list_entries, Datapath& path) {
  DividedGroup divided;
  const Candidates survivors = divider.survivors(group, path);
  divided.group = path.take_counts();
  divided.fits = survivors.entry_count() <= list_entries;
  const Candidates& from = divided.fits ? survivors : divider.all();
  divided.entries = from.entry_count();
  for (const isa::Region& square : squares) divided.squares.push_back(divider.divide(square, from, path));
  return divided;
}

}  // namespace csgsim::division
