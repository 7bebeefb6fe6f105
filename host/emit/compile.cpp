#include "host/emit/compile.h"

#include <algorithm>
#include <string>
#include <variant>

#include "host/emit/context.h"

namespace csgsim::emit {

namespace {

struct ShapeName {
  std::string operator()(const model::Cube&) const { return "cube"; }
  std::string operator()(const model::Sphere&) const { return "sphere"; }
  std::string operator()(const model::Cylinder&) const { return "cylinder"; }
  std::string operator()(const model::Polyhedron&) const { return "polyhedron"; }
};

std::vector<std::string> primitive_names(const model::Tree& tree) {
  std::vector<std::string> names;
  for (const model::Primitive& primitive : tree.primitives) {
    names.push_back(std::visit(ShapeName{}, primitive.shape) + "@" + std::to_string(primitive.location.line) + ":" +
                    std::to_string(primitive.location.column));
  }
  return names;
}

isa::ModelFacts model_facts(const model::Tree& tree, const facet::Scene& scene) {
  const model::Counts counts = model::count(tree);
  isa::ModelFacts facts{tree.file, counts.primitives, counts.unions, counts.differences, counts.intersections, 0};
  for (const facet::Convex& solid : scene.solids) facts.halfspaces += solid.halfspaces.size();
  return facts;
}

/// What one primitive contributes to a segment.
struct Planned {
  std::uint32_t primitive;
  csg::Block block;
  csg::ActiveTree active;
};

std::vector<Planned> plan(const model::Tree& tree, const csg::Pruner& pruner, isa::Segment& segment,
                          const facet::Scene& scene) {
  std::vector<Planned> planned;
  for (std::uint32_t primitive = 0; primitive < tree.primitives.size(); ++primitive) {
    const csg::Block block = pruner.block_of(primitive);
    if (block.pixels.empty()) continue;
    ++segment.primitives;
    segment.halfspaces += static_cast<std::uint32_t>(scene.solids[primitive].halfspaces.size());
    csg::ActiveTree active = pruner.active_tree(primitive);
    if (!active.nothing) planned.push_back({primitive, block, std::move(active)});
  }
  return planned;
}

void emit_setup(const Context& context, Broadcast& out) {
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  out.plain(isa::Opcode::enable_all);
  out.plain(isa::Opcode::set_constant, context.layout.depth, {}, static_cast<std::uint64_t>(context.farthest()));
  out.plain(isa::Opcode::set_constant, context.layout.colour, {}, effects::pack(effects::background_colour));
}

}  // namespace

std::string_view name_of(Strategy strategy) {
  switch (strategy) {
    case Strategy::stack: return "stack";
  }
  return {};
}

isa::Program compile(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
                     const Options& options) {
  const view::Sampling& sampling = view.sampling;
  isa::Program program;
  program.shape = {sampling.width, sampling.height, options.memory_bits};
  program.primitives = primitive_names(tree);
  program.depth_scale = view.depth;
  program.model = model_facts(tree, scene);

  const csg::PositiveTree positive = csg::make_positive(tree);
  const view::PixelRect screen{0, 0, static_cast<std::int32_t>(sampling.width) - 1,
                               static_cast<std::int32_t>(sampling.height) - 1};
  const csg::Pruner pruner(scene, view, positive, screen);
  isa::Segment segment{{0, 0, sampling.width, sampling.height}, {}, 0, 0};
  const std::vector<Planned> planned = plan(tree, pruner, segment, scene);

  std::uint32_t stack_bits = 0;
  for (const Planned& one : planned) stack_bits = std::max(stack_bits, one.active.bits());
  const Layout layout = plan_layout({sampling.z_bits, effects::colour_bits, stack_bits}, options.memory_bits);
  program.fields = named_fields(layout);

  const Context context{tree, scene, view, positive, layout, options.shading};
  Broadcast out(segment, sampling);
  emit_setup(context, out);
  isa::CompileFacts& facts = program.compile;
  for (const Planned& one : planned) {
    out.origin = {isa::Purpose::render, one.primitive, isa::no_node};
    const Surface surface = emit_surface(context, out, one.primitive, one.block);
    if (surface.nothing) continue;
    ++facts.rendered;
    facts.classified += emit_classification(context, out, one.active, one.block);
    ++facts.depth_tests;
    emit_merge(context, out, one.primitive, surface);
  }
  facts.strategy = name_of(options.strategy);
  facts.effects = {"flat"};
  facts.z_bits = sampling.z_bits;
  facts.fraction_bits = sampling.fraction_bits;
  facts.edge_on_fraction = sampling.edge_on_fraction;
  facts.stack_bits = stack_bits + 1;
  program.segments.push_back(std::move(segment));
  return program;
}

}  // namespace csgsim::emit
