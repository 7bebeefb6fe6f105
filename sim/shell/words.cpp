#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "hw/base/text.h"
#include "sim/observe/bound.h"
#include "sim/observe/dearest.h"
#include "sim/shell/advice.h"
#include "sim/shell/numbers.h"

namespace csgsim::shell {

namespace {

constexpr std::size_t most_knobs_printed = 3;

void print_rest(const std::string& name, std::uint64_t clocks, std::uint64_t whole) {
  if (clocks == 0) return;
  fmt::print("  {:<40}{:>16}{:>7.1f} %\n", name, grouped(clocks), percent(clocks, whole));
}

void print_dearest(const observe::Report& report, const observe::Frame& picture) {
  const observe::ClockShares shares = observe::clock_shares(report.program, report.result, report.stats);
  if (shares.whole == 0) return;
  const std::vector<std::uint64_t> pixels = observe::pixels_seen(picture, report.program);
  fmt::print("\n{:<28}{:<14}{:>16}{:>9}{:>9}{:>13}{:>11}\n", "dearest primitives", "line:column", "clocks", "share",
             "pieces", "half-spaces", "pixels");
  for (const observe::PrimitiveCost& one : shares.dearest) {
    const std::string name = one.name.substr(0, one.source.empty() ? one.name.size() : one.name.rfind('@'));
    fmt::print("  {:<26}{:<14}{:>16}{:>7.1f} %{:>9}{:>13}{:>11}\n", fmt::format("p{} {}", one.primitive, name),
               one.source, grouped(one.clocks), 100.0 * one.share, grouped(one.pieces), grouped(one.halfspaces),
               grouped(pixels[one.primitive]));
  }
  print_rest(counted(shares.other_primitives, "other primitive"), shares.other_clocks, shares.whole);
  for (const observe::EffectCost& effect : shares.effects)
    print_rest("effect " + effect.name, effect.clocks, shares.whole);
  print_rest("of no primitive", shares.rest, shares.whole);
  fmt::print("  {:<40}{:>16}\n", "all", grouped(shares.whole));
}

void print_knobs(const observe::Report& report, const Advice& advice) {
  if (advice.machine.empty()) return;
  for (std::size_t i = 0; i < std::min(report.knobs.size(), most_knobs_printed); ++i) {
    const observe::Knob& knob = report.knobs[i];
    fmt::print("{:<18}{}\n", i == 0 ? "knobs" : "", printable(knob.sentence));
    if (!knob.sentence.starts_with(knob.option)) fmt::print("{:<18}  {}\n", "", printable(knob.option));
  }
  if (advice.is_asked && report.knobs.empty()) fmt::print("{:<18}nothing that was tried helps\n", "knobs");
  if (!advice.is_asked) fmt::print("{:<18}{}\n", report.knobs.empty() ? "knobs" : "", advice.ask);
  for (const std::string& command : advice.commands) fmt::print("{:<18}{}\n", "", command);
}

}  // namespace

void print_words(const observe::Report& report, const observe::Frame& picture, const Advice& advice) {
  print_dearest(report, picture);
  fmt::print("\n");
  if (const std::optional<observe::Bound> bound = observe::bound_of(report.result, report.machine))
    fmt::print("{:<18}{}\n", "bound", bound->sentence);
  print_knobs(report, advice);
}

}  // namespace csgsim::shell
