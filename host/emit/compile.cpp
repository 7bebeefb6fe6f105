#include "host/emit/compile.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <variant>

#include "host/emit/context.h"
#include "host/emit/evaluation.h"
#include "hw/isa/error.h"
#include "hw/machines/clocks.h"

namespace csgsim::emit {

namespace {

/// Levels up to which `Strategy::automatic` tries to keep results on a stack.
constexpr std::uint32_t most_levels_tried = 8;

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

void emit_setup(const Context& context, Broadcast& out) {
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  const glm::dvec3& background = effects::background_colour;
  out.plain(isa::Opcode::enable_all);
  out.plain(isa::Opcode::set_constant, context.layout.depth, {}, static_cast<std::uint64_t>(context.farthest()));
  out.plain(isa::Opcode::set_constant, context.layout.colour, {},
            isa::pack_colour({background.r, background.g, background.b}, context.options.colour_bits));
}

/// Everything that is compiled from.
struct Input {
  const model::Tree& tree;
  const facet::Scene& scene;
  const view::View& view;
  const Plan& plan;
  const machines::Machine& machine;
};

/// With a strategy and a colouring chosen.
isa::Program compile_as(const Input& input, const Options& options) {
  const view::Sampling& sampling = input.view.sampling;
  const ClassificationBits classification = classification_bits(input.tree, input.plan, options);
  const std::uint32_t memory_bits = input.machine.array.memory_bits;
  const Layout layout = plan_layout(
      {sampling.z_bits, options.colour_bits, options.colouring == Colouring::field, classification}, memory_bits);
  isa::Program program;
  program.shape = {sampling.width, sampling.height, memory_bits};
  program.primitives = primitive_names(input.tree);
  program.depth_scale = input.view.depth;
  program.model = model_facts(input.tree, input.scene);
  program.fields = named_fields(layout);

  isa::Segment segment{
      {0, 0, sampling.width, sampling.height}, {}, input.plan.active_primitives, input.plan.active_halfspaces};
  Broadcast out(segment, sampling);
  const Context context{input.tree, input.scene, input.view, input.plan, layout, options, input.machine};
  emit_setup(context, out);
  ScanConversions counts;
  std::uint32_t depth = 0;
  for (const Planned& one : input.plan.primitives) {
    emit_primitive(context, out, one, counts);
    depth = std::max(depth, one.active.depth());
  }
  program.compile = {std::string(name_of(options.strategy)),
                     std::string(name_of(options.colouring)),
                     sampling.z_bits,
                     sampling.fraction_bits,
                     sampling.edge_on_fraction,
                     classification.total() + 1,
                     depth,
                     counts.rendered,
                     counts.classified,
                     counts.depth_tests,
                     {"flat"}};
  program.segments.push_back(std::move(segment));
  return program;
}

/// What there is to choose from.
std::vector<Options> candidates(const Options& options, const Plan& plan) {
  std::vector<Options> with_strategy;
  const auto add = [&](Strategy strategy, unsigned stack_bits) {
    with_strategy.push_back(options);
    with_strategy.back().strategy = strategy;
    with_strategy.back().stack_bits = stack_bits;
  };
  if (options.strategy != Strategy::automatic) {
    add(options.strategy, options.stack_bits);
  } else {
    std::uint32_t depth = 0;
    for (const Planned& one : plan.primitives) depth = std::max(depth, one.active.depth());
    add(Strategy::stack, options.stack_bits);
    add(Strategy::list, options.stack_bits);
    // Levels beyond the tree's change nothing, and many levels change little.
    const unsigned most = fewest_stack_bits + std::min(depth, most_levels_tried);
    for (unsigned bits = fewest_stack_bits; bits <= most; ++bits) add(Strategy::bits, bits);
  }
  if (options.colouring != Colouring::automatic) return with_strategy;
  std::vector<Options> all;
  for (const Options& one : with_strategy) {
    for (const Colouring colouring : {Colouring::field, Colouring::rebroadcast}) {
      all.push_back(one);
      all.back().colouring = colouring;
    }
  }
  return all;
}

}  // namespace

isa::Program compile(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
                     const machines::Machine& machine, const Options& options, const ClockCounter& count) {
  const view::PixelRect screen{0, 0, static_cast<std::int32_t>(view.sampling.width) - 1,
                               static_cast<std::int32_t>(view.sampling.height) - 1};
  const Plan plan = make_plan(tree, scene, view, screen, options.pruning);
  const Input input{tree, scene, view, plan, machine};
  const std::vector<Options> all = candidates(options, plan);
  if (all.size() == 1) return compile_as(input, all.front());
  std::optional<isa::Program> best;
  std::uint64_t fewest = 0;
  std::exception_ptr why_not;
  for (const Options& one : all) {
    try {
      isa::Program program = compile_as(input, one);
      const std::uint64_t clocks = count ? count(program) : machines::clocks(program, machine);
      if (!best || clocks < fewest) {
        best = std::move(program);
        fewest = clocks;
      }
    } catch (const InputError&) {
      // The last is the one that asks for the least.
      why_not = std::current_exception();
    }
  }
  if (!best) std::rethrow_exception(why_not);
  return std::move(*best);
}

}  // namespace csgsim::emit
