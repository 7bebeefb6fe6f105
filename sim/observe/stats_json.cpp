#include "sim/observe/stats_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"
#include "sim/observe/account_json.h"
#include "sim/observe/bound.h"
#include "sim/observe/energy.h"
#include "sim/observe/primitive_costs.h"

namespace csgsim::observe {

namespace {

using Json = nlohmann::ordered_json;

Json pixel_operations(const Cost& cost) { return {{"total", cost.pixel_operations}, {"enabled", cost.enabled}}; }

Json cost_json(const Cost& cost) {
  return {{"clocks", cost.clocks}, {"instructions", cost.instructions}, {"pixel_operations", pixel_operations(cost)}};
}

Json model_json(const isa::Facts& facts) {
  const isa::ModelFacts& model = facts.model;
  return {{"file", printable(model.file)}, {"primitives", model.primitives},   {"pieces", isa::piece_count(facts)},
          {"unions", model.unions},        {"differences", model.differences}, {"intersections", model.intersections},
          {"halfspaces", model.halfspaces}};
}

Json machine_json(const Report& report) {
  const machines::Machine& machine = report.machine;
  const isa::CompileFacts& compile = report.program.facts->compile;
  return {{"name", machine.name},
          {"kind", machine.kind->name},
          {"picture", {{"width", report.program.shape.width}, {"height", report.program.shape.height}}},
          {"width", machine.array.width},
          {"height", machine.array.height},
          {"memory_bits", machine.array.memory_bits},
          {"clock_hz", machine.clock_hz},
          {"ideal", machines::ideal_parameters(machine)},
          {"memory_reads_per_clock", machine.memory_reads},
          {"alu_bits", machine.alu_bits},
          {"evaluator_latency", machines::evaluator_latency(machine)},
          {"z_bits", compile.z_bits},
          {"fraction_bits", compile.fraction_bits},
          {"edge_on_fraction", compile.edge_on_fraction},
          {"colouring_used", printable(compile.colouring)}};
}

Json instructions_json(const Report& report) {
  const Stats& stats = report.stats;
  Json by_name = Json::object();
  for (const isa::OpcodeInfo& row : isa::opcode_table) {
    const Cost& cost = stats.by_opcode[static_cast<std::size_t>(row.opcode)];
    if (cost.instructions > 0) by_name[std::string(row.name)] = {{"count", cost.instructions}, {"clocks", cost.clocks}};
  }
  return {{"total", stats.total.instructions}, {"skipped", report.result.skipped}, {"by_name", by_name}};
}

Json memory_json(const Report& report) {
  Json fields = Json::array();
  for (const isa::NamedField& named : report.program.facts->fields) {
    fields.push_back({{"name", printable(named.name)},
                      {"base", named.field.base},
                      {"width", named.field.width},
                      {"role", isa::name_of(named.role)}});
  }
  return {{"memory_bits", report.machine.array.memory_bits},
          {"used_bits", used_memory_bits(report.program)},
          {"classification_bits", report.program.facts->compile.stack_bits},
          {"tree_depth", report.program.facts->compile.tree_depth},
          {"memory_map", fields}};
}

Json purposes_json(const Report& report) {
  Json purposes = Json::object();
  for (std::size_t i = 0; i < isa::purpose_table.size(); ++i) {
    const Cost& cost = report.stats.by_purpose[i];
    if (cost.instructions > 0) purposes[std::string(isa::purpose_table[i].name)] = cost_json(cost);
  }
  purposes["latency"] = cost_json({0, report.result.latency_clocks, 0, 0});
  return purposes;
}

Json effects_json(const Report& report) {
  const std::vector<std::string>& names = report.program.facts->compile.effects;
  Json effects = Json::object();
  effects["none"] = cost_json(report.stats.by_effect.back());
  for (std::size_t i = 0; i < names.size(); ++i) effects[printable(names[i])] = cost_json(report.stats.by_effect[i]);
  return effects;
}

Json primitives_json(const Report& report) {
  Json primitives = Json::array();
  const isa::Facts& facts = *report.program.facts;
  for (std::uint32_t i = 0; i < facts.primitives.size(); ++i) {
    Json entry{{"index", i}, {"name", printable(facts.primitives[i])}, {"pieces", isa::pieces_of(facts, i).count}};
    entry.update(cost_json(report.stats.by_primitive[i]));
    primitives.push_back(std::move(entry));
  }
  return primitives;
}

/// Mean number of streamed bits of linear expressions; smaller regions need fewer.
double mean_linear_width(const isa::Program& program) {
  double bits = 0;
  double count = 0;
  for (const isa::Segment& segment : program.segments) {
    for (const isa::Instruction& instruction : segment.instructions) {
      if (!isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear)) continue;
      bits += instruction.linear.width;
      ++count;
    }
  }
  return count == 0 ? 0 : bits / count;
}

Json segments_json(const isa::Program& program) {
  const double count = program.segments.empty() ? 1.0 : static_cast<double>(program.segments.size());
  const auto mean = [&](std::uint32_t isa::SegmentFacts::*member) {
    double sum = 0;
    for (const isa::Segment& segment : program.segments) sum += (*segment.facts).*member;
    return sum / count;
  };
  const auto drawn = std::count_if(program.segments.begin(), program.segments.end(),
                                   [](const isa::Segment& segment) { return !segment.instructions.empty(); });
  return {{"count", program.segments.size()},
          {"drawn", drawn},
          {"primitives_mean", mean(&isa::SegmentFacts::primitives)},
          {"halfspaces_mean", mean(&isa::SegmentFacts::halfspaces)},
          {"kept_primitives_mean", mean(&isa::SegmentFacts::kept_primitives)},
          {"kept_halfspaces_mean", mean(&isa::SegmentFacts::kept_halfspaces)},
          {"comparisons_mean", mean(&isa::SegmentFacts::comparisons)},
          {"linear_width_mean", mean_linear_width(program)}};
}

/// What each pruning did, by its name.
Json prunings_json(const isa::Program& program) {
  Json json = Json::object();
  for (const isa::PruningFacts& pruning : program.facts->prunings) {
    json[printable(pruning.name)] = {{"tried", pruning.tried},
                                     {"decided", pruning.decided},
                                     {"left", pruning.left},
                                     {"saved_instructions", pruning.saved},
                                     {"host_nanoseconds", pruning.nanoseconds}};
  }
  return json;
}

/// Null if the machine's kind reports no units.
Json bound_json(const Report& report) {
  const std::optional<Bottleneck> bound = find_bottleneck(report.result, report.machine);
  if (!bound) return {};
  return {{"part", bound->part}, {"share", bound->share}, {"by_host", bound->by_host}, {"sentence", bound->sentence}};
}

Json dearest_json(const Report& report) {
  Json dearest = Json::array();
  for (const PrimitiveCost& one : clock_shares(report.program, report.result, report.stats).most_expensive) {
    dearest.push_back({{"primitive", one.primitive},
                       {"name", one.name},
                       {"source", one.source},
                       {"clocks", one.clocks},
                       {"share", one.share},
                       {"pieces", one.pieces},
                       {"halfspaces", one.halfspaces}});
  }
  return dearest;
}

Json knobs_json(std::span<const Knob> knobs) {
  Json json = Json::array();
  for (const Knob& knob : knobs) {
    json.push_back({{"sentence", printable(knob.sentence)},
                    {"option", printable(knob.option)},
                    {"worth", knob.worth},
                    {"clocks_before", knob.before.interval},
                    {"clocks_after", knob.after.interval},
                    {"hosted_clocks_before", knob.before.hosted},
                    {"hosted_clocks_after", knob.after.hosted}});
  }
  return json;
}

}  // namespace

