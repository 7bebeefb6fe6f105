#include "host/emit/drawing.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "host/csg/kept_results.h"
#include "host/emit/effect.h"
#include "host/emit/evaluation.h"
#include "host/emit/shading.h"
#include "host/emit/stored.h"
#include "host/emit/strategy.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"

namespace csgsim::emit {

namespace {

/// Tolerance, relative to the model's size, within which a primitive does not reach behind the mirror.
constexpr double behind_mirror = 1e-9;

/// Opacities by primitive; empty if all are opaque.
std::vector<double> opacities(const Look& look, std::span<const EffectRequest> called) {
  const bool any =
      std::any_of(called.begin(), called.end(), [](const EffectRequest& one) { return one.row->sees_through; });
  std::vector<double> all;
  if (!any) return all;
  for (const lighting::Finish& finish : look.finishes) all.push_back(finish.opacity);
  return all;
}

/// Whether no part of the primitive is behind the mirror.
bool is_before(const Drawing& drawing, std::uint32_t primitive) {
  const facet::Geometry& geometry = *drawing.geometry;
  const facet::Plane& plane = geometry.planes.planes()[drawing.reflection->plane];
  const auto value = [&](const glm::dvec3& place) {
    return glm::dot(plane.normal, place - geometry.planes.centre()) + plane.offset;
  };
  const view::EyeSpace space = view::eye_space(drawing.view.camera, drawing.view.sampling);
  const double eye = space.perspective ? value(space.eye) : -glm::dot(plane.normal, space.axes.forward);
  const facet::Convex& solid = geometry.solids[primitive];
  const double slack = behind_mirror * solid.box.diagonal();
  return std::all_of(solid.vertices.begin(), solid.vertices.end(),
                     [&](const glm::dvec3& vertex) { return value(vertex) * (eye < 0 ? -1 : 1) > -slack; });
}

/// Drops surfaces that are outside the mirror's pixels or in front of it.
void drop_unseen(Drawing& drawing) {
  std::vector<bool> before;
  for (std::uint32_t i = 0; i < drawing.geometry->solids.size(); ++i) before.push_back(is_before(drawing, i));
  for (SegmentPlan& segment : drawing.plan.segments) {
    std::erase_if(segment.surfaces, [&](const PlannedSurface& one) {
      return common(one.block.pixels, drawing.reflection->pixels).empty() ||
             std::any_of(one.set.begin(), one.set.end(), [&](std::uint32_t primitive) { return before[primitive]; });
    });
  }
}

}  // namespace

bool is_drawn(const Context& context, const PlannedSurface& planned) {
  if (context.drawn != nullptr) return (*context.drawn)[planned.primitive()];
  for (std::size_t i = 0; i < context.called.size(); ++i) {
    const std::vector<bool>& apart = (*context.states)[i]->apart;
    if (((context.left_out >> i) & 1U) == 0 && !apart.empty() && apart[planned.primitive()]) return false;
  }
  return true;
}

namespace {

/// Plans a drawing whose other members are set, and lets each called effect prepare it.
void plan_and_prepare(Drawing& drawing, const DrawingInputs& inputs, std::shared_ptr<csg::PairTable> pairs) {
  const Options& options = inputs.options;
  csg::Pruning pruning = pruning_of(options);
  drawing.look = make_look(options.scene, *drawing.tree, csg::make_positive_tree(*drawing.tree), drawing.view.camera);
  if (drawing.reflection) {
    drawing.look.lighting = drawing.reflection->lighting;
    // A primitive that hides others may itself be in front of the mirror and not be drawn.
    pruning.hidden = false;
  }
  if (pairs == nullptr && inputs.kept != nullptr) pairs = inputs.kept->pair_table_for(*drawing.geometry);
  // A divider prunes without its host.
  csg::KeptResults* const kept = machines::division(inputs.machine) ? nullptr : inputs.kept;
  drawing.plan = make_plan(*drawing.tree, *drawing.geometry, drawing.view, machines::regions(inputs.machine),
                           {pruning, options.prices, std::move(pairs), kept}, opacities(drawing.look, inputs.called),
                           options.work);
  if (drawing.reflection) drop_unseen(drawing);
  for (const EffectRequest& one : inputs.called) drawing.states.push_back(one.effect->prepared_for(drawing, inputs));
}

}  // namespace

std::shared_ptr<const Drawing> make_drawing(std::shared_ptr<const model::Tree> tree,
                                            std::shared_ptr<const facet::Geometry> geometry, view::View view,
                                            unsigned nesting, const DrawingInputs& inputs,
                                            std::optional<Reflection> reflection,
                                            std::shared_ptr<csg::PairTable> pairs) {
  auto drawing = std::make_shared<Drawing>();
  drawing->tree = std::move(tree);
  drawing->geometry = std::move(geometry);
  drawing->view = std::move(view);
  drawing->nesting = nesting;
  drawing->reflection = std::move(reflection);
  plan_and_prepare(*drawing, inputs, std::move(pairs));
  return drawing;
}

std::shared_ptr<const Drawing> make_sample(const Drawing& drawing, const glm::dvec2& offset,
                                           const DrawingInputs& inputs) {
  view::Sampling sampling = drawing.view.sampling;
  sampling.offset = offset;
  auto sample = std::make_shared<Drawing>();
  sample->tree = drawing.tree;
  sample->geometry = drawing.geometry;
  sample->view = view::make_view(*drawing.geometry, *drawing.tree, drawing.view.camera, sampling);
  sample->nesting = drawing.nesting;
  sample->sampled_from = &drawing;
  plan_and_prepare(*sample, inputs, drawing.plan.pairs);
  return sample;
}

std::vector<const Drawing*> with_inner_drawings(const Drawing& drawing) {
  std::vector<const Drawing*> all{&drawing};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& state : all[i]->states)
      for (const auto& inner : state->drawings) all.push_back(inner.get());
  }
  return all;
}

