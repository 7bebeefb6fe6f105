#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/options/text_columns.h"
#include "sim/studies/mesh/price.h"
#include "sim/studies/mesh/show.h"
#include "sim/studies/processors.h"

namespace csgsim::studies {

namespace {

using Lines = std::vector<std::vector<std::string>>;

/// Groups rows that differ only in the tolerance.
std::vector<std::vector<MeshRow>> groups_of(std::span<const MeshRow> rows) {
  std::vector<std::vector<MeshRow>> groups;
  for (const MeshRow& row : rows) {
    const auto group = std::ranges::find_if(groups, [&](const std::vector<MeshRow>& one) {
      const MeshPoint& first = one.front().point;
      return first.name == row.point.name && first.flatness == row.point.flatness && first.repair == row.point.repair;
    });
    if (group == groups.end()) {
      groups.push_back({row});
    } else {
      group->push_back(row);
    }
  }
  return groups;
}

void add_line(Lines& lines, const std::string& title, std::span<const MeshRow> rows,
              const std::function<std::string(const MeshRow&)>& cell) {
  std::vector<std::string>& line = lines.emplace_back(std::vector<std::string>{title});
  for (const MeshRow& row : rows) line.push_back(row.is_meshed() ? cell(row) : "-");
}

void print_group(std::span<const MeshRow> rows, std::span<const software::Priced> processors) {
  const bool is_tree = rows.front().point.repair == repair_by_quadtree;
  fmt::print("\n{}, flatness test {}; {}\n", rows.front().point.name, rows.front().point.flatness,
             is_tree ? "quadtree" : "filter");
  Lines lines{{"tolerance"}};
  for (const MeshRow& row : rows) lines.back().push_back(fmt::format("{:g}", row.point.tolerance));
  const auto add = [&](const std::string& title, std::uint64_t MeshRow::*count) {
    add_line(lines, title, rows, [&](const MeshRow& row) { return grouped(row.*count); });
  };
  add("elements", &MeshRow::elements);
  add("vertices", &MeshRow::vertices);
  add("maximum elements held", &MeshRow::most_elements);
  add("maximum vertices held", &MeshRow::most_vertices);
  add(is_tree ? "nodes held" : "maximum edges held", &MeshRow::most_edges);
  if (rows.front().patches > 1) add("vertices between patches", &MeshRow::wire_vertices);
  for (const software::Priced& processor : processors) {
    if (!processor.processor) continue;
    add_line(lines, processor.name + ": subdividing, s", rows,
             [&](const MeshRow& row) { return seconds_text(seconds_of(row, *processor.processor).subdividing); });
    add_line(lines, processor.name + ": repairing, s", rows,
             [&](const MeshRow& row) { return seconds_text(seconds_of(row, *processor.processor).repairing); });
  }
  fmt::print("{}", session::format_columns(lines, "<" + std::string(rows.size(), '>')));
  for (const MeshRow& row : rows) {
    if (!row.is_meshed()) fmt::print("tolerance {:g}: {}\n", row.point.tolerance, row.reason);
  }
}

}  // namespace

void print_meshes(std::span<const MeshRow> rows, std::span<const software::Priced> processors) {
  for (const std::vector<MeshRow>& group : groups_of(rows)) print_group(group, processors);
}

std::vector<plots::Plot> plots_of_meshes(std::span<const MeshRow> rows, const std::string& model) {
  std::vector<plots::Plot> plots;
  for (const std::vector<MeshRow>& group : groups_of(rows)) {
    const MeshPoint& point = group.front().point;
    if (group.size() < 2 || point.repair != repair_by_filter) continue;
    plots::Chart chart{model + ": elements of " + point.name + ", flatness test " + point.flatness,
                       {"tolerance, model units", plots::Scale::logarithmic},
                       {{"elements", plots::Scale::logarithmic}},
                       {{"total"}, {"held at once"}},
                       "mesh.csv"};
    for (const MeshRow& row : group) {
      if (!row.is_meshed()) continue;
      chart.series[0].points.push_back({row.point.tolerance, static_cast<double>(row.elements)});
      chart.series[1].points.push_back({row.point.tolerance, static_cast<double>(row.most_elements)});
    }
    plots.push_back({"mesh_" + point.name + "_" + point.flatness, std::move(chart)});
  }
  return plots;
}

}  // namespace csgsim::studies
