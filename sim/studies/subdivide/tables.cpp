#include <fmt/format.h>

#include <array>

#include "hw/base/text.h"
#include "sim/studies/subdivide/show.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const SubdivideRow>;

template <class Text>
void print_line(const char* what, Rows rows, Text text) {
  fmt::print("  {:<66}", what);
  for (const SubdivideRow& row : rows) fmt::print("{:>12}", text(row));
  fmt::print("\n");
}

std::string mean_text(double mean) { return fmt::format("{:.1f}", mean); }

/// A row of seconds: ours, and those of thesis table 7.3 for models with `thesis_halfspaces` half-spaces.
struct StageRow {
  const char* name;
  std::optional<double> Stages::*seconds;
  std::array<double, 3> thesis;
};

constexpr std::array<unsigned, 3> thesis_halfspaces{1258, 2042, 3876};

// The thesis's scan conversion, classification and depth sort are the work of its nodes at pixels.
constexpr auto stage_rows = std::to_array<StageRow>({
    {"transformation of half-spaces, s", &Stages::transformation, {6.4, 10.2, 19.0}},
    {"first pruning, s", &Stages::first_pruning, {12.8, 20.3, 38.0}},
    {"second pruning, s", &Stages::second_pruning, {2.4, 3.4, 5.4}},
    {"communication, s", &Stages::communication, {0.2, 0.3, 0.5}},
    {"rendering, s", &Stages::rendering, {67.3, 67.7, 76.2}},
    {"  scan conversion, s", &Stages::scan_conversion, {32.6, 34.5, 42.3}},
    {"  CSG classification, s", &Stages::classification, {29.1, 27.6, 28.3}},
    {"  depth sort, s", &Stages::depth_sort, {5.6, 5.6, 5.6}},
    {"total, s", &Stages::total, {89.7, 102.5, 139.7}},
});

void print_stages(Rows rows) {
  print_line("half-space tests of the first pruning", rows,
             [](const SubdivideRow& row) { return grouped(row.stages.halfspace_tests.value_or(0)); });
  print_line("  half-spaces of the primitives that touch a segment, total", rows,
             [](const SubdivideRow& row) { return grouped(row.stages.halfspaces_touching.value_or(0)); });
  print_line("mean half-spaces broadcast per drawn segment", rows,
             [](const SubdivideRow& row) { return mean_text(row.stages.broadcast_halfspaces.value_or(0)); });
  print_line("clocks per frame", rows,
             [](const SubdivideRow& row) { return grouped(row.subsegments.clocks.value_or(0)); });
  fmt::print("\n  {:<66}{:>{}}\n", "", "thesis table 7.3, half-spaces:", 12 * rows.size() + 36);
  fmt::print("  {:<66}", "");
  for (const SubdivideRow& row : rows) fmt::print("{:>12}", grouped(row.halfspaces));
  for (const unsigned halfspaces : thesis_halfspaces) fmt::print("{:>12}", grouped(halfspaces));
  fmt::print("\n");
  for (const StageRow& stage : stage_rows) {
    fmt::print("  {:<66}", stage.name);
    for (const SubdivideRow& row : rows) fmt::print("{:>12.2f}", (row.stages.*stage.seconds).value_or(0));
    for (const double seconds : stage.thesis) fmt::print("{:>12.1f}", seconds);
    fmt::print("\n");
  }
}

/// A mean over squares.
struct MeanRow {
  const char* name;
  Squares SubdivideRow::*squares;
  double Squares::*mean;
};

void print_means(Rows rows, std::span<const MeanRow> means) {
  for (const MeanRow& one : means)
    print_line(one.name, rows, [&](const SubdivideRow& row) { return mean_text(row.*one.squares.*one.mean); });
}

}  // namespace

void print_subdivision(Rows rows) {
  if (rows.front().tolerance)
    print_line("tolerance, model units", rows,
               [](const SubdivideRow& row) { return fmt::format("{:g}", row.tolerance.value_or(0)); });
  print_line("levels of subdivision", rows, [](const SubdivideRow& row) { return row.subdivisions; });
  print_line("segments", rows, [](const SubdivideRow& row) { return row.segments.count; });
  print_line("  touched by a primitive", rows, [](const SubdivideRow& row) { return row.segments.touched; });
  print_line("subsegments", rows, [](const SubdivideRow& row) { return row.subsegments.count; });
  print_line("  touched by a primitive", rows, [](const SubdivideRow& row) { return row.subsegments.touched; });
  print_line("primitives in the model", rows, [](const SubdivideRow& row) { return row.primitives; });
  constexpr MeanRow primitives[] = {{"  mean per segment", &SubdivideRow::segments, &Squares::primitives},
                                    {"  mean drawn per segment", &SubdivideRow::segments, &Squares::kept_primitives},
                                    {"  mean comparisons per segment", &SubdivideRow::segments, &Squares::comparisons}};
  print_means(rows, primitives);
  print_line("half-spaces in the model", rows, [](const SubdivideRow& row) { return row.halfspaces; });
  constexpr MeanRow halfspaces[] = {
      {"  mean of the primitives in a segment", &SubdivideRow::segments, &Squares::halfspaces},
      {"  mean per segment after the first pruning", &SubdivideRow::segments, &Squares::kept_halfspaces},
      {"  mean per subsegment after the second pruning", &SubdivideRow::subsegments, &Squares::kept_halfspaces}};
  print_means(rows, halfspaces);
  if (rows.front().has_stages()) return print_stages(rows);
  print_line("clocks per frame, squares as large as segments", rows,
             [](const SubdivideRow& row) { return grouped(row.segments.clocks.value_or(0)); });
  print_line("clocks per frame, squares as large as subsegments", rows,
             [](const SubdivideRow& row) { return grouped(row.subsegments.clocks.value_or(0)); });
}

}  // namespace csgsim::studies
