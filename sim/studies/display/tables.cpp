#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/text_columns.h"
#include "sim/studies/display/show.h"
#include "sim/studies/processors.h"

namespace csgsim::studies {

namespace {

using TextLines = std::vector<std::vector<std::string>>;
using DisplayRows = std::span<const DisplayStudyRow>;

/// Rows with the same method and bucket size.
struct MethodGroup {
  std::string name;
  std::vector<const DisplayStudyRow*> rows;
};

std::vector<MethodGroup> by_method(DisplayRows rows) {
  std::vector<MethodGroup> groups;
  for (const DisplayStudyRow& row : rows) {
    const std::string name = row.point.bucket_size == 0 ? row.point.method
                                                        : fmt::format("{}, {}, buckets of {}", row.point.method,
                                                                      row.point.directory, row.point.bucket_size);
    auto group = std::ranges::find(groups, name, &MethodGroup::name);
    if (group == groups.end()) group = groups.insert(group, {name, {}});
    group->rows.push_back(&row);
  }
  return groups;
}

class Table {
 public:
  explicit Table(const MethodGroup& group) : group_(group) {}

  void add(const std::string& what, const std::function<std::string(const DisplayStudyRow&)>& text) {
    std::vector<std::string>& line = lines_.emplace_back(std::vector<std::string>{what});
    for (const DisplayStudyRow* const row : group_.rows) line.push_back(row->is_drawn() ? text(*row) : "-");
  }
  /// Adds a count unless it is 0 in all rows.
  void add(const std::string& what, std::uint64_t DisplayStudyRow::*count) {
    if (std::ranges::all_of(group_.rows, [&](const DisplayStudyRow* row) { return row->*count == 0; })) return;
    add(what, [&](const DisplayStudyRow& row) { return grouped(row.*count); });
  }
  void print() const { fmt::print("{}", session::format_columns(lines_, "<" + std::string(group_.rows.size(), '>'))); }

 private:
  const MethodGroup& group_;
  TextLines lines_;
};

void add_seconds(Table& table, const MethodGroup& group, const software::Priced& processor) {
  for (std::size_t phase = 0; phase < software::phases; ++phase) {
    const bool is_none = std::ranges::none_of(group.rows, [&](const DisplayStudyRow* row) {
      return display_seconds(*row, processor).of[phase].value_or(0) > 0;
    });
    if (is_none) continue;
    table.add(fmt::format("{}: {}, s", processor.name, software::phase_rows[phase].meaning),
              [&](const DisplayStudyRow& row) {
                return seconds_text(display_seconds(row, processor).of[phase].value_or(0));
              });
  }
  table.add(processor.name + ": total without preprocessing, s",
            [&](const DisplayStudyRow& row) { return seconds_text(display_seconds(row, processor).total); });
}

void print_group(const MethodGroup& group, std::span<const software::Priced> processors) {
  fmt::print("\n{}\n", group.name);
  Table table(group);
  table.add("facets", [](const DisplayStudyRow& row) { return faceting_text(row.point); });
  table.add("polygons", &DisplayStudyRow::polygons);
  const bool is_clipped = group.rows.front()->point.bucket_size != 0;
  if (is_clipped) table.add("after clipping", &DisplayStudyRow::clipped_polygons);
  table.add("  in several cells", &DisplayStudyRow::shared_polygons);
  table.add("  cut by cells", &DisplayStudyRow::references);
  table.add("visible polygons", &DisplayStudyRow::drawn_polygons);
  table.add("cells", &DisplayStudyRow::cells);
  table.add("cells and halves visited", &DisplayStudyRow::cell_visits);
  table.add("polygon-cell tests", &DisplayStudyRow::overlap_tests);
  table.add("polygon-polygon tests", &DisplayStudyRow::crossing_tests);
  table.add("overfull cells", &DisplayStudyRow::overfull_cells);
  table.add("ordering conflicts", &DisplayStudyRow::conflicts);
  table.add("passes", &DisplayStudyRow::passes);
  table.add("spans", &DisplayStudyRow::spans);
  table.add("split spans", &DisplayStudyRow::splits);
  table.add("pixel events", &DisplayStudyRow::pixel_events);
  table.add("evaluations", &DisplayStudyRow::evaluations);
  for (const software::Priced& processor : processors) add_seconds(table, group, processor);
  table.add("words", &DisplayStudyRow::words);
  table.add("wrong pixels", [](const DisplayStudyRow& row) { return grouped(row.wrong); });
  table.add("  depth resolution", &DisplayStudyRow::wrong_depth_bits);
  table.add("  coincident faces", &DisplayStudyRow::wrong_coincident);
  table.add("  three or more surfaces", &DisplayStudyRow::wrong_three_way);
  table.add("  order", &DisplayStudyRow::wrong_order);
  table.print();
  for (const DisplayStudyRow* const row : group.rows) {
    if (!row->is_drawn()) fmt::print("  {}: {}\n", faceting_text(row->point), row->reason);
  }
}

}  // namespace

std::string faceting_text(const DisplayPoint& point) {
  if (point.tolerance) return fmt::format("within {:g}", *point.tolerance);
  return point.fragments == 0 ? "own" : fmt::format("$fn = {}", point.fragments);
}

void print_display(DisplayRows rows, std::span<const software::Priced> processors) {
  for (const MethodGroup& group : by_method(rows)) print_group(group, processors);
}

}  // namespace csgsim::studies
