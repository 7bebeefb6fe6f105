#include "sim/observe/stats_json.h"

#include <algorithm>

#include "hw/base/text.h"
#include "hw/machines/clocks.h"
#include "sim/observe/account_json.h"

namespace csgsim::sim {

namespace {

using Json = nlohmann::ordered_json;

Json pixel_operations(const Cost& cost) { return {{"total", cost.pixel_operations}, {"enabled", cost.enabled}}; }

Json cost_json(const Cost& cost) {
  return {{"clocks", cost.clocks}, {"instructions", cost.instructions}, {"pixel_operations", pixel_operations(cost)}};
}

Json model_json(const isa::ModelFacts& model) {
  return {{"file", printable(model.file)},    {"primitives", model.primitives},       {"unions", model.unions},
          {"differences", model.differences}, {"intersections", model.intersections}, {"halfspaces", model.halfspaces}};
}

Json machine_json(const Report& report) {
  const machines::Machine& machine = report.machine;
  const isa::CompileFacts& compile = report.program.compile;
  return {{"name", machine.name},
          {"kind", machines::name_of(machine.kind)},
          {"picture", {{"width", report.program.shape.width}, {"height", report.program.shape.height}}},
          {"width", machine.array.width},
          {"height", machine.array.height},
          {"memory_bits", machine.array.memory_bits},
          {"clock_hz", machine.clock_hz},
          {"memory_reads_per_clock", machine.memory_reads},
          {"alu_bits", machine.alu_bits},
          {"evaluator_latency", machines::evaluator_latency(machine.array)},
          {"z_bits", compile.z_bits},
          {"fraction_bits", compile.fraction_bits},
          {"edge_on_fraction", compile.edge_on_fraction},
          {"colouring", printable(compile.colouring)}};
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
  for (const isa::NamedField& named : report.program.fields) {
    fields.push_back({{"name", printable(named.name)},
                      {"base", named.field.base},
                      {"width", named.field.width},
                      {"role", isa::name_of(named.role)}});
  }
  return {{"available", report.machine.array.memory_bits},
          {"used", used_memory_bits(report.program)},
          {"stack", report.program.compile.stack_bits},
          {"tree_depth", report.program.compile.tree_depth},
          {"fields", fields}};
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

Json primitives_json(const Report& report) {
  Json primitives = Json::array();
  for (std::size_t i = 0; i < report.program.primitives.size(); ++i) {
    Json entry{{"index", i}, {"name", printable(report.program.primitives[i])}};
    entry.update(cost_json(report.stats.by_primitive[i]));
    primitives.push_back(std::move(entry));
  }
  return primitives;
}

/// Bits that the linear expressions are streamed over, on average: fewer where regions are small.
double mean_linear_width(const isa::Program& program) {
  double bits = 0;
  double count = 0;
  for (const isa::Segment& segment : program.segments) {
    for (const isa::Instruction& instruction : segment.instructions) {
      if (instruction.linear.width == 0) continue;
      bits += instruction.linear.width;
      ++count;
    }
  }
  return count == 0 ? 0 : bits / count;
}

Json segments_json(const isa::Program& program) {
  const double count = program.segments.empty() ? 1.0 : static_cast<double>(program.segments.size());
  const auto mean = [&](std::uint32_t isa::Segment::*member) {
    double sum = 0;
    for (const isa::Segment& segment : program.segments) sum += segment.*member;
    return sum / count;
  };
  const auto drawn = std::count_if(program.segments.begin(), program.segments.end(),
                                   [](const isa::Segment& segment) { return !segment.instructions.empty(); });
  return {{"count", program.segments.size()},
          {"drawn", drawn},
          {"primitives_mean", mean(&isa::Segment::primitives)},
          {"halfspaces_mean", mean(&isa::Segment::halfspaces)},
          {"kept_primitives_mean", mean(&isa::Segment::kept_primitives)},
          {"kept_halfspaces_mean", mean(&isa::Segment::kept_halfspaces)},
          {"comparisons_mean", mean(&isa::Segment::comparisons)},
          {"linear_width_mean", mean_linear_width(program)}};
}

}  // namespace

std::uint32_t used_memory_bits(const isa::Program& program) {
  std::uint32_t used = 0;
  for (const isa::NamedField& named : program.fields) used += named.field.width;
  return used;
}

nlohmann::ordered_json to_json(const Report& report) {
  const isa::CompileFacts& compile = report.program.compile;
  Json json;
  json["model"] = model_json(report.program.model);
  json["machine"] = machine_json(report);
  json["level"] = report.level;
  json["strategy"] = printable(compile.strategy);
  json["clocks"] = report.result.clocks;
  json["simulated_seconds"] = static_cast<double>(report.result.clocks) / static_cast<double>(report.machine.clock_hz);
  json["instructions"] = instructions_json(report);
  json["pixel_operations"] = pixel_operations(report.stats.total);
  json["scan_conversions"] = {{"rendered", compile.rendered}, {"classified", compile.classified}};
  json["depth_tests"] = compile.depth_tests;
  json["memory_bits"] = memory_json(report);
  json["by_purpose"] = purposes_json(report);
  json["by_primitive"] = primitives_json(report);
  json["segments"] = segments_json(report.program);
  if (report.machine.kind != machines::Kind::frame_buffer) json["account"] = account_json(report);
  json["effects"] = Json::array();
  for (const std::string& effect : compile.effects) json["effects"].push_back(printable(effect));
  json["wall_seconds"] = report.wall_seconds;
  return json;
}

}  // namespace csgsim::sim
