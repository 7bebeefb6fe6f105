#include "sim/observe/bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/text.h"
#include "hw/machines/kind.h"

namespace csgsim::observe {

namespace {

double share_of(const machines::Load& load, std::uint64_t clocks) {
  return static_cast<double>(load.clocks) / static_cast<double>(clocks);
}

/// Adds an article, except for one of several units that is named by its number.
std::string with_article(const std::string& part) {
  const bool is_numbered = part.back() >= '0' && part.back() <= '9';
  return is_numbered ? part : "the " + part;
}

}  // namespace

std::string rate_text(double frames_per_second) { return rounded(frames_per_second, 4); }

std::optional<Bottleneck> find_bottleneck(const engine::RunResult& result, const machines::Machine& machine) {
  const std::uint64_t next = result.interval_clocks;
  if (next == 0) return std::nullopt;
  std::vector<machines::Load> loads = machine.kind->loads(engine::timing_of(result));
  if (loads.empty()) return std::nullopt;
  std::ranges::stable_sort(loads, std::ranges::greater{}, &machines::Load::clocks);
  const machines::Load& busiest = loads.front();
  Bottleneck bound{busiest.part, share_of(busiest, next), result.host_clocks > next, "", ""};
  bound.limit = fmt::format("limited by {} ({:.0f} % of each frame", with_article(busiest.part), 100.0 * bound.share);
  if (loads.size() > 1 && loads[1].clocks > 0)
    bound.limit += fmt::format("; {} takes {:.0f} %", with_article(loads[1].part), 100.0 * share_of(loads[1], next));
  bound.limit += ")";
  bound.sentence = fmt::format("The hardware could show {} frames/s, {}.",
                               rate_text(engine::frame_rates(result, machine).hardware), bound.limit);
  if (bound.by_host) {
    const double seconds = static_cast<double>(result.host_clocks) / static_cast<double>(machine.clock_hz);
    bound.sentence += fmt::format(" The host needs {} per frame.", quantity(seconds, "s"));
  }
  return bound;
}

}  // namespace csgsim::observe
