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
  const machines::Load& most = loads.front();
  const auto rate = [&](std::uint64_t clocks) {
    return static_cast<double>(machine.clock_hz) / static_cast<double>(clocks);
  };
  std::string sentence = fmt::format(
      "{} limits the frame rate: it {} in {:.1f} % of the {} clocks from one frame to the next, {:.4g} frames per "
      "second",
      with_article(most.part), most.does, 100.0 * share_of(most, next), grouped(next), rate(next));
  if (loads.size() > 1 && loads[1].clocks > 0)
    sentence += fmt::format("; next is {}, {:.1f} %", with_article(loads[1].part), 100.0 * share_of(loads[1], next));
  Bound bound{most.part, share_of(most, next), result.host_clocks > next, sentence};
  if (!bound.by_host) return bound;
  bound.sentence = fmt::format(
      "the host limits the frame rate: it compiles a frame in {} clocks, {:.4g} frames per second; with a faster host, "
      "{}",
      grouped(result.host_clocks), rate(result.host_clocks), sentence);
  return bound;
}

}  // namespace csgsim::observe
