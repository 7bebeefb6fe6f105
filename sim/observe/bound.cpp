#include "sim/observe/bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/text.h"
#include "hw/machines/kind.h"

namespace csgsim::observe {

namespace {

machines::FrameTiming timing_of(const engine::RunResult& result) {
  return {result.clocks,         result.shown_clocks, result.interval_clocks,
          result.latency_clocks, result.account,      result.host_clocks};
}

double share_of(const machines::Load& load, std::uint64_t clocks) {
  return static_cast<double>(load.clocks) / static_cast<double>(clocks);
}

/// Adds an article, except for one of several units that is named by its number.
std::string with_article(const std::string& part) {
  const bool is_numbered = part.back() >= '0' && part.back() <= '9';
  return is_numbered ? part : "the " + part;
}

}  // namespace

std::optional<Bound> bound_of(const engine::RunResult& result, const machines::Machine& machine) {
  const std::uint64_t next = result.interval_clocks;
  if (next == 0) return std::nullopt;
  std::vector<machines::Load> loads = machine.kind->loads(timing_of(result));
  if (loads.empty()) return std::nullopt;
  std::ranges::stable_sort(loads, std::ranges::greater{}, &machines::Load::clocks);
  const machines::Load& busiest = loads.front();
  const auto clock_hz = static_cast<double>(machine.clock_hz);
  std::string sentence =
      fmt::format("The hardware could show {:.4g} frames/s, limited by {} ({:.0f} % of each frame",
                  clock_hz / static_cast<double>(next), with_article(busiest.part), 100.0 * share_of(busiest, next));
  if (loads.size() > 1 && loads[1].clocks > 0)
    sentence += fmt::format("; {} takes {:.0f} %", with_article(loads[1].part), 100.0 * share_of(loads[1], next));
  sentence += ").";
  const bool by_host = result.host_clocks > next;
  if (by_host) {
    sentence += fmt::format(" The host needs {:.3g} s per frame.", static_cast<double>(result.host_clocks) / clock_hz);
  }
  return Bound{busiest.part, share_of(busiest, next), by_host, sentence};
}

}  // namespace csgsim::observe
