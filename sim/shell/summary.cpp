#include "sim/shell/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/machines/kind.h"
#include "sim/observe/bound.h"
#include "sim/observe/primitive_costs.h"
#include "sim/session/options/numbers.h"

namespace csgsim::shell {

namespace {

/// Three significant digits, or more for large ratios.
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
  const std::uint64_t next = machines::paced_clocks(result.interval_clocks, result.host_clocks);
  fmt::print("{:<18}shown after {} clocks = {}; the next after {} clocks = {:.4g} frames a second\n", "frame",
             grouped(result.shown_clocks), time_text(static_cast<double>(result.shown_clocks) / hz), grouped(next),
             next == 0 ? 0.0 : hz / static_cast<double>(next));
}

void print_host(const observe::Report& report) {
  const std::uint64_t clocks = report.result.host_clocks;
  if (clocks == 0) return;
  const machines::Host& host = report.machine.host;
  const std::uint32_t count = report.machine.kind->hosts(report.machine);
  const std::string_view name = machines::host_processor_names.at(host.processor);
  fmt::print("{:<18}{}: compiled in {} clocks = {}\n", "host",
             count == 1 ? std::string(name) : fmt::format("{} {} together", count, name), grouped(clocks),
             time_text(static_cast<double>(clocks) / static_cast<double>(report.machine.clock_hz)));
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

/// What each pruning did, and where it was left out.
void print_prunings(const observe::Report& report) {
  for (const isa::PruningFacts& pruning : report.program.facts->prunings) {
    std::string text = fmt::format("tried {}, decided {}", grouped(pruning.tried), grouped(pruning.decided));
    if (pruning.nanoseconds > 0)
      text += fmt::format(" in {:.3g} ms of the host", static_cast<double>(pruning.nanoseconds) / 1e6);
    if (pruning.decided > 0) text += fmt::format(", which saves about {} instructions", grouped(pruning.saved));
    if (pruning.left > 0)
      text += fmt::format("; left out {}, where the host would take longer than half of what it saves",
                          grouped(pruning.left));
    fmt::print("{:<18}{}\n", "pruning " + pruning.name, text);
  }
}

/// Turns waiting_for_host into `wait: host`.
std::string heading(std::string_view activity) {
  constexpr std::string_view waiting = "waiting_for_";
  std::string text(activity.starts_with(waiting) ? activity.substr(waiting.size()) : activity);
  std::replace(text.begin(), text.end(), '_', ' ');
  return activity.starts_with(waiting) ? "wait: " + text : text;
}

bool same_activities(const machines::PartAccount& one, const machines::PartAccount& other) {
  return std::equal(one.clocks.begin(), one.clocks.end(), other.clocks.begin(), other.clocks.end(),
                    [](const auto& a, const auto& b) { return a.activity == b.activity; });
}

void print_heading(const machines::PartAccount& part) {
  fmt::print("\n{:<18}", "part");
  for (const machines::ActivityClocks& one : part.clocks) fmt::print("{:>22}", heading(one.activity));
  fmt::print("\n");
}

void print_part(const machines::PartAccount& part, std::uint64_t frame) {
  fmt::print("  {:<16}", part.part);
  for (const machines::ActivityClocks& one : part.clocks) {
    fmt::print("{:>14}{:>6.1f} %", grouped(one.clocks), 100.0 * machines::Share{{}, one.clocks, frame}.value());
  }
  fmt::print("\n");
}

/// Prints the machine's own account of the frame: counts, shares, and the clocks of each unit by activity.
void print_account(const observe::Report& report) {
  const machines::Account& account = report.result.account;
  if (!account.counts.empty() || !account.shares.empty()) fmt::print("\n");
  for (const machines::Count& count : account.counts)
    fmt::print("{:<26}{:>18}\n", heading(count.name), grouped(count.value));
  for (const machines::Share& share : account.shares) {
    const bool is_mean = share.name == "mean_packets" || share.name == "link_bits_per_instruction";
    fmt::print("{:<26}{:>18}\n", heading(share.name),
               is_mean ? fmt::format("{:.4g}", share.value()) : fmt::format("{:.2f} %", 100.0 * share.value()));
  }
  for (std::size_t i = 0; i < account.parts.size(); ++i) {
    if (i == 0 || !same_activities(account.parts[i - 1], account.parts[i])) print_heading(account.parts[i]);
    print_part(account.parts[i], report.result.clocks);
  }
}

constexpr std::size_t max_printed_knobs = 3;

void print_rest(const std::string& name, std::uint64_t clocks, std::uint64_t whole) {
  if (clocks == 0) return;
  fmt::print("  {:<40}{:>16}{:>7.1f} %\n", name, grouped(clocks), percent(clocks, whole));
}

void print_most_expensive(const observe::Report& report, const observe::Frame& picture) {
  const observe::ClockShares shares = observe::clock_shares(report.program, report.result, report.stats);
  if (shares.whole == 0) return;
  const std::vector<std::uint64_t> pixels = observe::pixels_seen(picture, report.program);
  fmt::print("\n{:<28}{:<14}{:>16}{:>9}{:>9}{:>13}{:>11}\n", "most expensive primitives", "line:column", "clocks",
             "share", "pieces", "half-spaces", "pixels");
  for (const observe::PrimitiveCost& one : shares.dearest) {
    const std::string name = one.name.substr(0, one.source.empty() ? one.name.size() : one.name.rfind('@'));
    fmt::print("  {:<26}{:<14}{:>16}{:>7.1f} %{:>9}{:>13}{:>11}\n", fmt::format("p{} {}", one.primitive, name),
               one.source, grouped(one.clocks), 100.0 * one.share, grouped(one.pieces), grouped(one.halfspaces),
               grouped(pixels[one.primitive]));
  }
  print_rest(counted(shares.other_primitives, "other primitive"), shares.other_clocks, shares.whole);
  for (const observe::EffectCost& effect : shares.effects)
    print_rest("effect " + effect.name, effect.clocks, shares.whole);
  print_rest("no primitive", shares.rest, shares.whole);
  fmt::print("  {:<40}{:>16}\n", "all", grouped(shares.whole));
}

void print_knobs(const observe::Report& report, const Advice& advice) {
  if (advice.machine.empty()) return;
  for (std::size_t i = 0; i < std::min(report.knobs.size(), max_printed_knobs); ++i) {
    const observe::Knob& knob = report.knobs[i];
    fmt::print("{:<18}{}\n", i == 0 ? "knobs" : "", printable(knob.sentence));
    if (!knob.sentence.starts_with(knob.option)) fmt::print("{:<18}  {}\n", "", printable(knob.option));
  }
  if (advice.is_asked && report.knobs.empty()) fmt::print("{:<18}no tried change helps\n", "knobs");
  if (!advice.is_asked) fmt::print("{:<18}{}\n", report.knobs.empty() ? "knobs" : "", advice.ask);
  for (const std::string& command : advice.commands) fmt::print("{:<18}{}\n", "", command);
}

}  // namespace

void print_summary(const observe::Report& report) {
  const isa::CompileFacts& compile = report.program.facts->compile;
  const observe::Cost& total = report.stats.total;
  const double simulated = static_cast<double>(report.result.clocks) / static_cast<double>(report.machine.clock_hz);
  print_model(report.program.facts->model);
  print_machine(report);
  fmt::print("{:<18}{} = {} at the machine's clock rate\n", "clocks", grouped(report.result.clocks),
             time_text(simulated));
  print_frame(report);
  print_host(report);
  fmt::print("{:<18}{} executed, {} skipped\n", "instructions", grouped(total.instructions),
             grouped(report.result.skipped));
  fmt::print("{:<18}{} rendered into Z1, {} classified against Z1, {}\n", "scan-conversions", grouped(compile.rendered),
             grouped(compile.classified), counted(compile.depth_tests, "depth test"));
  fmt::print("{:<18}{} pixel clocks, {} at enabled pixels: utilisation {:.2f} %\n", "pixel operations",
             grouped(total.pixel_operations), grouped(total.enabled), percent(total.enabled, total.pixel_operations));
  fmt::print("{:<18}{} of {} bits a pixel, {} of them for the classification\n", "memory",
             observe::used_memory_bits(report.program), report.machine.array.memory_bits, compile.stack_bits);
  print_account(report);
  print_prunings(report);
  print_purposes(report);
  const double seconds = std::max(report.wall_seconds, 1e-9);
  const double rate = static_cast<double>(report.result.shown_clocks) / seconds;
  fmt::print("\n{:<18}{} ({} clocks/s, {} x the machine's speed)\n", "simulated in", time_text(report.wall_seconds),
             grouped(static_cast<std::uint64_t>(rate)),
             ratio_text(rate / static_cast<double>(report.machine.clock_hz)));
}

void print_words(const observe::Report& report, const observe::Frame& picture, const Advice& advice) {
  print_most_expensive(report, picture);
  fmt::print("\n");
  if (const std::optional<observe::Bound> bound = observe::bound_of(report.result, report.machine))
    fmt::print("{:<18}{}\n", "bound", bound->sentence);
  print_knobs(report, advice);
}

}  // namespace csgsim::shell
