#include "sim/studies/accuracy/pareto.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "host/emit/curves.h"

namespace csgsim::studies {

std::vector<Measurement> of_knob(std::span<const Measurement> measurements, std::string_view knob) {
  std::vector<Measurement> rows;
  std::ranges::copy_if(measurements, std::back_inserter(rows),
                       [&](const Measurement& row) { return row.knob == knob; });
  return rows;
}

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
  for (std::size_t from = 0; from < front.size();) {
    std::size_t to = from + 1;
    while (to < front.size() && 2 * front[to].wrong > front[from].wrong) ++to;
    if (to == front.size()) break;
    const auto before = static_cast<double>(front[from].clocks);
    steps.push_back({front[from], front[to], (static_cast<double>(front[to].clocks) - before) / before});
    from = to;
  }
  return steps;
}

namespace {

bool is_faceted(const Measurement& row) {
  return row.knob == "fn" || row.knob == "tolerance" ||
         (row.knob == "curves" && row.value == emit::name_of(emit::Curves::facets));
}

}  // namespace

std::vector<EqualFacets> facets_as_right(std::span<const Measurement> rows) {
  std::vector<EqualFacets> all;
  for (const Measurement& curved : rows) {
    if (curved.knob != "curves" || is_faceted(curved)) continue;
    const Measurement* best = nullptr;
    for (const Measurement& facets : rows) {
      if (!is_faceted(facets)) continue;
      // All that are as right are equally so.
      const auto rank = [&](const Measurement& row) {
        return std::pair(std::max(row.facet_wrong, curved.facet_wrong), row.clocks);
      };
      if (best == nullptr || rank(facets) < rank(*best)) best = &facets;
    }
    if (best != nullptr) all.push_back({curved, *best, best->facet_wrong <= curved.facet_wrong});
  }
  return all;
}

}  // namespace csgsim::studies