Context context_for(const Drawing& drawing, const Context& outer) {
  Context inner{
      *drawing.tree, *drawing.geometry, drawing.view,  drawing.plan.positive, drawing.plan.segments[outer.segment],
      outer.layout,  outer.options,     outer.machine, drawing.look};
  inner.segment = outer.segment;
  inner.called = outer.called;
  inner.states = &drawing.states;
  inner.left_out = outer.left_out;
  inner.nesting = drawing.nesting;
  inner.base = outer.base;
  inner.counted = outer.counted;
  inner.known_colours = outer.known_colours;
  return inner;
}

Context with_layout(const Context& context, const Layout& layout) {
  Context other{context.tree, context.geometry, context.view,    context.positive, context.plan,
                layout,       context.options,  context.machine, context.look};
  other.segment = context.segment;
  other.called = context.called;
  other.states = context.states;
  other.left_out = context.left_out;
  other.nesting = context.nesting;
  other.base = context.base;
  other.beyond = context.beyond;
  other.beyond_plane = context.beyond_plane;
  other.drawn = context.drawn;
  other.lights = context.lights;
  other.paint = context.paint;
  other.counted = context.counted;
  other.known_colours = context.known_colours;
  return other;
}

void enable_drawing(const Context& context, Broadcast& out) {
  context.base.width > 0 ? out.plain(isa::Opcode::enable_load, context.base) : out.plain(isa::Opcode::enable_all);
}

void emit_setup(const Context& context, Broadcast& out) {
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  enable_drawing(context, out);
  out.plain(isa::Opcode::set_constant, context.layout.depth, {}, static_cast<std::uint64_t>(context.farthest()));
  out.plain(isa::Opcode::set_constant, context.layout.colour, {},
            packed_background(context.options.scene, context.options.colour_bits));
  if (context.layout.owner.width > 0) out.plain(isa::Opcode::set_constant, context.layout.owner, {}, 0);
}

DrawnCounts emit_surfaces(const Context& outer, Broadcast& out) {
  const StoredDepths stored(outer);
  Context context = outer;
  if (!stored.primitives().empty()) context.stored = &stored;
  emit_stored_depths(context, out);
  DrawnCounts kept;
  for (const PlannedSurface& one : context.plan.surfaces) {
    if (!is_drawn(context, one)) continue;
    const Sides sides = deciding_sides(context, one);
    emit_primitive(context, out, one, sides);
    kept.primitives += static_cast<std::uint32_t>(one.set.size());
    kept.halfspaces += sides.count();
  }
  return kept;
}

void emit_shading(const Context& context, Broadcast& out) {
  if (context.layout.owner.width == 0) return;
  Shadows shadows;
  for_effects(context, out, &Effect::light, shadows);
  for (const PlannedSurface& one : context.plan.surfaces) {
    if (is_drawn(context, one)) emit_visible_colours(context, out, one, shadows);
  }
}

void emit_composition(const Context& context, Broadcast& out) { for_effects(context, out, &Effect::compose); }

DrawnCounts emit_drawing(const Context& context, Broadcast& out) {
  emit_setup(context, out);
  const DrawnCounts kept = emit_surfaces(context, out);
  emit_shading(context, out);
  emit_composition(context, out);
  return kept;
}

DrawnCounts emit_picture(const Context& context, Broadcast& out) {
  DrawnCounts kept;
  bool is_first = true;
  const DrawPicture draw = [&](const Context& one) {
    const DrawnCounts drawn = emit_drawing(one, out);
    if (std::exchange(is_first, false)) kept = drawn;
    for_effects(one, out, &Effect::finish);
  };
  if (!for_effects(context, out, &Effect::draw_around, draw)) draw(context);
  for_effects(context, out, &Effect::enhance);
  return kept;
}

}  // namespace csgsim::emit
