#include "sim/study/pareto.h"

#include <algorithm>

namespace csgsim::study {

std::vector<Measurement> pareto_front(std::span<const Measurement> measurements) {
  std::vector<Measurement> sorted(measurements.begin(), measurements.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const Measurement& a, const Measurement& b) {
    return a.clocks != b.clocks ? a.clocks < b.clocks : a.wrong < b.wrong;
  });
  std::vector<Measurement> front;
  for (Measurement& one : sorted) {
    if (front.empty() || one.wrong < front.back().wrong) front.push_back(std::move(one));
  }
  return front;
}

std::vector<Halving> halvings(std::span<const Measurement> front) {
  std::vector<Halving> steps;
  for (std::size_t from = 0; from < front.size() && front[from].wrong > 0;) {
    std::size_t to = from + 1;
    while (to < front.size() && 2 * front[to].wrong > front[from].wrong) ++to;
    if (to == front.size()) break;
    const auto before = static_cast<double>(front[from].clocks);
    steps.push_back({front[from], front[to], (static_cast<double>(front[to].clocks) - before) / before});
    from = to;
  }
  return steps;
}

}  // namespace csgsim::study