std::uint32_t used_memory_bits(const isa::Program& program) {
  std::uint32_t used = 0;
  for (const isa::NamedField& named : program.facts->fields) used += named.field.width;
  return used;
}

nlohmann::ordered_json to_json(const Report& report) {
  const isa::CompileFacts& compile = report.program.facts->compile;
  Json json;
  json["model"] = model_json(*report.program.facts);
  json["machine"] = machine_json(report);
  json["level"] = report.level;
  json["strategy_used"] = printable(compile.strategy);
  json["clocks"] = report.result.clocks;
  json["shown_clocks"] = report.result.shown_clocks;
  json["interval_clocks"] = report.result.interval_clocks;
  json["host_clocks"] = report.result.host_clocks;
  json["host_model_clocks"] = report.result.host_model_clocks;
  json["frame_seconds"] =
      static_cast<double>(report.result.shown_clocks) / static_cast<double>(report.machine.clock_hz);
  const machines::FrameRates rates = engine::frame_rates(report.result, report.machine);
  json["frames_per_second"] = rates.hardware;
  json["hosted_frames_per_second"] = rates.hosted;
  json["simulated_seconds"] = static_cast<double>(report.result.clocks) / static_cast<double>(report.machine.clock_hz);
  const std::optional<double> joules = frame_joules(report.result.account);
  json["frame_joules"] = joules ? Json(*joules) : Json();
  json["instructions"] = instructions_json(report);
  json["pixel_operations"] = pixel_operations(report.stats.total);
  json["scan_conversions"] = {{"rendered", compile.rendered}, {"classified", compile.classified}};
  json["depth_tests"] = compile.depth_tests;
  json["memory"] = memory_json(report);
  json["by_purpose"] = purposes_json(report);
  json["by_primitive"] = primitives_json(report);
  json["by_effect"] = effects_json(report);
  json["segments"] = segments_json(report.program);
  json["account"] = account_json(report.result.account);
  json["effects"] = Json::array();
  for (const std::string& effect : compile.effects) json["effects"].push_back(printable(effect));
  json["prunings"] = prunings_json(report.program);
  json["bound_by"] = bound_json(report);
  json["dearest"] = dearest_json(report);
  json["knobs"] = knobs_json(report.knobs);
  json["wall_seconds"] = report.wall_seconds;
  return json;
}

}  // namespace csgsim::observe
