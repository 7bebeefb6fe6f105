#include "sim/studies/compare/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/observe/bound.h"
#include "sim/session/options/numbers.h"

namespace csgsim::studies {

namespace {

using OwnRows = std::vector<const ComparisonRow*>;

/// The first drawn row of each machine: its own picture on the machine as described.
OwnRows own_pictures(std::span<const ComparisonRow> rows) {
  OwnRows own;
  std::vector<std::string> seen;
  for (const ComparisonRow& row : rows) {
    if (std::ranges::find(seen, row.point.machine) != seen.end()) continue;
    seen.push_back(row.point.machine);
    if (row.is_drawn()) own.push_back(&row);
  }
  return own;
}

/// Width of the column below a machine's name.
std::size_t column_width(const ComparisonRow& row) { return std::max<std::size_t>(17, row.point.machine.size() + 2); }

void print_bounds(const OwnRows& own) {
  std::size_t width = 16;
  for (const ComparisonRow* row : own) width = std::max(width, row->point.machine.size() + 1);
  fmt::print("\n{:<{}}{:<34}{:>9}{:>11}{:>18}\n", "limited by", width + 2, "", "share", "frames/s", "with its host");
  for (const ComparisonRow* row : own) {
    if (row->bound_by.empty()) continue;
    fmt::print("  {:<{}}{:<34}{:>7.1f} %{:>11}{:>18}\n", row->point.machine, width, row->bound_by,
               100.0 * row->bound_share, observe::rate_text(row->frames_per_second),
               observe::rate_text(row->hosted_frames_per_second));
  }
}

/// Prints the most expensive primitives of the first machine and their share on each machine; software has no such
/// data.
void print_dearest(OwnRows own) {
  std::erase_if(own, [](const ComparisonRow* row) { return row->instruction_clocks == 0; });
  if (own.empty()) return;
  fmt::print("\n{:<28}", "most expensive primitives");
  for (const ComparisonRow* row : own) fmt::print("{:>{}}", row->point.machine, column_width(*row));
  fmt::print("\n");
  std::vector<std::uint64_t> rest;
  for (const ComparisonRow* row : own) rest.push_back(row->instruction_clocks);
  for (const CostlyPrimitive& one : own.front()->dearest) {
    fmt::print("  {:<26}", one.name);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto found = std::ranges::find(own[i]->dearest, one.name, &CostlyPrimitive::name);
      if (found == own[i]->dearest.end()) {
        fmt::print("{:>{}}", "less", column_width(*own[i]));
        continue;
      }
      rest[i] -= found->clocks;
      fmt::print("{:>{}.1f} %",
                 100.0 * static_cast<double>(found->clocks) / static_cast<double>(own[i]->instruction_clocks),
                 column_width(*own[i]) - 2);
    }
    fmt::print("\n");
  }
  fmt::print("  {:<26}", "everything else");
  for (std::size_t i = 0; i < own.size(); ++i)
    fmt::print("{:>{}.1f} %", 100.0 * static_cast<double>(rest[i]) / static_cast<double>(own[i]->instruction_clocks),
               column_width(*own[i]) - 2);
  fmt::print("\n");
}

/// Prints the gain from coarser facets, using rows that differ from the machine's own picture only in facets.
void print_facets(std::span<const ComparisonRow> rows, const ComparisonRow& own) {
  const ComparisonRow* best = nullptr;
  for (const ComparisonRow& row : rows) {
    if (!row.is_drawn() || row.point.machine != own.point.machine || row.point.width != own.point.width ||
        row.point.height != own.point.height || row.halfspaces >= own.halfspaces)
      continue;
    if (best == nullptr || row.halfspaces > best->halfspaces) best = &row;
  }
  if (best == nullptr || best->frames_per_second <= own.frames_per_second) return;
  fmt::print("{:<18}{}: $fn = {} gives {} half-spaces instead of {}, and {} frames/s instead of {}\n", "",
             own.point.machine, best->point.fragments, grouped(best->halfspaces), grouped(own.halfspaces),
             observe::rate_text(best->frames_per_second), observe::rate_text(own.frames_per_second));
}

/// Prints the machine's parameter that gains most when made ideal.
void print_ideal(std::span<const ComparisonRow> rows, const ComparisonRow& own) {
  const ComparisonRow* best = nullptr;
  for (const ComparisonRow& row : rows) {
    const bool is_one_figure = !row.point.ideal.empty() && row.point.ideal != "all";
    if (!row.is_drawn() || row.point.machine != own.point.machine || !is_one_figure) continue;
    if (best == nullptr || row.frames_per_second > best->frames_per_second) best = &row;
  }
  if (best == nullptr || best->frames_per_second <= own.frames_per_second) return;
  fmt::print("{:<18}{}: ideal {} gives {} frames/s instead of {}\n", "", own.point.machine, best->point.ideal,
             observe::rate_text(best->frames_per_second), observe::rate_text(own.frames_per_second));
}

}  // namespace

void print_comparison_summary(std::span<const ComparisonRow> rows) {
  const OwnRows own = own_pictures(rows);
  if (own.empty()) return;
  print_bounds(own);
  if (!own.front()->dearest.empty()) print_dearest(own);
  const ComparisonRow& fastest = **std::ranges::max_element(own, {}, &ComparisonRow::frames_per_second);
  fmt::print("\n{:<18}fastest of the machines as described, without their hosts: {}, {} frames/s\n", "advice",
             fastest.point.machine, observe::rate_text(fastest.frames_per_second));
  for (const ComparisonRow* row : own) {
    print_facets(rows, *row);
    print_ideal(rows, *row);
  }
  if (std::ranges::all_of(rows, [](const ComparisonRow& row) { return row.point.ideal.empty(); }))
    fmt::print("{:<18}csgsim compare --ideal measures the maximum gain from each parameter of a machine\n", "");
}

}  // namespace csgsim::studies
