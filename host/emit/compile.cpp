#include "host/emit/compile.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <variant>

#include "host/emit/context.h"
#include "host/emit/divided.h"
#include "host/emit/effect.h"
#include "host/emit/evaluation.h"
#include "host/emit/halfspaces.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"

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
  out.plain(isa::Opcode::enable_all);
  out.plain(isa::Opcode::set_constant, context.layout.depth, {}, static_cast<std::uint64_t>(context.farthest()));
  out.plain(isa::Opcode::set_constant, context.layout.colour, {},
            packed_background(context.options.scene, context.options.colour_bits));
}

std::vector<std::string> effect_names(const Options& options) {
  std::vector<std::string> names{"flat"};
  for (const CalledEffect& one : options.effects) names.emplace_back(one.effect->name());
  return names;
}

/// Everything that is compiled from.
struct Input {
  const model::Tree& tree;
  const facet::Scene& scene;
  const view::View& view;
  const Plan& plan;
  const Look& look;
  const machines::Machine& machine;
  std::optional<machines::Division> division;  ///< of the machine
};

/// The instructions that draw one region; none, if nothing can be seen in a part of the picture.
isa::Segment compile_segment(const Context& context, ScanConversions& counts) {
  const SegmentPlan& plan = context.plan;
  isa::Segment segment{plan.region, {}, {plan.active_primitives, plan.active_halfspaces, 0, 0, 0}};
  const view::Sampling& sampling = context.view.sampling;
  const bool is_whole = plan.region == isa::Region{0, 0, sampling.width, sampling.height};
  if (plan.surfaces.empty() && !is_whole) return segment;
  const std::uint64_t classified_before = counts.classified;
  Broadcast out(segment, sampling);
  emit_setup(context, out);
  const std::size_t setup = segment.instructions.size();
  for (const PlannedSurface& one : plan.surfaces) {
    const Sides sides = deciding_sides(context, one);
    emit_primitive(context, out, one, sides, counts);
    segment.facts.kept_primitives += static_cast<std::uint32_t>(one.set.size());
    segment.facts.kept_halfspaces += sides.count();
  }
  if (segment.instructions.size() == setup && !is_whole) segment.instructions.clear();
  segment.facts.comparisons = static_cast<std::uint32_t>(counts.classified - classified_before);
  return segment;
}

/// With a strategy and a colouring chosen.
isa::Program compile_as(const Input& input, const Options& options) {
  const view::Sampling& sampling = input.view.sampling;
  const ClassificationBits classification = classification_bits(input.tree, input.plan, options);
  const std::uint32_t memory_bits = input.machine.array.memory_bits;
  const Layout layout = plan_layout({sampling.z_bits, options.colour_bits, options.colouring == Colouring::field,
                                     classification, machines::second_buffer(options.colour_bits, input.machine)},
                                    memory_bits);
  isa::Program program;
  program.shape = {sampling.width, sampling.height, memory_bits};
  program.facts.primitives = primitive_names(input.tree);
  program.facts.depth_scale = input.view.depth;
  program.facts.model = model_facts(input.tree, input.scene);
  program.facts.fields = named_fields(layout);
  program.background = packed_background(options.scene, options.colour_bits);

  ScanConversions counts;
  for (const SegmentPlan& plan : input.plan.segments) {
    program.segments.push_back(compile_segment(
        {input.tree, input.scene, input.view, input.plan.positive, plan, layout, options, input.machine, input.look},
        counts));
  }
  program.facts.compile = {std::string(name_of(options.strategy)),
                           std::string(name_of(options.colouring)),
                           sampling.z_bits,
                           sampling.fraction_bits,
                           sampling.edge_on_fraction,
                           classification.total() + 1,
                           input.plan.depth(),
                           counts.rendered,
                           counts.classified,
                           counts.depth_tests,
                           effect_names(options)};
  return program;
}

/// With what the machine needs to divide the model itself, if it does.
isa::Program compile_for_machine(const Input& input, const Options& options) {
  isa::Program program = compile_as(input, options);
  if (input.division)
    add_division(program, *input.division, input.tree, input.scene, input.view, input.machine, options);
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
    add(Strategy::stack, options.stack_bits);
    add(Strategy::list, options.stack_bits);
    add(Strategy::parallel, options.stack_bits);
    // Levels beyond the tree's change nothing, and many levels change little.
    const unsigned most = fewest_stack_bits + std::min(plan.depth(), most_levels_tried);
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
                     const machines::Machine& machine, const Options& wanted, const ClockCounter& count) {
  const std::optional<machines::Division> division = machines::division(machine);
  const Options options = division ? options_for(*division, wanted) : wanted;
  csg::Pruning pruning = options.pruning;
  // Chapter 6 multiplies the tree of primitives out as it is.
  if (options.strategy == Strategy::products) pruning.sets = false;
  const Plan plan = make_plan(tree, scene, view, machines::regions(machine), pruning);
  const Look look = make_look(options.scene, tree, plan.positive, view.camera);
  const Input input{tree, scene, view, plan, look, machine, division};
  const std::vector<Options> all = candidates(options, plan);
  if (all.size() == 1) return compile_for_machine(input, all.front());
  std::optional<isa::Program> best;
  std::uint64_t fewest = 0;
  std::exception_ptr why_not;
  for (const Options& one : all) {
    try {
      isa::Program program = compile_for_machine(input, one);
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
