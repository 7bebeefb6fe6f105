#include "sim/studies/sweep/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

auto conditions_of(const SweepPoint& point) {
  return std::tie(point.model, point.machine, point.memory_bits, point.z_bits, point.pruning, point.colouring,
                  point.curves);
}

}  // namespace

std::vector<SweepPoint> points_of(const SweepRanges& ranges) {
  std::vector<SweepPoint> points;
  for (const std::string& model : ranges.models) {
    for (const std::string& machine : ranges.machines) {
      for (const std::uint32_t memory_bits : ranges.memory_bits.at(machine)) {
        for (const unsigned z_bits : ranges.z_bits) {
          for (const std::string& pruning : ranges.prunings) {
            for (const std::string& curves : ranges.curves) {
              for (const std::string& colouring : ranges.colourings)
                for_each_strategy(ranges,
                                  SweepPoint{model, machine, memory_bits, z_bits, pruning, colouring, {}, 0, curves},
                                  [&](const SweepPoint& point) { points.push_back(point); });
            }
          }
        }
      }
    }
  }
  return points;
}

std::string strategy_name(const SweepPoint& point) { return strategy_name(point.strategy, point.stack_bits); }

std::vector<std::vector<SweepRow>> by_conditions(std::span<const SweepRow> rows) {
  std::vector<std::vector<SweepRow>> groups;
  for (const SweepRow& row : rows) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const std::vector<SweepRow>& one) {
      return conditions_of(one.front().point) == conditions_of(row.point);
    });
    if (group == groups.end()) {
      groups.push_back({row});
    } else {
      group->push_back(row);
    }
  }
  return groups;
}

std::vector<WrongPicture> wrong_pictures(std::span<const SweepRow> rows) {
  std::vector<const SweepRow*> references;
  std::vector<WrongPicture> wrong;
  for (const SweepRow& row : rows) {
    if (row.picture.empty()) continue;
    if (row.picture == overflow) {
      wrong.push_back({row.point, std::nullopt});
      continue;
    }
    const auto reference = std::find_if(references.begin(), references.end(), [&](const SweepRow* one) {
      // Machines differ in whether they draw curved surfaces without facets.
      return std::tie(one->point.model, one->width, one->height, one->point.z_bits, one->halfspaces) ==
             std::tie(row.point.model, row.width, row.height, row.point.z_bits, row.halfspaces);
    });
    if (reference == references.end()) {
      references.push_back(&row);
    } else if ((*reference)->picture != row.picture) {
      wrong.push_back({row.point, (*reference)->point});
    }
  }
  return wrong;
}

}  // namespace csgsim::studies
