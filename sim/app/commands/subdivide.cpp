#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/multi_processor/kind.h"
#include "hw/pixel_square/kind.h"
#include "sim/app/commands/commands.h"
#include "sim/shell/lists.h"
#include "sim/shell/memory.h"
#include "sim/shell/model_options.h"
#include "sim/shell/numbers.h"
#include "sim/shell/options.h"
#include "sim/shell/paths.h"
#include "sim/shell/read_by.h"
#include "sim/studies/subdivide/measure.h"
#include "sim/studies/tolerances.h"

namespace csgsim::app {

namespace {

/// Subsegments of a segment along a side: those of thesis 7.4.
constexpr std::uint32_t subsegments_a_side = 4;

struct Options {
  ModelOptions model;
  std::string levels = "4,6,8";
  std::string tolerances;
  std::string json;
};

/// One column of the tables.
struct Column {
  unsigned levels = 0;  ///< of binary subdivision, into segments
  std::optional<double> tolerance;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
  studies::Squares segments;
  studies::Squares subsegments;
  std::optional<studies::Stages> stages;  ///< of a multi-processor
};

/// Rounded up, so that the squares cover the picture.
std::uint32_t part_of(std::uint32_t side, std::uint32_t parts) { return std::max((side + parts - 1) / parts, 1U); }

/// What all columns are of.
struct Subject {
  machines::Machine machine;
  model::Tree tree;
};

Subject subject_of(const Options& options) {
  machines::Machine machine = machine_of(options.model);
  if (machine.kind != &pixel_square::kind && machine.kind != &multi_processor::kind)
    throw InputError(machine.name +
                     " does not draw square by square; take a machine of kind pixel-square or multi-processor");
  return {std::move(machine), read_model(options.model)};
}

Column measure(const Options& options, const Subject& subject, unsigned levels,
               const std::optional<double>& tolerance) {
  const auto& [machine, tree] = subject;
  const facet::Geometry scene = facet::make_geometry(
      tree, tolerance ? facet::Faceting{.tolerance = tolerance} : faceting_of(options.model, machine, tree));
  const view::View view =
      view::make_view(scene, tree, camera_of(options.model, machine, tree, scene), sampling_of(options.model, machine));
  const studies::Subdivided subdivided{tree, scene, view, machine, emit_options_of(options.model)};
  const machines::Size picture = machine.picture;
  const auto squares = [&](std::uint32_t columns, std::uint32_t rows) {
    return studies::measure_squares(subdivided, {part_of(picture.width, columns), part_of(picture.height, rows)});
  };
  Column column{levels, tolerance, tree.primitives.size(), 0, {}, {}, {}};
  for (const facet::Convex& solid : scene.solids) column.halfspaces += solid.halfspaces.size() + solid.quadrics.size();
  if (machine.kind == &multi_processor::kind) {
    column.stages = studies::measure_stages(subdivided, levels);
    column.segments = column.stages->segments;
    column.subsegments = column.stages->subsegments;
    return column;
  }
  const std::uint32_t columns = 1U << (levels + 1) / 2;
  const std::uint32_t rows = 1U << levels / 2;
  column.segments = squares(columns, rows);
  column.subsegments = squares(columns * subsegments_a_side, rows * subsegments_a_side);
  return column;
}

template <class Text>
void print_line(const char* what, const std::vector<Column>& columns, Text text) {
  fmt::print("  {:<66}", what);
  for (const Column& column : columns) fmt::print("{:>12}", text(column));
  fmt::print("\n");
}

std::string mean_text(double mean) { return fmt::format("{:.1f}", mean); }

/// A row of seconds: ours, and those of thesis table 7.3, whose models have so many half-spaces.
struct StageRow {
  const char* name;
  double studies::StageSeconds::*seconds;
  std::array<double, 3> thesis;
};

constexpr std::array<unsigned, 3> thesis_halfspaces{1258, 2042, 3876};

// Its scan conversion, classification and depth sort are what its nodes do to pixels.
constexpr auto stage_rows = std::to_array<StageRow>({
    {"transformation of half-spaces, s", &studies::StageSeconds::transformation, {6.4, 10.2, 19.0}},
    {"first pruning, s", &studies::StageSeconds::first_pruning, {12.8, 20.3, 38.0}},
    {"second pruning, s", &studies::StageSeconds::second_pruning, {2.4, 3.4, 5.4}},
    {"communication, s", &studies::StageSeconds::communication, {0.2, 0.3, 0.5}},
    {"rendering, s", &studies::StageSeconds::rendering, {67.3, 67.7, 76.2}},
    {"  scan conversion, s", &studies::StageSeconds::scan_conversion, {32.6, 34.5, 42.3}},
    {"  CSG classification, s", &studies::StageSeconds::classification, {29.1, 27.6, 28.3}},
    {"  depth sort, s", &studies::StageSeconds::depth_sort, {5.6, 5.6, 5.6}},
    {"total, s", &studies::StageSeconds::total, {89.7, 102.5, 139.7}},
});

void print_stages(const std::vector<Column>& columns) {
  print_line("half-space tests of the first pruning", columns,
             [](const Column& c) { return grouped(c.stages->halfspace_tests); });
  print_line("  half-spaces of the primitives that touch a segment, in all", columns,
             [](const Column& c) { return grouped(c.stages->halfspaces_touching); });
  print_line("mean of half-spaces broadcast for a segment that is drawn", columns,
             [](const Column& c) { return mean_text(c.stages->broadcast_halfspaces); });
  print_line("clocks of a frame", columns, [](const Column& c) { return grouped(c.subsegments.clocks); });
  fmt::print("\n  {:<66}{:>{}}\n", "", "thesis table 7.3, half-spaces:", 12 * columns.size() + 36);
  fmt::print("  {:<66}", "");
  for (const Column& column : columns) fmt::print("{:>12}", grouped(column.halfspaces));
  for (const unsigned halfspaces : thesis_halfspaces) fmt::print("{:>12}", grouped(halfspaces));
  fmt::print("\n");
  for (const StageRow& row : stage_rows) {
    fmt::print("  {:<66}", row.name);
    for (const Column& column : columns) fmt::print("{:>12.2f}", column.stages->seconds.*row.seconds);
    for (const double seconds : row.thesis) fmt::print("{:>12.1f}", seconds);
    fmt::print("\n");
  }
}

void print_table(const std::vector<Column>& columns) {
  if (columns.front().tolerance) {
    print_line("tolerance, model units", columns, [](const Column& c) { return fmt::format("{:g}", *c.tolerance); });
  }
  print_line("levels of subdivision", columns, [](const Column& c) { return c.levels; });
  print_line("segments", columns, [](const Column& c) { return c.segments.count; });
  print_line("  of them touched by a primitive", columns, [](const Column& c) { return c.segments.touched; });
  print_line("subsegments", columns, [](const Column& c) { return c.subsegments.count; });
  print_line("  of them touched by a primitive", columns, [](const Column& c) { return c.subsegments.touched; });
  print_line("primitives in the model", columns, [](const Column& c) { return c.primitives; });
  print_line("  mean in a segment", columns, [](const Column& c) { return mean_text(c.segments.primitives); });
  print_line("  mean drawn in a segment", columns,
             [](const Column& c) { return mean_text(c.segments.kept_primitives); });
  print_line("  mean comparisons in a segment", columns,
             [](const Column& c) { return mean_text(c.segments.comparisons); });
  print_line("half-spaces in the model", columns, [](const Column& c) { return c.halfspaces; });
  print_line("  mean of the primitives in a segment", columns,
             [](const Column& c) { return mean_text(c.segments.halfspaces); });
  print_line("  mean in a segment after the first pruning", columns,
             [](const Column& c) { return mean_text(c.segments.kept_halfspaces); });
  print_line("  mean in a subsegment after the second pruning", columns,
             [](const Column& c) { return mean_text(c.subsegments.kept_halfspaces); });
  if (columns.front().stages) return print_stages(columns);
  print_line("clocks of a frame, squares as large as segments", columns,
             [](const Column& c) { return grouped(c.segments.clocks); });
  print_line("clocks of a frame, squares as large as subsegments", columns,
             [](const Column& c) { return grouped(c.subsegments.clocks); });
}

nlohmann::ordered_json to_json(const studies::Squares& squares) {
  return {{"count", squares.count},
          {"touched", squares.touched},
          {"primitives_mean", squares.primitives},
          {"halfspaces_mean", squares.halfspaces},
          {"kept_primitives_mean", squares.kept_primitives},
          {"kept_halfspaces_mean", squares.kept_halfspaces},
          {"comparisons_mean", squares.comparisons},
          {"clocks", squares.clocks},
          {"instruction_clocks", squares.instruction_clocks}};
}

nlohmann::ordered_json to_json(const studies::Stages& stages) {
  const studies::StageSeconds& seconds = stages.seconds;
  return {{"first_halfspace_tests", stages.halfspace_tests},
          {"halfspaces_touching", stages.halfspaces_touching},
          {"broadcast_halfspaces_mean", stages.broadcast_halfspaces},
          {"seconds",
           {{"transformation", seconds.transformation},
            {"first_pruning", seconds.first_pruning},
            {"second_pruning", seconds.second_pruning},
            {"communication", seconds.communication},
            {"rendering", seconds.rendering},
            {"scan_conversion", seconds.scan_conversion},
            {"classification", seconds.classification},
            {"depth_sort", seconds.depth_sort},
            {"total", seconds.total}}}};
}

nlohmann::ordered_json to_json(const std::vector<Column>& columns) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Column& column : columns) {
    nlohmann::ordered_json one{{"subdivisions", column.levels}};
    if (column.tolerance) one["tolerance"] = *column.tolerance;
    one["primitives"] = column.primitives;
    one["halfspaces"] = column.halfspaces;
    one["segments"] = to_json(column.segments);
    one["subsegments"] = to_json(column.subsegments);
    if (column.stages) {
      for (const char* key : {"segments", "subsegments"}) one[key].erase("instruction_clocks");
      one["segments"].erase("clocks");  // of a frame that no machine draws so
      one["stages"] = to_json(*column.stages);
    }
    json.push_back(std::move(one));
  }
  return json;
}

