#include "sim/studies/sweep/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "host/emit/options.h"
#include "sim/studies/stack_bits.h"

namespace csgsim::studies {

namespace {

/// The points of one model, machine, memory, depth, pruning, curves and colouring.
void add_strategies(const SweepRanges& ranges, const SweepPoint& point, std::vector<SweepPoint>& points) {
  for (const std::string& name : ranges.strategies) {
    const std::vector<unsigned> one{0};
    for (const unsigned bits : has_stack_bits(name) ? ranges.stack_bits : one) {
      points.push_back(point);
      points.back().strategy = name;
      points.back().stack_bits = bits;
    }
  }
}

template <class Member>
bool varies(std::span<const SweepRow> rows, Member member) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const SweepRow& row) { return row.point.*member != rows.front().point.*member; });
}

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
                add_strategies(ranges, {model, machine, memory_bits, z_bits, pruning, colouring, {}, 0, curves},
                               points);
            }
          }
        }
      }
    }
  }
  return points;
}

PointNames::PointNames(std::span<const SweepRow> rows)
    : machine_(varies(rows, &SweepPoint::machine)),
      memory_bits_(varies(rows, &SweepPoint::memory_bits)),
      z_bits_(varies(rows, &SweepPoint::z_bits)),
      pruning_(varies(rows, &SweepPoint::pruning)),
      colouring_(varies(rows, &SweepPoint::colouring)),
      curves_(varies(rows, &SweepPoint::curves)) {}

std::string PointNames::name(const SweepPoint& point) const {
  const std::string rest = conditions(point);
  return strategy_name(point) + (rest.empty() ? "" : ", " + rest);
}

std::string PointNames::conditions(const SweepPoint& point) const {
  std::string text;
  const auto add = [&](bool said, const std::string& part) {
    if (said) text += (text.empty() ? "" : ", ") + part;
  };
  add(machine_, point.machine);
  add(memory_bits_, fmt::format("memory {}", point.memory_bits));
  add(z_bits_, fmt::format("z {}", point.z_bits));
  add(pruning_, fmt::format("pruning {}", point.pruning));
  add(colouring_, point.colouring);
  add(curves_, fmt::format("curves {}", point.curves));
  return text;
}

std::string strategy_name(const SweepPoint& point) {
  return has_stack_bits(point.strategy) ? fmt::format("{} {}", point.strategy, point.stack_bits) : point.strategy;
}

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
