#include "sim/plots/common_looks.h"

#include <algorithm>
#include <set>
#include <variant>

#include "sim/plots/chart_series.h"
#include "sim/plots/palette.h"

namespace csgsim::plots {

namespace {

/// All names in order of first appearance. The empty name comes last because it has no entry in the key.
Names all_of(std::span<const Names> plots) {
  Names all;
  bool has_nameless = false;
  for (const Names& names : plots) {
    for (const std::string& name : names) {
      has_nameless |= name.empty();
      if (!name.empty() && std::ranges::find(all, name) == all.end()) all.push_back(name);
    }
  }
  if (has_nameless) all.emplace_back();
  return all;
}

/// The looks of the names that share a plot with `name`.
std::set<std::size_t> taken_beside(const std::string& name, std::span<const Names> plots, const Looks& looks) {
  std::set<std::size_t> taken;
  for (const Names& names : plots) {
    if (std::ranges::find(names, name) == names.end()) continue;
    for (const std::string& other : names) {
      if (const auto known = looks.find(other); known != looks.end()) taken.insert(known->second);
    }
  }
  return taken;
}

std::size_t first_not_in(const std::set<std::size_t>& taken) {
  std::size_t look = 0;
  while (taken.contains(look)) ++look;
  return look;
}

}  // namespace

Looks common_looks(std::span<const Names> names_by_plot, std::size_t distinct_looks, std::size_t look_count) {
  Looks result;
  std::set<std::size_t> used;
  for (const std::string& name : all_of(names_by_plot)) {
    std::size_t look = first_not_in(used);
    if (look >= distinct_looks) look = first_not_in(taken_beside(name, names_by_plot, result));
    if (look >= look_count) continue;
    result[name] = look;
    used.insert(look);
  }
  return result;
}

void set_common_looks(std::vector<Plot>& plots) {
  std::vector<Names> names;
  for (const Plot& plot : plots) {
    if (const auto* const chart = std::get_if<Chart>(&plot.content)) names.push_back(series_names_by_priority(*chart));
  }
  const Looks looks = common_looks(names, palette::max_series, palette::max_series);
  for (Plot& plot : plots) {
    if (auto* const chart = std::get_if<Chart>(&plot.content)) chart->looks = looks;
  }
}

}  // namespace csgsim::plots
