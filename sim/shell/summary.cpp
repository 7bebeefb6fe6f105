#include "sim/shell/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/machines/kind.h"
#include "sim/observe/bound.h"
#include "sim/observe/primitive_costs.h"
#include "sim/session/options/numbers.h"

namespace csgsim::shell {

namespace {

void print_line(std::string_view name, std::string_view text) { fmt::print("{:<18}{}\n", name, text); }

std::string time_text(std::uint64_t clocks, const machines::Machine& machine) {
  return quantity(static_cast<double>(clocks) / static_cast<double>(machine.clock_hz), "s");
}

std::string picture_text(const std::string& file) {
  if (file.empty()) return "not written; add -o picture.png";
  return "written to " + (is_standard_output(file) ? std::string("standard output") : printable(file));
}

void print_machine(const observe::Report& report) {
  const machines::Machine& machine = report.machine;
  print_line("machine", fmt::format("{}, {} x {} pixel processors of {} bits at {}, {} level", machine.name,
                                    machine.array.width, machine.array.height, machine.array.memory_bits,
                                    quantity(static_cast<double>(machine.clock_hz), "Hz"), report.level));
  const std::vector<std::string> ideal = machines::ideal_parameters(machine);
  if (!ideal.empty()) print_line("ideal", fmt::format("{}", fmt::join(ideal, ", ")));
}

std::string shown_text(const observe::Report& report, const std::optional<observe::Bottleneck>& bound) {
  const std::string rate =
      "at " + observe::rate_text(engine::frame_rates(report.result, report.machine).hardware) + " frames/s";
  return bound ? rate + ", " + bound->limit : rate;
}

/// The name with its indefinite article, as in `an mc68000`, whose letters are read one by one, and `a vax`.
std::string with_indefinite_article(std::string_view name) {
  constexpr std::string_view vowels = "aeiou";
  constexpr std::string_view begin_with_vowels = "aefhilmnorsx";  // when read alone, as in MC
  const bool is_spelled = name.size() > 1 && vowels.find(name[1]) == vowels.npos;
  const bool takes_an = (is_spelled ? begin_with_vowels : vowels).find(name.front()) != vowels.npos;
  return fmt::format("{} {}", takes_an ? "an" : "a", name);
}

/// Text of the host's time for the model and per frame, and of the frame rate if the host limits it.
std::string host_text(const observe::Report& report, const std::optional<observe::Bottleneck>& bound) {
  const machines::Machine& machine = report.machine;
  if (machine.host.processor == machines::ideal_processor) return "ideal: needs no time";
  const std::uint32_t count = machine.kind->host_processor_count(machine);
  const std::string_view name = machines::host_processor_names.at(machine.host.processor);
  std::string text = count == 1 ? with_indefinite_article(name) + " needs" : fmt::format("{} {} need", count, name);
  if (const std::uint64_t clocks = report.result.host_model_clocks; clocks > 0)
    text += fmt::format(" {} for the model and", time_text(clocks, machine));
  text += fmt::format(" {} per frame", time_text(report.result.host_clocks, machine));
  if (bound && bound->by_host)
    text += ", which limits the rate to " + observe::rate_text(engine::frame_rates(report.result, machine).hosted) +
            " frames/s";
  return text;
}

/// Text of a change: the option to add to the command line, and its worth.
std::string knob_text(const observe::Knob& knob) {
  return printable(knob.sentence.starts_with(knob.option) ? knob.sentence : knob.option + ": " + knob.worth);
}

/// Prints the best change and, if another is the best, the best selection of prunings.
void print_best_knobs(std::span<const observe::Knob> knobs, bool is_verbose) {
  if (knobs.empty()) return print_line("advice", "no tried change helps");
  const std::string more = is_verbose || knobs.size() == 1 ? "" : "; --verbose lists all that help";
  print_line("advice", knob_text(knobs.front()) + more);
  const auto pruning = std::ranges::find_if(
      knobs.subspan(1), [](const observe::Knob& one) { return one.option.starts_with("--pruning "); });
  if (pruning != knobs.end()) print_line("", knob_text(*pruning));
}

void print_advice(const observe::Report& report, const Advice& advice, bool is_verbose) {
  if (advice.machine.empty()) return;
  if (advice.is_asked) return print_best_knobs(report.knobs, is_verbose);
  print_line("advice", advice.ask + (is_verbose ? "" : "; --verbose prints all counts"));
}

void print_purposes(const observe::Report& report) {
  const std::uint64_t whole = report.stats.total.clocks + report.result.latency_clocks;
  fmt::print("\n{:<18}{:>14}{:>9}{:>15}{:>12}\n", "purpose", "clocks", "share", "instructions", "utilization");
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

/// Prints, for each pruning, how often it was tried, decided and left out.
void print_prunings(const observe::Report& report) {
  for (const isa::PruningFacts& pruning : report.program.facts->prunings) {
    std::string text = fmt::format("tried {}, decided {}", grouped(pruning.tried), grouped(pruning.decided));
    if (pruning.nanoseconds > 0)
      text += fmt::format(" in {:.3g} ms of the host", static_cast<double>(pruning.nanoseconds) / 1e6);
    if (pruning.decided > 0) text += fmt::format(", which saves about {} instructions", grouped(pruning.saved));
    if (pruning.left > 0)
      text +=
          fmt::format("; left out {} whose test would take the host more than half of the time that its success saves",
                      grouped(pruning.left));
    fmt::print("{:<20}{}\n", "pruning " + pruning.name, text);
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

/// Prints a count of the account; an energy with its unit.
void print_count(const machines::Count& count) {
  constexpr std::string_view energy = "_picojoules";
  const std::string_view name = count.name;
  if (!name.ends_with(energy)) {
    fmt::print("{:<26}{:>18}\n", heading(name), grouped(count.value));
  } else {
    fmt::print("{:<26}{:>18}\n", heading(name.substr(0, name.size() - energy.size())) + " energy",
               quantity(static_cast<double>(count.value) * 1e-12, "J"));
  }
}

/// Prints the machine's own account of the frame: counts, shares, and the clocks of each unit by activity.
void print_account(const observe::Report& report) {
  const machines::Account& account = report.result.account;
  if (!account.counts.empty() || !account.shares.empty()) fmt::print("\n");
  for (const machines::Count& count : account.counts) print_count(count);
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

void print_rest(const std::string& name, std::uint64_t clocks, std::uint64_t whole) {
  if (clocks == 0) return;
  fmt::print("  {:<40}{:>16}{:>7.1f} %\n", name, grouped(clocks), percent(clocks, whole));
}

void print_most_expensive(const observe::Report& report, const observe::Frame& picture) {
  const observe::ClockShares shares = observe::clock_shares(report.program, report.result, report.stats);
  if (shares.whole == 0) return;
  const std::vector<std::uint64_t> pixels = observe::visible_pixel_counts(picture, report.program);
  fmt::print("\n{:<28}{:<14}{:>16}{:>9}{:>9}{:>13}{:>11}\n", "most expensive primitives", "line:column", "clocks",
             "share", "pieces", "half-spaces", "pixels");
  for (const observe::PrimitiveCost& one : shares.most_expensive) {
    const std::string name = one.name.substr(0, one.source.empty() ? one.name.size() : one.name.rfind('@'));
    fmt::print("  {:<26}{:<14}{:>16}{:>7.1f} %{:>9}{:>13}{:>11}\n", fmt::format("p{} {}", one.primitive, name),
               one.source, grouped(one.clocks), 100.0 * one.share, grouped(one.pieces), grouped(one.halfspaces),
               grouped(pixels[one.primitive]));
  }
  print_rest(count_text(shares.other_primitives, "other primitive"), shares.other_clocks, shares.whole);
  for (const observe::EffectCost& effect : shares.effects)
    print_rest("effect " + effect.name, effect.clocks, shares.whole);
  print_rest("no primitive", shares.rest, shares.whole);
  fmt::print("  {:<40}{:>16}\n", "all", grouped(shares.whole));
}

void print_knobs(const observe::Report& report, const Advice& advice) {
  if (report.knobs.empty() && advice.commands.empty()) return;
  fmt::print("\n");
  for (const observe::Knob& knob : report.knobs)
    print_line(&knob == &report.knobs.front() ? "changes" : "", knob_text(knob));
  for (const std::string& command : advice.commands) print_line("", command);
}

}  // namespace

void print_run_summary(const observe::Report& report, const std::string& picture, const Advice& advice,
                       std::string_view verdict, bool is_verbose) {
  const isa::ModelFacts& model = report.program.facts->model;
  const machines::Machine& machine = report.machine;
  const std::optional<observe::Bottleneck> bound = observe::find_bottleneck(report.result, machine);
  print_line("picture", picture_text(picture));
  print_line("model", count_text(model.primitives, "primitive") + ", " + count_text(model.halfspaces, "half-space"));
  print_machine(report);
  print_line("drawn",
             fmt::format("in {} ({} clocks)", time_text(report.result.clocks, machine), grouped(report.result.clocks)));
  print_line("shown", shown_text(report, bound));
  print_line("host", host_text(report, bound));
  print_line("memory", fmt::format("{} of {} bits per pixel, {} of them for the classification",
                                   observe::used_memory_bits(report.program), machine.array.memory_bits,
                                   report.program.facts->compile.stack_bits));
  fmt::print("{}", verdict);
  print_advice(report, advice, is_verbose);
}

void print_details(const observe::Report& report, const observe::Frame& picture, const Advice& advice) {
  const isa::CompileFacts& compile = report.program.facts->compile;
  const isa::ModelFacts& model = report.program.facts->model;
  const observe::Cost& total = report.stats.total;
  const machines::Machine& machine = report.machine;
  fmt::print("\n");
  print_line("operators",
             fmt::format("{}, {}, {}", count_text(model.unions, "union"), count_text(model.differences, "difference"),
                         count_text(model.intersections, "intersection")));
  print_line("frame", fmt::format("shown {} after its first clock ({} clocks)",
                                  time_text(report.result.shown_clocks, machine), grouped(report.result.shown_clocks)));
  print_line("instructions",
             fmt::format("{} executed, {} skipped", grouped(total.instructions), grouped(report.result.skipped)));
  print_line("scan-conversions",
             fmt::format("{} rendered into Z1, {} classified against Z1, {}", grouped(compile.rendered),
                         grouped(compile.classified), count_text(compile.depth_tests, "depth test")));
  print_line("pixel operations", fmt::format("{} in total, {} at enabled pixels: utilization {:.2f} %",
                                             quantity(static_cast<double>(total.pixel_operations), ""),
                                             quantity(static_cast<double>(total.enabled), ""),
                                             percent(total.enabled, total.pixel_operations)));
  print_account(report);
  print_prunings(report);
  print_purposes(report);
  const double seconds = std::max(report.wall_seconds, 1e-9);
  const double rate = static_cast<double>(report.result.shown_clocks) / seconds;
  fmt::print("\n");
  print_line("simulated in",
             fmt::format("{} ({}, {} x the machine's speed)", quantity(report.wall_seconds, "s"),
                         quantity(rate, "clocks/s"), rounded(rate / static_cast<double>(machine.clock_hz))));
  print_most_expensive(report, picture);
  print_knobs(report, advice);
}

}  // namespace csgsim::shell
