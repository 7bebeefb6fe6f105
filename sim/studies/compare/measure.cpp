#include "sim/studies/compare/measure.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "host/emit/compile.h"
#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/machines/area.h"
#include "hw/machines/kind.h"
#include "hw/process/price.h"
#include "hw/process/process.h"
#include "sim/engine/engine.h"
#include "sim/observe/bound.h"
#include "sim/observe/energy.h"
#include "sim/observe/frame.h"
#include "sim/observe/frame_hash.h"
#include "sim/observe/primitive_costs.h"
#include "sim/observe/stats.h"
#include "sim/studies/compare/software.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

void count(const isa::Program& program, const machines::Machine& machine, ComparisonRow& row) {
  row.primitives = program.facts->model.primitives;
  row.halfspaces = program.facts->model.halfspaces;
  row.segments = program.segments.size();
  for (const isa::Segment& segment : program.segments) {
    row.instructions += segment.instructions.size();
    if (!segment.instructions.empty()) ++row.drawn_segments;
  }
  const machines::Resources resources = machine.kind->resources(machine, isa::frame_header(program));
  row.processors = resources.processors;
  row.machine_memory_bits = resources.memory_bits;
  row.pixel_transistors = machines::pixel_transistors(machine, machine.array.memory_bits);
  if (row.pixel_transistors) row.machine_transistors = *row.pixel_transistors * row.processors;
}

/// Energy of a frame in joules: from the account if it states one, otherwise from processors and memory, as in
/// `explore`.
std::optional<double> frame_joules(const isa::Program& program, const machines::Machine& machine,
                                   const engine::RunResult& result, const ComparisonRow& row) {
  if (const std::optional<double> joules = observe::frame_joules(result.account)) return joules;
  // The process of their time: 10 MHz are those of Pixel-planes 4 in nMOS, 40 MHz those of Pixel-planes 5 in CMOS.
  constexpr std::uint64_t max_nmos_hz = 20'000'000;
  static const process::Process nmos = process::load_process("nmos-3um");
  static const process::Process cmos = process::load_process("cmos-1.6um");
  const machines::Resources resources = machine.kind->resources(machine, isa::frame_header(program));
  return process::frame_joules(machine, resources, {row.pixel_operations, 1 / row.frames_per_second},
                               machine.clock_hz > max_nmos_hz ? cmos : nmos);
}

void draw(const isa::Program& program, const machines::Machine& machine, ComparisonRow& row) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  if (result.overflows > 0) throw std::logic_error("a linear expression does not fit its width");
  row.clocks = result.clocks;
  row.simulated_seconds = static_cast<double>(result.clocks) / static_cast<double>(machine.clock_hz);
  row.shown_clocks = result.shown_clocks;
  row.interval_clocks = result.interval_clocks;
  row.host_clocks = result.host_clocks;
  row.host_model_clocks = result.host_model_clocks;
  const machines::FrameRates rates = engine::frame_rates(result, machine);
  row.frames_per_second = rates.hardware;
  row.hosted_frames_per_second = rates.hosted;
  row.pixel_operations = stats.stats().total.pixel_operations;
  row.enabled = stats.stats().total.enabled;
  row.frame_joules = frame_joules(program, machine, result, row);
  row.processor_clocks = row.processors * row.clocks;
  row.utilisation = static_cast<double>(row.enabled) / static_cast<double>(row.processor_clocks);
  if (const std::optional<observe::Bottleneck> bound = observe::find_bottleneck(result, machine)) {
    row.bound_by = bound->part;
    row.bound_share = bound->share;
  }
  const observe::ClockShares shares = observe::clock_shares(program, result, stats.stats());
  row.instruction_clocks = shares.whole;
  row.dearest = costly_primitives(shares);
  const observe::FrameHashes hashes = observe::hashes_of(frame.frame());
  row.picture = hashes.picture;
  row.surfaces = hashes.surfaces;
}

void draw_on_machine(const ComparisonJob& job, const model::Tree& tree, ComparisonRow& row) {
  machines::Machine machine = job.machine;
  machines::set_picture_size(machine, {row.point.width, row.point.height});
  const facet::Geometry scene = facet::make_geometry(tree, faceting_of(row.point));
  const view::View view = view::make_view(scene, tree, job.camera, job.sampling);
  const isa::Program program = emit::compile(tree, scene, view, machine, job.options);
  count(program, machine, row);
  draw(program, machine, row);
}

}  // namespace

facet::Faceting faceting_of(const ComparisonPoint& point) {
  if (point.fragments == 0) return {};
  return {std::nullopt, point.fragments};
}

ComparisonRow measure(const ComparisonJob& job, const model::Tree& tree) {
  return measured_row<ComparisonRow>(job.point, job.inputs, [&](ComparisonRow& row) {
    job.software ? measure_software(job, tree, row) : draw_on_machine(job, tree, row);
  });
}

}  // namespace csgsim::studies