std::vector<unsigned> levels_of(const std::string& text) {
  constexpr unsigned most_levels = 20;
  return parse_numbers(text, 0, most_levels);
}

void run(const Options& options) {
  refuse_clashes(options.model.inputs(), std::to_array<std::filesystem::path>({options.json}));
  std::optional<OutputFile> file;
  if (!options.json.empty()) file.emplace(options.json);
  const Subject subject = subject_of(options);
  std::vector<Column> columns;
  const auto add = [&](unsigned level, const std::optional<double>& tolerance) {
    columns.push_back(measure(options, subject, level, tolerance));
  };
  const std::vector<double> tolerances =
      options.tolerances.empty() ? std::vector<double>{} : studies::tolerances_in(options.tolerances);
  for (const unsigned level : levels_of(options.levels)) {
    if (tolerances.empty()) add(level, std::nullopt);
    for (const double tolerance : tolerances) add(level, tolerance);
  }
  fmt::print("{}: what subdivision leaves to do in a square, as in tables 7.2 and 7.3 of the thesis\n",
             printable(shown_name(options.model.model)));
  print_table(columns);
  if (!file) return;
  file->write(to_json(columns).dump(2) + "\n");
  file->commit();
}

}  // namespace

void add_subdivide(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  options->model.machine = "pixel-square";
  Command command = line.add(
      "subdivide", "Show what subdividing the picture leaves to do in each square",
      "Example:\n  csgsim subdivide carburettor.csg --size 256x256 --camera 220,-255,135,2,0,5\n"
      "  csgsim subdivide carburettor.csg --size 256x256 --subdivisions 6 --tolerances 0.2,0.05,0.01\n"
      "Levels are binary subdivisions of the picture into segments; each has 4 x 4 subsegments. On a machine of\n"
      "kind multi-processor they are its own segments, with a subsegment a node, and the times of its stages\n"
      "stand beside the thesis's.");
  options->model.add_to(command);
  command.option("--subdivisions", options->levels, "Numbers: levels of binary subdivision, 0 to 20")
      .check(is_read_by(levels_of));
  command
      .option("--tolerances", options->tolerances,
              "List of tolerances, model units, that curved solids are faceted with")
      .check(is_read_by(studies::tolerances_in))
      .excludes("--tolerance");
  command.option("-o,--output", options->json, "The same figures, .json").check(not_empty);
  command.prints_summary();
  command.runs([options] { run(*options); });
}

}  // namespace csgsim::app
