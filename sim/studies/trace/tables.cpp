#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/text_columns.h"
#include "sim/studies/processors.h"
#include "sim/studies/trace/show.h"

namespace csgsim::studies {

namespace {

using Lines = std::vector<std::vector<std::string>>;
using Rows = std::span<const TraceRow>;

/// Prints lines; the first `names` columns are left-aligned, the others right-aligned.
void print_lines(const Lines& lines, std::size_t names) {
  std::string sides(names, '<');
  sides.append(lines.front().size() - names, '>');
  fmt::print("\n{}", session::format_columns(lines, sides));
}

std::string per_ray_text(std::uint64_t count, const TraceRow& row) {
  return row.rays == 0 ? "-" : fmt::format("{:.2f}", static_cast<double>(count) / static_cast<double>(row.rays));
}

std::string tolerance_text(const TraceRow& row) {
  return row.point.tolerance ? fmt::format("{:g}", *row.point.tolerance) : "-";
}

bool is_same_directory(const TraceRow& a, const TraceRow& b) {
  return a.point.directory == b.point.directory && a.point.bucket_size == b.point.bucket_size &&
         a.point.tolerance == b.point.tolerance;
}

/// Prints each directory once.
void print_directories(Rows rows, std::span<const software::Priced> processors) {
  Lines lines{{"directory", "bucket", "tolerance", "polygons", "loose", "cells", "entries", "facets in cells", "most",
               "overlap tests", "words"}};
  for (const software::Priced& processor : processors) lines.front().push_back("build, " + processor.name + ", s");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TraceRow& row = rows[i];
    const bool is_printed = std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(i),
                                        [&](const TraceRow& one) { return is_same_directory(one, row); });
    if (is_printed || !row.is_drawn()) continue;
    lines.push_back({row.point.directory, std::to_string(row.point.bucket_size), tolerance_text(row),
                     grouped(row.polygons), grouped(row.loose_facets), grouped(row.cells), grouped(row.entries),
                     grouped(row.references), grouped(row.most_facets), grouped(row.overlap_tests),
                     grouped(row.directory_words + row.bucket_words)});
    for (const software::Priced& processor : processors)
      lines.back().push_back(seconds_text(build_seconds_of(row, processor)));
  }
  print_lines(lines, 1);
}

std::vector<std::string> names_of(const TraceRow& row) {
  return {row.point.directory,  std::to_string(row.point.bucket_size),
          tolerance_text(row),  row.point.cast,
          row.point.facet_test, row.point.item_buffer};
}

const std::vector<std::string> name_titles{"directory", "bucket", "tolerance", "rays", "test", "item buffer"};

/// Prints what rays visit and hit, per primary ray.
void print_rays(Rows rows) {
  Lines lines{name_titles};
  for (const char* const title : {"cells per ray", "facets tested", "facets hit", "shadow rays", "mirror rays"})
    lines.front().emplace_back(title);
  for (const TraceRow& row : rows) {
    lines.push_back(names_of(row));
    if (!row.is_drawn()) {
      lines.back().push_back(row.reason);
      continue;
    }
    for (const std::uint64_t count :
         {row.cell_visits, row.facet_tests, row.facets_met, row.shadow_rays, row.mirror_rays})
      lines.back().push_back(per_ray_text(count, row));
  }
  print_lines(lines, 6);
}

void print_seconds(Rows rows, const software::Priced& processor) {
  Lines lines{name_titles};
  lines.front().push_back(processor.name + ", s");
  if (processor.processor) {
    for (const char* const title : {"projection", "traversal", "intersection", "classification", "shading"})
      lines.front().emplace_back(title);
  }
  for (const TraceRow& row : rows) {
    if (!row.is_drawn()) continue;
    const TraceSeconds seconds = seconds_of(row, processor);
    lines.push_back(names_of(row));
    lines.back().push_back(seconds_text(seconds.all));
    if (!processor.processor) continue;
    for (const double part :
         {seconds.projection, seconds.traversal, seconds.intersection, seconds.classification, seconds.shading})
      lines.back().push_back(seconds_text(part));
  }
  print_lines(lines, 6);
}

}  // namespace

void print_tracing(Rows rows, std::span<const software::Priced> processors) {
  const auto drawn = std::ranges::find_if(rows, &TraceRow::is_drawn);
  if (drawn != rows.end()) {
    fmt::print("{}, {}; {} of {} rays hit the solid\n", session::count_text(drawn->primitives, "primitive"),
               session::count_text(drawn->halfspaces, "half-space"), grouped(drawn->hit_rays), grouped(drawn->rays));
  }
  print_directories(rows, processors);
  print_rays(rows);
  for (const software::Priced& processor : processors) print_seconds(rows, processor);
}

}  // namespace csgsim::studies
