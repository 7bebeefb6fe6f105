#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/machine_list.h"
#include "sim/app/memory.h"
#include "sim/app/model_options.h"
#include "sim/app/numbers.h"
#include "sim/app/options.h"
#include "sim/app/paths.h"
#include "sim/app/read_by.h"
#include "sim/app/report_option.h"
#include "sim/app/settings/sets.h"
#include "sim/app/studies/compare_words.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/studies.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/studies/sweep_progress.h"
#include "sim/app/version.h"
#include "sim/study/comparison.h"
#include "sim/study/ideal.h"
#include "sim/study/plot_stem.h"
#include "sim/study/ranges.h"
#include "sim/study/table.h"

namespace csgsim::app {

namespace {

using Rows = std::vector<study::ComparisonRow>;
using Table = study::Table<study::ComparisonRow>;

constexpr unsigned most_fragments = 4096;

struct Options {
  ModelOptions model;
  std::string machines = all_machines();
  std::string sides = "128,256,512";
  std::string fragments = "8,16,32,64";
  std::string folder;
  std::optional<study::Shard> shard;
  bool ideal = false;
  bool no_plots = false;
  ReportOption report;
  std::string progress = "auto";
};

std::vector<unsigned> fragments_of(const std::string& text) {
  return text.empty() ? std::vector<unsigned>{} : study::parse_numbers(text, 3, most_fragments);
}
std::vector<unsigned> sides_of(const std::string& text) {
  return text.empty() ? std::vector<unsigned>{} : study::parse_numbers(text, 1, isa::max_array_side);
}

/// The machine, with the picture that --size asks for.
machines::Machine machine_named(const Options& options, const std::string& name) {
  ModelOptions one = options.model;
  one.machine = name;  // with its figures as set
  one.sets = sorted(one.sets).scene;
  return machine_of(one);
}

/// The machine's own picture, as the machine is and with one figure after the other made ideal.
std::vector<study::ComparisonPoint> ideal_points(const machines::Machine& machine, const std::string& name) {
  std::vector<study::ComparisonPoint> points{{name, machine.picture.width, machine.picture.height, 0}};
  for (const std::string& choice : study::ideal_choices(machine)) {
    points.push_back(points.front());
    points.back().ideal = choice;
  }
  return points;
}

/// The machine's own picture, with every number of fragments, and pictures of every size.
std::vector<study::ComparisonPoint> points_of(const Options& options, const std::string& machine,
                                              const machines::Size& base) {
  std::vector<study::ComparisonPoint> points{{machine, base.width, base.height, 0}};
  const auto add = [&](const study::ComparisonPoint& point) {
    if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
  };
  for (const unsigned fragments : fragments_of(options.fragments))
    add({machine, base.width, base.height, static_cast<double>(fragments)});
  for (const unsigned side : sides_of(options.sides)) add({machine, side, side, 0});
  return points;
}

struct Study {
  model::Tree tree;
  std::vector<study::ComparisonJob> jobs;
};

Study study_of(const Options& options) {
  ModelFile file = read_model_file(options.model);
  Study study{std::move(file.tree), {}};
  const facet::Scene scene = facet::make_scene(study.tree);
  for (const std::string& name : with_figures(study::parse_words(options.machines), options.model.sets)) {
    const machines::Machine machine = machine_named(options, name);
    const machines::Size base = machine.picture;
    const study::Inputs inputs{file.hash, study::hash_of(machine), version_and_build()};
    const view::Camera camera = camera_of(options.model, machine, study.tree, scene);
    for (study::ComparisonPoint& point :
         options.ideal ? ideal_points(machine, escaped(name)) : points_of(options, escaped(name), base)) {
      machines::Machine drawing = study::made_ideal(machine, point.ideal);
      view::Sampling sampling = sampling_of(options.model, machine);
      sampling.width = point.width;
      sampling.height = point.height;
      study.jobs.push_back(
          {{std::move(point), inputs}, std::move(drawing), camera, sampling, emit_options_of(options.model)});
    }
  }
  return study;
}

std::string title_of(const Options& options, const Command& command) {
  return study_title(command, {"machines", "sides", "fragments"}) + " of " +
         escaped(std::filesystem::path(options.model.model).filename().native());
}

std::vector<study::WantedComparison> wanted_of(const Study& study) {
  std::vector<study::WantedComparison> wanted;
  wanted.reserve(study.jobs.size());
  for (const study::ComparisonJob& job : study.jobs) wanted.push_back(job.wanted);
  return wanted;
}

study::ComparisonRow measure(const study::ComparisonJob& job, const Study& study) {
  return with_memory_for_picture({job.wanted.point.width, job.wanted.point.height, job.machine.array.memory_bits},
                                 [&] { return study::measure(job, study.tree); });
}

Rows complete(const Options& options, const Study& study, Table& table) {
  std::size_t known = 0;
  for (const study::ComparisonJob& job : study.jobs) {
    if (table.find(job.wanted) != nullptr) ++known;
  }
  SweepProgress progress(study.jobs.size(), known, shows_progress(options.progress));
  Rows rows;
  for (const study::ComparisonJob& job : study.jobs) {
    if (table.find(job.wanted) == nullptr) {
      table.add(measure(job, study));
      progress.done();
    }
    rows.push_back(*table.find(job.wanted));
  }
  return rows;
}

/// Columns of the machines' names, with a blank behind the longest.
std::size_t name_width(const Rows& rows) {
  std::size_t width = 16;
  for (const study::ComparisonRow& row : rows) width = std::max(width, row.point.machine.size() + 1);
  return width;
}

void print_row(const study::ComparisonRow& row, std::size_t width) {
  const std::string facets = row.point.fragments == 0 ? "own" : fmt::format("{}", row.point.fragments);
  fmt::print("{:<{}}{:>11}{:>7}", row.point.machine, width, fmt::format("{}x{}", row.point.width, row.point.height),
             facets);
  if (!row.drawn()) {
    fmt::print("  {}\n", row.reason);
    return;
  }
  fmt::print("{:>8}{:>13}{:>11.2f}{:>9.1f}{:>17}{:>10}{:>18}{:>13}{:>14}{:>8.3f}\n", row.halfspaces,
             grouped(row.clocks), row.seconds * 1e3, row.frames_per_second, grouped(row.pixel_operations),
             grouped(row.processors), grouped(row.processor_clocks), grouped(row.memory_bits),
             row.transistors ? grouped(*row.transistors) : "-", 100.0 * row.utilisation);
}

/// What each idealisation of a machine is worth, against the machine as it is, which comes before them.
void print_ideal_rows(const Rows& rows) {
  const std::size_t width = name_width(rows);
  fmt::print("{:<{}}{:<28}{:>13}{:>11}{:>9}{:>9}\n", "machine", width, "ideal", "clocks", "ms", "frames/s", "worth %");
  const study::ComparisonRow* as_it_is = nullptr;
  for (const study::ComparisonRow& row : rows) {
    if (row.point.ideal.empty()) as_it_is = &row;
    fmt::print("{:<{}}{:<28}", row.point.machine, width, row.point.ideal.empty() ? "as it is" : row.point.ideal);
    if (!row.drawn()) {
      fmt::print("  {}\n", row.reason);
      continue;
    }
    fmt::print("{:>13}{:>11.2f}{:>9.1f}", grouped(row.clocks), row.seconds * 1e3, row.frames_per_second);
    if (as_it_is != nullptr && as_it_is->drawn())
      fmt::print("{:>9.2f}", 100.0 * (1.0 - row.seconds / as_it_is->seconds));
    fmt::print("\n");
  }
}

void print_rows(const Rows& rows) {
  const std::size_t width = name_width(rows);
  fmt::print("{:<{}}{:>11}{:>7}{:>8}{:>13}{:>11}{:>9}{:>17}{:>10}{:>18}{:>13}{:>14}{:>8}\n", "machine", width,
             "picture", "$fn", "halfsp.", "clocks", "ms", "frames/s", "pixel operations", "process.",
             "processor clocks", "memory bits", "transistors", "used %");
  for (const study::ComparisonRow& row : rows) print_row(row, width);
  fmt::print("Transistors are a model (docs/area.md), of the processors with their memory; -: not synthesised.\n");
}

/// Pictures of the same size and facets have to be the same on every machine.
void refuse_differences(const Rows& rows, bool has_read_rows) {
  for (const study::ComparisonRow& row : rows) {
    const auto first = std::find_if(rows.begin(), rows.end(), [&](const study::ComparisonRow& other) {
      return other.drawn() && other.point.width == row.point.width && other.point.height == row.point.height &&
             other.point.fragments == row.point.fragments;
    });
    if (row.drawn() && first->picture != row.picture) {
      throw InputError(fmt::format("{} draws {}x{} pixels otherwise than {}; {}", row.point.machine, row.point.width,
                                   row.point.height, first->point.machine, whose_fault(has_read_rows)));
    }
  }
  if (std::none_of(rows.begin(), rows.end(), [](const study::ComparisonRow& row) { return row.drawn(); }))
    throw InputError(rows.front().reason);
  fmt::print("\nPictures of the same size and facets are the same on all machines, byte for byte.\n");
}

/// With a picture of the model on the first machine.
report::Page page_of(const Options& options, const std::string& points) {
  std::vector<machines::Machine> machines;
  for (const std::string& name : with_figures(study::parse_words(options.machines), options.model.sets))
    machines.push_back(machine_named(options, name));
  return report::compare_page(report::Json::parse(points), study_context(options.report, options.model, machines));
}

std::filesystem::path folder_of(const Options& options) {
  return options.folder.empty() ? study::plot_stem(options.model.model) + "-compare" : options.folder;
}

void run_shard(const Options& options, const Command& command) {
  const Study study = study_of(options);
  measure_shard<study::ComparisonRow>(command, folder_of(options), *options.shard, wanted_of(study), options.progress,
                                      [&](const std::vector<std::size_t>& points, const auto& finished) {
                                        for (const std::size_t i : points) finished(measure(study.jobs[i], study));
                                      });
}

/// Rows that the table has or gets.
Rows rows_of(const Options& options, const Study& study, const std::filesystem::path& table_path, Table& table) {
  tell_stale(table_path, table.drop_stale(std::span<const study::WantedComparison>(wanted_of(study))));
  return complete(options, study, table);
}

/// The first point is of the first machine's own picture.
machines::Size base_of(const Rows& rows) { return {rows.front().point.width, rows.front().point.height}; }

void run(const Options& options, const Command& command, const study::Gathered* gathered) {
  if (options.shard) return run_shard(options, command);
  std::optional<Study> study;
  if (gathered == nullptr) study = study_of(options);
  const auto inputs = input_files({options.model.model}, study::parse_words(options.machines));
  const StudyFolder folder(folder_of(options), "compare", inputs);
  ReportFile report(options.report, inputs);
  const std::string title = title_of(options, command);
  const std::filesystem::path table_path = folder.path() / "compare.csv";
  Table table(table_path, title);
  const bool has_read_rows = gathered != nullptr || !table.rows().empty();
  const Rows rows = study ? rows_of(options, *study, table_path, table) : put_rows(*gathered, table_path, table);
  const std::string points = study::points_json(title, rows);
  write_file(folder.path() / "compare.json", points);
  options.ideal ? print_ideal_rows(rows) : print_rows(rows);
  print_compare_words(rows);
  const bool plots = !options.no_plots && !options.ideal;
  if (plots) study::draw_comparison(rows, base_of(rows), study::plot_stem(options.model.model), folder.path());
  if (report.asked()) report.write(page_of(options, points));
  refuse_differences(rows, has_read_rows);
  fmt::print("{}: compare.csv, compare.json{}\n", printable(folder.path().native()),
             !plots ? "" : ", and plots (.png, .svg) of the machines and of the time against half-spaces and pixels");
}

void add(CommandLine& line, const study::Gathered* gathered) {
  const auto options = std::make_shared<Options>();
  Command command = line.add(
      "compare", "Draw a model on several machines: clocks, time, memory, utilisation, growth",
      "Example:\n  csgsim compare carburettor.csg --camera 220,-255,135,2,0,5\n"
      "  csgsim compare carburettor.csg --machines pixel-planes-4,mine.toml --sides 64,128 --fragments 8,16 -o out\n"
      "  csgsim compare carburettor.csg --camera 220,-255,135,2,0,5 --ideal -o carburettor-ideal\n"
      "What has been measured is in compare.csv at once; the same command goes on after an interruption.");
  options->model.add_to(command);
  command.remove("--machine");
  command.remove("--tolerance");
  command.remove("--curves");  // all machines draw the same facets
  command.option("--machines", options->machines, "List of machines, by name or .toml file");
  command
      .option("--fragments", options->fragments,
              "Numbers: $fn of all curved solids, to vary half-spaces at the machine's own size or that of --size; "
              "empty for the model's own only")
      .check(is_read_by(fragments_of));
  command.option("--sides", options->sides, "Numbers: sides of square pictures in pixels; empty for one size only")
      .check(is_read_by(sides_of));
  command
      .option("-o,--output", options->folder,
              "Folder for compare.csv, compare.json and the plots; MODEL-compare if not given")
      .check(not_empty);
  command.flag(
      "--ideal", options->ideal,
      "What each idealisation is worth: every figure of a machine that may be ideal is, one after the other and "
      "all at once; no other sizes or fragments, and no plots");
  command.flag("--no-plots", options->no_plots, "Do without plots (gnuplot)");
  add_shard(command, options->shard);
  options->report.add_to(command);
  add_progress(command, options->progress);
  command.prints_summary();
  command.runs([options, command, gathered] { run(*options, command, gathered); });
}

}  // namespace

void add_compare(CommandLine& line) { add(line, nullptr); }
void gather_compare(CommandLine& line, const study::Gathered& gathered) { add(line, &gathered); }

}  // namespace csgsim::app
