#include "host/emit/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/emit/context.h"
#include "host/emit/divided.h"
#include "host/emit/drawing.h"
#include "host/emit/effect.h"
#include "host/emit/evaluation.h"
#include "host/emit/facet_colour.h"
#include "host/emit/fast_spheres.h"
#include "host/emit/preparation.h"
#include "host/emit/quadric_depths.h"
#include "host/emit/strategy.h"
#include "host/model/shapes.h"
#include "hw/base/error.h"
#include "hw/base/pages.h"
#include "hw/isa/extents.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/pieces.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"

namespace csgsim::emit {

namespace {

/// Maximum number of stack levels that `Strategy::automatic` tries.
constexpr std::uint32_t max_levels_tried = 8;

std::string name_of(const model::Primitive& primitive) {
  const std::string_view shape = primitive.node.empty() ? model::name_of(primitive.shape) : primitive.node;
  return fmt::format("{}@{}:{}", shape, primitive.location.line, primitive.location.column);
}

/// Names the primitives of the drawing with the most primitives. Drawings of effects may append primitives to the
/// model's.
void name_primitives(const std::vector<const Drawing*>& drawings, isa::Facts& facts) {
  std::vector<std::uint32_t> pieces;
  std::size_t named = 0;
  for (const Drawing* const drawing : drawings) {
    const std::vector<model::Primitive>& all = drawing->tree->primitives;
    for (; named < all.size(); ++named) {
      if (all[named].continues) {
        ++pieces.back();
      } else {
        facts.primitives.push_back(name_of(all[named]));
        pieces.push_back(1);
      }
    }
  }
  isa::set_piece_counts(pieces, facts);
}

isa::ModelFacts model_facts(const model::Tree& tree, const facet::Geometry& geometry) {
  const model::Counts counts = model::count(tree);
  return {tree.file, counts.primitives, counts.unions, counts.differences, counts.intersections, geometry.halfspaces()};
}

std::vector<std::string> effect_names(std::span<const EffectRequest> called) {
  std::vector<std::string> names;
  for (const EffectRequest& one : called) names.emplace_back(one.row->name());
  return names;
}

/// Everything that a Program is compiled from.
struct Input {
  const model::Tree& tree;
  const facet::Geometry& geometry;
  const Drawing& drawing;
  const machines::Machine& machine;
  std::optional<machines::Division> division;  ///< the machine's division of the picture, if it divides the model
  std::span<const EffectRequest> called;
};

/// Reserved instructions per half-space, for drawing it and a few comparisons. Unused capacity takes no physical
/// memory, and reserving avoids the copies of a growing vector.
constexpr std::size_t instructions_per_halfspace = 8;

/// Capacity is reserved from this number of half-spaces on; below, growing the vector is cheap.
constexpr std::size_t many_halfspaces = 10'000;

std::size_t halfspaces_drawn(const Context& context) {
  std::size_t count = 0;
  for (const PlannedSurface& one : context.plan.surfaces)
    for (const std::uint32_t primitive : one.set) count += context.geometry.solids[primitive].halfspaces.size();
  return count;
}

/// Calls `function`. If the work limit is reached, the error names the primitive being drawn.
template <class Function>
auto with_primitive_in_errors(const model::Tree& tree, const Broadcast& out, const Function& function) {
  try {
    return function();
  } catch (const WorkError& error) {
    const std::uint32_t primitive = out.origin.primitive;
    if (primitive >= tree.primitives.size()) throw;
    throw InputError(fmt::format("{}: {}", model::location_text(tree, primitive), error.what()));
  }
}

/// The instructions that draw one region; none if nothing is visible in it and it is only a part of the picture.
isa::Segment compile_segment(Context context, std::span<const Drawing* const> drawings, ScanConversions& counts) {
  const SegmentPlan& plan = context.plan;
  isa::Segment segment{.region = plan.region, .instructions = {}};
  segment.facts->primitives = plan.active_primitives;
  segment.facts->halfspaces = plan.active_halfspaces;
  const view::Sampling& sampling = context.view.sampling;
  const bool is_whole = plan.region == isa::Region{0, 0, sampling.width, sampling.height};
  const bool is_empty = std::all_of(drawings.begin(), drawings.end(), [&](const Drawing* one) {
    return one->plan.segments[context.segment].surfaces.empty();
  });
  for (const Drawing* const one : drawings) *segment.preparation += one->plan.segments[context.segment].preparation;
  if (is_empty && !is_whole) return segment;
  csg::Tested tested;
  for (const Drawing* const one : drawings) tested.add(one->plan.segments[context.segment].tested);
  if (context.segment > 0) tested.follow(drawings.front()->plan.segments[context.segment - 1].tested);
  context.counted = csg::Counted(*segment.preparation, &tested);
  const std::size_t halfspaces = halfspaces_drawn(context);
  if (halfspaces >= many_halfspaces) segment.instructions.reserve(instructions_per_halfspace * halfspaces);
  Broadcast out(segment, sampling, context.options.work);
  out.counted = context.counted;
  if (context.layout.squares.width > 0 && !is_empty) emit_squares(context, out);
  const DrawnCounts kept = with_primitive_in_errors(context.tree, out, [&] { return emit_picture(context, out); });
  segment.facts->kept_primitives = kept.primitives;
  segment.facts->kept_halfspaces = kept.halfspaces;
  const bool draws = std::any_of(segment.instructions.begin(), segment.instructions.end(),
                                 [](const isa::Instruction& one) { return one.origin.purpose != isa::Purpose::setup; });
  if (!draws && !is_whole) segment.instructions.clear();
  segment.facts->comparisons = static_cast<std::uint32_t>(out.counts.classified);
  counts.rendered += out.counts.rendered;
  counts.classified += out.counts.classified;
  counts.depth_tests += out.counts.depth_tests;
  return segment;
}

/// Maximum of the bits that the classifications of the drawings take.
ClassificationBits max_classification_bits(const std::vector<const Drawing*>& drawings, const Options& options) {
  ClassificationBits most;
  for (const Drawing* const one : drawings) most = max_bits(most, classification_bits(*one, options));
  return most;
}

/// Bits of the per-pixel squares for fast spheres of a drawing; 0 if it has none.
unsigned fast_sphere_bits(const Drawing& drawing) {
  unsigned bits = 0;
  if (!drawing.geometry->fast_spheres || drawing.geometry->quadrics.quadrics().empty()) return bits;
  for (const SegmentPlan& segment : drawing.plan.segments) bits = std::max(bits, squares_bits(segment.region));
  return bits;
}

/// Maximum of the bits that the quadrics of the drawings take.
QuadricBits max_quadric_bits(const std::vector<const Drawing*>& drawings, unsigned colour_bits) {
  QuadricBits most;
  for (const Drawing* const one : drawings) {
    const QuadricBits bits = quadric_bits(*one->geometry, one->view, colour_bits);
    most = {std::max(most.root, bits.root), std::max(most.squares, fast_sphere_bits(*one)),
            std::max(most.sum, bits.sum)};
  }
  return most;
}

/// Bits for the number of any surface of a segment.
unsigned owner_bits(const std::vector<const Drawing*>& drawings) {
  std::size_t most = 1;
  for (const Drawing* const one : drawings)
    for (const SegmentPlan& segment : one->plan.segments) most = std::max(most, segment.surfaces.size());
  return static_cast<unsigned>(std::bit_width(most));
}

/// Host work before the first segment: transforming the models of all drawings.
isa::Preparation count_preparation(const std::vector<const Drawing*>& drawings) {
  isa::Preparation all;
  std::map<const facet::Geometry*, DistinctNumbers> distinct;
  for (const Drawing* const one : drawings) {
    const auto [found, is_new] = distinct.try_emplace(one->geometry.get());
    if (is_new) found->second = count_distinct_numbers(*one->geometry);
    all += emit::count_preparation(*one->geometry, one->view, found->second, one->sampled_from != nullptr);
  }
  return all;
}

/// Host work for the model, independent of the camera: its positive form and sets, the planes and numbers that its
/// half-spaces share, and searches of pairs. Drawings of one model share all of it. In a sequence of frames, those
/// after the first only search pairs that no frame before has searched.
isa::Preparation count_model_preparation(const std::vector<const Drawing*>& drawings) {
  isa::Preparation all;
  std::set<const csg::PairTable*> counted;
  for (const Drawing* const one : drawings) {
    if (!counted.insert(one->plan.pairs.get()).second) continue;
    all += one->plan.pairs->work();
    if (!one->plan.pairs->is_in_first_frame()) continue;
    all.nodes += one->plan.positive.nodes.size();
    all += count_sharing_work(*one->geometry);
  }
  return all;
}

/// Statistics of the prunings over all drawings, without prunings that considered no item.
std::vector<isa::PruningFacts> list_prunings(const std::vector<const Drawing*>& drawings) {
  constexpr std::pair<const char*, csg::Tally csg::Tallies::*> named[] = {{"space", &csg::Tallies::space},
                                                                          {"separation", &csg::Tallies::separation},
                                                                          {"halfspaces", &csg::Tallies::halfspaces},
                                                                          {"hidden", &csg::Tallies::hidden}};
  std::vector<isa::PruningFacts> all;
  for (const auto& [name, member] : named) {
    isa::PruningFacts facts{.name = name};
    double saved = 0;
    double nanoseconds = 0;
    for (const Drawing* const one : drawings) {
      const csg::Tally& tally = one->plan.tallies.*member;
      facts.tried += tally.tried;
      facts.decided += tally.decided;
      facts.left += tally.left;
      saved += tally.saved;
      nanoseconds += tally.nanoseconds;
    }
    facts.saved = static_cast<std::uint64_t>(std::llround(saved));
    facts.nanoseconds = static_cast<std::uint64_t>(std::llround(nanoseconds));
    if (facts.tried + facts.left > 0) all.push_back(std::move(facts));
  }
  return all;
}

/// Compiles with a chosen strategy and colouring.
isa::Program compile_as(const Input& input, const Options& options) {
  const Drawing& drawing = input.drawing;
  const view::Sampling& sampling = drawing.view.sampling;
  const std::vector<const Drawing*> drawings = with_inner_drawings(drawing);
  const ClassificationBits classification = max_classification_bits(drawings, options);
  const std::uint32_t memory_bits = input.machine.array.memory_bits;
  const bool has_owners = any_needs_owners(input.called);
  const bool second_colour = options.colouring == Colouring::field && !has_owners;
  const DrawingInputs inputs{input.machine, options, input.called};
  QuadricBits quadrics = max_quadric_bits(drawings, options.colour_bits);
  const bool is_plain = !second_colour && input.called.size() == 1;
  quadrics.in_place = is_plain && quadrics.squares > 0 &&
                      draws_in_place(input.geometry, drawing.view, drawing.plan, options.colour_bits);
  if (quadrics.in_place) quadrics.sum = 0;
  quadrics.root_in_candidate =
      is_plain && quadrics.root > 0 && takes_roots_in_candidate(input.geometry, drawing.view, drawing.plan);
  const Layout layout = plan_layout({sampling.z_bits, options.colour_bits, second_colour, classification,
                                     machines::second_buffer(options.colour_bits, input.machine),
                                     has_owners ? owner_bits(drawings) : 0, effect_fields(drawing, inputs), quadrics},
                                    memory_bits);
  isa::Program program;
  program.machine = machines::machine_record(input.machine);
  program.shape = {sampling.width, sampling.height, memory_bits};
  program.colour = layout.colour;
  name_primitives(drawings, *program.facts);
  program.facts->depth_scale = drawing.view.depth;
  program.facts->model = model_facts(input.tree, input.geometry);
  program.facts->fields = named_fields(layout);
  program.background = packed_background(options.scene, options.colour_bits);

  *program.preparation = count_preparation(drawings);
  KnownColours known_colours;
  ScanConversions counts;
  for (std::size_t i = 0; i < drawing.plan.segments.size(); ++i) {
    Context context{input.tree, input.geometry, drawing.view,  drawing.plan.positive, drawing.plan.segments[i],
                    layout,     options,        input.machine, drawing.look};
    context.segment = i;
    context.called = input.called;
    context.states = &drawing.states;
    context.known_colours = &known_colours;
    program.segments.push_back(compile_segment(context, drawings, counts));
  }
  // Products search pairs while they are emitted.
  *program.model_preparation = count_model_preparation(drawings);
  program.facts->prunings = list_prunings(drawings);
  if (machines::keeps_active_list(input.machine)) program.extents = isa::compute_row_extents(program.segments);
  program.facts->compile = {std::string(name_of(options.strategy)),
                            has_owners ? "deferred" : std::string(name_of(options.colouring)),
                            sampling.z_bits,
                            sampling.fraction_bits,
                            sampling.edge_on_fraction,
                            classification.total() + 1,
                            drawing.plan.depth(),
                            counts.rendered,
                            counts.classified,
                            counts.depth_tests,
                            effect_names(input.called)};
  return program;
}

/// Compiles, and adds the display model if the machine divides the model itself.
isa::Program compile_for_machine(const Input& input, const Options& chosen) {
  Options options = chosen;
  options.work = chosen.work.with_zero_count();
  isa::Program program = compile_as(input, options);
  if (!input.division) return program;
  add_division(program, *input.division, input.tree, input.geometry, input.drawing.view, input.machine, options);
  if (!input.drawing.plan.pairs->is_in_first_frame()) *program.model_preparation = {};
  return program;
}

/// A non-owning shared pointer; the object has to outlive it.
template <class Object>
std::shared_ptr<const Object> borrowed(const Object& object) {
  return {std::shared_ptr<const Object>(), &object};
}

void refuse_effects(std::span<const EffectRequest> called, const machines::Machine& machine) {
  for (const EffectRequest& one : called.subspan(1)) {
    const std::string without = one.row->section.is_list
                                    ? fmt::format("take its tables [[effects.{}]] out of the scene", one.row->name())
                                    : fmt::format("leave the effect out by --set effects.{}.on=false", one.row->name());
    throw InputError(fmt::format(
        "{} divides the model itself, and its divider supports only flat facets, not the effect {}; take a machine "
        "for which the host divides, such as pixel-planes-4, scan-line or pixel-square+divider.kind=host, or {}",
        machine.name, one.row->name(), without));
  }
}

/// The combinations of strategy, stack bits and colouring to choose from.
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
    // Levels beyond the tree's depth change nothing, and many levels change little.
    const unsigned most = min_stack_bits + std::min(plan.depth(), max_levels_tried);
    const auto add_all = [&](bool has_stack_bits, unsigned stack_bits) {
      for (const Strategy strategy : strategies) {
        if (strategy == Strategy::automatic) continue;
        const StrategyRow& row = row_of(strategy);
        if (row.is_tried && row.has_stack_bits == has_stack_bits) add(strategy, stack_bits);
      }
    };
    add_all(false, options.stack_bits);
    for (unsigned bits = min_stack_bits; bits <= most; ++bits) add_all(true, bits);
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

isa::Program compile_within(const model::Tree& tree, const facet::Geometry& geometry, view::View view,
                            const machines::Machine& machine, const Options& wanted, const ClockCounter& count,
                            csg::KeptResults* kept) {
  const std::optional<machines::Division> division = machines::division(machine);
  Options options = with_prices(division ? options_for_division(*division, wanted) : wanted, machine);
  options.work = wanted.work.with_zero_count();
  const std::vector<EffectRequest> called =
      called_effects(options, make_look(options.scene, tree, csg::make_positive_tree(tree), view.camera));
  if (division) refuse_effects(called, machine);
  if (kept != nullptr) kept->begin_program(geometry);
  const auto drawing =
      make_drawing(borrowed(tree), borrowed(geometry), std::move(view), 0, {machine, options, called, kept});
  if (geometry.halfspaces() >= many_halfspaces) release_free_memory();  // frees the memory of temporary solids
  const Input input{tree, geometry, *drawing, machine, division, called};
  const std::vector<Options> all = candidates(options, drawing->plan);
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
      // The last candidate needs the fewest bits, so its error is the most useful one.
      why_not = std::current_exception();
    }
  }
  if (!best) std::rethrow_exception(why_not);
  return std::move(*best);
}

}  // namespace

isa::Program compile(const model::Tree& tree, const facet::Geometry& geometry, view::View view,
                     const machines::Machine& machine, const Options& options, const ClockCounter& count,
                     csg::KeptResults* kept) {
  try {
    return compile_within(tree, geometry, std::move(view), machine, options, count, kept);
  } catch (const WorkError& error) {
    throw InputError(fmt::format("{}: {}", tree.file, error.what()));
  }
}

}  // namespace csgsim::emit
