#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/text_columns.h"
#include "sim/studies/classify/show.h"
#include "sim/studies/processors.h"

namespace csgsim::studies {

namespace {

using Lines = std::vector<std::vector<std::string>>;
using Rows = std::span<const ClassifyRow>;

/// Column alignment: left for the first column, right for all others.
std::string sides_of(const Lines& lines) {
  std::size_t columns = 0;
  for (const std::vector<std::string>& line : lines) columns = std::max(columns, line.size());
  return "<" + std::string(columns - 1, '>');
}

std::string per_ray_text(std::uint64_t count, std::uint64_t rays) {
  return rays == 0 ? "-" : fmt::format("{:.3f}", static_cast<double>(count) / static_cast<double>(rays));
}

/// Prints counts that do not depend on the method, and for each coherence the evaluations of the first method that has
/// it.
void print_rays(Rows rows) {
  const auto drawn = std::ranges::find_if(rows, &ClassifyRow::is_drawn);
  if (drawn == rows.end()) return;
  fmt::print("{}, {}; {}\n", session::count_text(drawn->primitives, "primitive"),
             session::count_text(drawn->halfspaces, "half-space"), session::count_text(drawn->tree_levels, "level"));
  Lines lines{{"", "count", "per hit ray"}};
  const auto add = [&](const std::string& what, std::uint64_t count) {
    lines.push_back({what, grouped(count), per_ray_text(count, drawn->hit_rays)});
  };
  add("rays", drawn->rays);
  add("rays with intersections", drawn->met_rays);
  add("rays that hit the solid", drawn->hit_rays);
  add("sequences", drawn->sequences);
  add("different sequences", drawn->different_sequences);
  add("combinations of primitives", drawn->combinations);
  lines.push_back({"maximum points of a ray", grouped(drawn->max_points), ""});
  for (const std::string& coherence : coherences_of(rows)) {
    const auto row = std::ranges::find_if(
        rows, [&](const ClassifyRow& one) { return one.is_drawn() && one.point.coherence == coherence; });
    if (row != rows.end() && coherence != "none") add("evaluations, " + coherence, row->evaluations);
  }
  fmt::print("{}", session::format_columns(lines, sides_of(lines)));
}

/// Prints the methods' visits, list steps and other work next to their evaluations.
void print_work(Rows rows) {
  Lines lines{{"", "evaluations", "visits", "early outs", "list steps", "elements", "words"}};
  for (const ClassifyRow& row : rows) {
    const std::string name = row.point.method + (row.point.coherence == "none" ? "" : "/" + row.point.coherence);
    if (!row.is_drawn()) {
      lines.push_back({name, row.reason});
      continue;
    }
    lines.push_back({name, grouped(row.evaluations), grouped(row.node_visits), grouped(row.early_outs),
                     grouped(row.list_steps), grouped(row.list_elements), grouped(row.words)});
  }
  fmt::print("\n{}", session::format_columns(lines, sides_of(lines)));
}

void print_seconds(Rows rows, const software::Priced& processor) {
  const std::vector<std::string> coherences = coherences_of(rows);
  Lines lines{{processor.name + ", s"}};
  lines.front().insert(lines.front().end(), coherences.begin(), coherences.end());
  for (const std::string& method : methods_of(rows)) {
    std::vector<std::string>& line = lines.emplace_back(std::vector<std::string>{method});
    for (const std::string& coherence : coherences) {
      const ClassifyRow* const row = find_row(rows, method, coherence);
      line.push_back(row != nullptr && row->is_drawn() ? seconds_text(seconds_of(*row, processor).classification)
                                                       : "-");
    }
  }
  fmt::print("\n{}", session::format_columns(lines, sides_of(lines)));
}

void print_best(Rows rows, std::span<const software::Priced> processors) {
  fmt::print("\n");
  for (const software::Priced& processor : processors) {
    const ClassifyRow* best = nullptr;
    for (const ClassifyRow& row : rows) {
      if (!row.is_drawn()) continue;
      if (best == nullptr || seconds_of(row, processor).all < seconds_of(*best, processor).all) best = &row;
    }
    if (best == nullptr) continue;
    const software::PricedSeconds seconds = seconds_of(*best, processor);
    fmt::print("{}: the fastest method draws the picture in {} s, including {} s for classification ({})\n",
               processor.name, seconds_text(seconds.all), seconds_text(seconds.classification),
               best->point.method + (best->point.coherence == "none" ? "" : "/" + best->point.coherence));
  }
}

template <class Member>
std::vector<std::string> distinct_values(Rows rows, Member member) {
  std::vector<std::string> names;
  for (const ClassifyRow& row : rows) {
    const std::string& name = row.point.*member;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<std::string> methods_of(Rows rows) { return distinct_values(rows, &ClassifyPoint::method); }
std::vector<std::string> coherences_of(Rows rows) { return distinct_values(rows, &ClassifyPoint::coherence); }

const ClassifyRow* find_row(Rows rows, const std::string& method, const std::string& coherence) {
  const auto row = std::ranges::find_if(
      rows, [&](const ClassifyRow& one) { return one.point.method == method && one.point.coherence == coherence; });
  return row == rows.end() ? nullptr : &*row;
}

std::vector<ClassifyGroup> groups_of(Rows rows) {
  std::vector<ClassifyGroup> groups;
  for (const ClassifyRow& row : rows) {
    auto group = std::ranges::find_if(groups, [&](const ClassifyGroup& one) {
      return one.shape == row.point.shape && one.reduced == row.point.reduced;
    });
    if (group == groups.end()) group = groups.insert(group, {row.point.shape, row.point.reduced, {}});
    group->rows.push_back(row);
  }
  return groups;
}

void print_classification(Rows rows, std::span<const software::Priced> processors) {
  for (const ClassifyGroup& group : groups_of(rows)) {
    fmt::print("\nTree {}; reduced: {}. ", group.shape, group.reduced);
    print_rays(group.rows);
    print_work(group.rows);
    for (const software::Priced& processor : processors) print_seconds(group.rows, processor);
    print_best(group.rows, processors);
  }
}

}  // namespace csgsim::studies
