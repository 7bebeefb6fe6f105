#include "sim/studies/corpus/measure.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "sim/engine/engine.h"
#include "sim/observe/bound.h"
#include "sim/observe/frame.h"
#include "sim/observe/frame_hash.h"
#include "sim/observe/stats_json.h"

namespace csgsim::studies {

namespace {

constexpr auto columns = std::to_array<CorpusColumn>({
    {"primitives", "primitives", [](const CorpusRow& row) { return static_cast<double>(row.primitives); }},
    {"pieces", "pieces", [](const CorpusRow& row) { return static_cast<double>(row.pieces); }},
    {"halfspaces", "half-spaces", [](const CorpusRow& row) { return static_cast<double>(row.halfspaces); }},
    {"clocks", "clocks", [](const CorpusRow& row) { return static_cast<double>(row.clocks); }},
    {"render", "render clocks", [](const CorpusRow& row) { return static_cast<double>(row.render); }},
    {"classify", "classify clocks", [](const CorpusRow& row) { return static_cast<double>(row.classify); }},
    {"merge", "merge clocks", [](const CorpusRow& row) { return static_cast<double>(row.merge); }},
    {"shade", "shade clocks", [](const CorpusRow& row) { return static_cast<double>(row.shade); }},
    {"pixel_operations", "pixel operations",
     [](const CorpusRow& row) { return static_cast<double>(row.pixel_operations); }},
    {"used_bits", "memory bits", [](const CorpusRow& row) { return static_cast<double>(row.used_bits); }, false},
    {"frames_per_second", "frames/s", [](const CorpusRow& row) { return row.frames_per_second; }, false},
});

void count(const isa::Program& program, CorpusRow& row) {
  row.primitives = program.facts->model.primitives;
  row.pieces = isa::piece_count(*program.facts);
  row.halfspaces = program.facts->model.halfspaces;
  row.used_bits = observe::used_memory_bits(program);
}

void count(const observe::Stats& stats, CorpusRow& row) {
  const auto clocks = [&](isa::Purpose purpose) {
    return stats.by_purpose.at(static_cast<std::size_t>(purpose)).clocks;
  };
  row.setup = clocks(isa::Purpose::setup);
  row.render = clocks(isa::Purpose::render);
  row.classify = clocks(isa::Purpose::classify);
  row.stack = clocks(isa::Purpose::stack);
  row.merge = clocks(isa::Purpose::merge);
  row.shade = clocks(isa::Purpose::shade);
  row.effect = clocks(isa::Purpose::effect);
  row.instructions = stats.total.instructions;
  row.pixel_operations = stats.total.pixel_operations;
  row.enabled = stats.total.enabled;
}

void draw(const isa::Program& program, const machines::Machine& machine, CorpusRow& row) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  if (result.overflows > 0) throw std::logic_error("a linear expression does not fit its width");
  count(stats.stats(), row);
  row.clocks = result.clocks;
  row.interval_clocks = result.interval_clocks;
  row.latency = result.latency_clocks;
  row.frames_per_second = engine::frame_rates(result, machine).hardware;
  if (const std::optional<observe::Bottleneck> bound = observe::find_bottleneck(result, machine))
    row.bound_by = bound->part;
  row.picture = hash_of(frame.frame());
}

CorpusRow make_row(const CorpusPoint& point, const Job& job) {
  CorpusRow row;
  row.point = point;
  row.inputs = job.inputs;
  row.width = job.sampling.width;
  row.height = job.sampling.height;
  row.reason = job.reason;
  return row;
}

}  // namespace

CorpusRow measure(const CorpusPoint& point, const Job& job) {
  CorpusRow row = make_row(point, job);
  if (!row.is_drawn()) return row;
  try {
    const isa::Program program = compile(job);
    count(program, row);
    draw(program, job.machine, row);
  } catch (const InputError& error) {
    row = make_row(point, job);
    row.reason = escaped(error.what());
  }
  return row;
}

std::span<const CorpusColumn> corpus_columns() { return columns; }

Distribution distribution_of(std::span<const CorpusRow> rows, const std::string& machine, const CorpusColumn& column) {
  std::vector<double> values;
  for (const CorpusRow& row : rows) {
    if (row.is_drawn() && row.point.machine == machine) values.push_back(column.value(row));
  }
  return distribution_of(std::move(values));
}

}  // namespace csgsim::studies
