#include "sim/shell/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "sim/shell/account_summary.h"
#include "sim/shell/numbers.h"

namespace csgsim::shell {

namespace {

/// With three significant digits.
std::string ratio_text(double ratio) {
  return ratio < 100.0 ? fmt::format("{:.3g}", ratio) : fmt::format("{:.0f}", ratio);
}

std::string time_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.1f} us", seconds * 1e6);
  return seconds < 1.0 ? fmt::format("{:.2f} ms", seconds * 1e3) : fmt::format("{:.2f} s", seconds);
}

void print_model(const isa::ModelFacts& model) {
  fmt::print("{:<18}{}, {}; {}, {}, {}\n", "model", counted(model.primitives, "primitive"),
             counted(model.halfspaces, "half-space"), counted(model.unions, "union"),
             counted(model.differences, "difference"), counted(model.intersections, "intersection"));
}

void print_machine(const observe::Report& report) {
  const machines::Machine& machine = report.machine;
  fmt::print("{:<18}{}, {} x {} pixel processors of {} bits at {:g} MHz, {} level\n", "machine", machine.name,
             machine.array.width, machine.array.height, machine.array.memory_bits,
             static_cast<double>(machine.clock_hz) / 1e6, report.level);
  const std::vector<std::string> ideal = machines::idealisations(machine);
  if (!ideal.empty()) fmt::print("{:<18}{}\n", "ideal", fmt::join(ideal, ", "));
}

void print_frame(const observe::Report& report) {
  const auto hz = static_cast<double>(report.machine.clock_hz);
  const engine::RunResult& result = report.result;
  fmt::print("{:<18}shown after {} clocks = {}; the next after {} clocks = {:.4g} frames a second\n", "frame",
             grouped(result.shown_clocks), time_text(static_cast<double>(result.shown_clocks) / hz),
             grouped(result.interval_clocks),
             result.interval_clocks == 0 ? 0.0 : hz / static_cast<double>(result.interval_clocks));
}

void print_purposes(const observe::Report& report) {
  const std::uint64_t whole = report.stats.total.clocks + report.result.latency_clocks;
  fmt::print("\n{:<18}{:>14}{:>9}{:>15}{:>12}\n", "purpose", "clocks", "share", "instructions", "utilisation");
  for (std::size_t i = 0; i < isa::purpose_table.size(); ++i) {
    const observe::Cost& cost = report.stats.by_purpose[i];
    if (cost.instructions == 0) continue;
    fmt::print("  {:<16}{:>14}{:>7.1f} %{:>15}{:>10.1f} %  {}\n", isa::purpose_table[i].name, grouped(cost.clocks),
               percent(cost.clocks, whole), grouped(cost.instructions), percent(cost.enabled, cost.pixel_operations),
               isa::purpose_table[i].meaning);
  }
  if (report.result.latency_clocks == 0) return;
  fmt::print("  {:<16}{:>14}{:>7.1f} %{:>15}{:>12}  {}\n", "latency", grouped(report.result.latency_clocks),
             percent(report.result.latency_clocks, whole), "", "", "until the last instruction reaches the pixels");
}

}  // namespace

void print_summary(const observe::Report& report) {
  const isa::CompileFacts& compile = report.program.facts.compile;
  const observe::Cost& total = report.stats.total;
  const double simulated = static_cast<double>(report.result.clocks) / static_cast<double>(report.machine.clock_hz);
  print_model(report.program.facts.model);
  print_machine(report);
  fmt::print("{:<18}{} = {} at the machine's clock rate\n", "clocks", grouped(report.result.clocks),
             time_text(simulated));
  print_frame(report);
  fmt::print("{:<18}{} carried out, {} skipped\n", "instructions", grouped(total.instructions),
             grouped(report.result.skipped));
  fmt::print("{:<18}{} rendered into Z1, {} classified against Z1, {}\n", "scan-conversions", grouped(compile.rendered),
             grouped(compile.classified), counted(compile.depth_tests, "depth test"));
  fmt::print("{:<18}{} clocks at pixels, {} of them at enabled ones: utilisation {:.2f} %\n", "pixel operations",
             grouped(total.pixel_operations), grouped(total.enabled), percent(total.enabled, total.pixel_operations));
  fmt::print("{:<18}{} of {} bits a pixel, {} of them for the classification\n", "memory",
             observe::used_memory_bits(report.program), report.machine.array.memory_bits, compile.stack_bits);
  print_account(report);
  print_purposes(report);
  const double seconds = std::max(report.wall_seconds, 1e-9);
  const double rate = static_cast<double>(report.result.shown_clocks) / seconds;
  fmt::print("\n{:<18}{} ({} clocks/s, {} x the machine's speed)\n", "simulated in", time_text(report.wall_seconds),
             grouped(static_cast<std::uint64_t>(rate)),
             ratio_text(rate / static_cast<double>(report.machine.clock_hz)));
}

}  // namespace csgsim::shell
