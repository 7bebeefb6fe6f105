#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>

#include "host/csg/positive_tree.h"
#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/memory.h"
#include "sim/app/model_options.h"
#include "sim/app/numbers.h"
#include "sim/app/options.h"
#include "sim/app/read_by.h"
#include "sim/app/report_option.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/studies.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/studies/tolerances.h"
#include "sim/app/version.h"
#include "sim/observe/long_work.h"
#include "sim/study/measure.h"
#include "sim/study/pareto.h"
#include "sim/study/plot_stem.h"
#include "sim/study/plots.h"
#include "sim/study/ranges.h"
#include "sim/study/table.h"

namespace csgsim::app {

namespace {

using Table = study::Table<study::Measurement>;

struct Options {
  ModelOptions model;
  std::string folder;
  unsigned views = 4;
  std::string knobs;
  std::string tolerances;
  std::optional<study::Shard> shard;
  bool no_plots = false;
  ReportOption report;
  std::string progress = "auto";
};

std::string title_of(const Options& options, const Command& command) {
  return study_title(command, {}) + " of " + escaped(std::filesystem::path(options.model.model).filename().native());
}

void print_row(const study::Measurement& row) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13.2e}{:>10.2f}{:>11}{:>13.2e}{:>9.3f}\n", row.knob, row.value,
             row.clocks, row.halfspaces, row.memory_bits, row.wrong, row.unexplained, row.depth_p999,
             row.depth_p999_steps, row.facet_wrong, row.facet_depth_p999, row.picture_difference);
}

void print_table(const std::vector<study::Measurement>& rows, unsigned views) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13}{:>10}{:>11}{:>13}{:>9}\n", "knob", "value", "clocks",
             "planes", "bits", "wrong", "unexpl.", "depth p99.9", "in steps", "facet diff", "facet p99.9", "colour");
  for (const study::Measurement& row : rows) print_row(row);
  if (views > 1)
    fmt::print("Clocks and pixels are sums of {} views, depths those of the worst; p99.9: the 99.9th percentile.\n",
               views);
}

/// Those at which z bits and fraction bits are turned together.
std::vector<study::Measurement> of_both(const std::vector<study::Measurement>& rows) {
  std::vector<study::Measurement> together;
  for (const study::Measurement& row : rows) {
    if (row.knob == "together") together.push_back(row);
  }
  return together;
}

void print_front(const std::vector<study::Measurement>& rows) {
  const std::vector<study::Measurement> front = study::pareto_front(of_both(rows));
  if (front.empty()) return;
  fmt::print("\nPareto front of z bits / fraction bits:\n");
  for (const study::Measurement& row : front)
    fmt::print("  {:>6}{:>12} clocks{:>10} wrong pixels\n", row.value, row.clocks, row.wrong);
  for (const study::Halving& step : study::halvings(front)) {
    fmt::print("From {} to {}: {} wrong pixels become {} for {:.1f} % more clocks\n", step.from.value, step.to.value,
               step.from.wrong, step.to.wrong, 100.0 * step.more_clocks);
  }
}

void print_equal(const std::vector<study::Measurement>& rows) {
  for (const study::EqualFacets& one : study::facets_as_right(rows)) {
    fmt::print("\n{} curves: {} clocks, {} off the curved surfaces\n", one.curved.value, grouped(one.curved.clocks),
               counted(one.curved.facet_wrong, "pixel"));
    fmt::print(
        "{}: {} {}, {} clocks, {:.3g} times as many, {} off\n",
        one.as_right ? "Facets as right" : "No facets tried are as right; the nearest", one.facets.knob,
        one.facets.value, grouped(one.facets.clocks),
        static_cast<double>(one.facets.clocks) / static_cast<double>(std::max<std::uint64_t>(one.curved.clocks, 1)),
        counted(one.facets.facet_wrong, "pixel"));
  }
}

/// Whether the knob was asked for by its name.
bool names_knob(const Options& options, const std::string& knob) {
  if (options.knobs.empty()) return false;
  const std::vector<std::string> named = study::parse_words(options.knobs);
  return std::ranges::find(named, knob) != named.end();
}

/// Those that can be drawn; none if that is facets alone, unless they are asked for. Says what is left out, and why.
std::vector<study::CurvesChoice> curves_of(const Options& options, const machines::Machine& machine,
                                           const model::Tree& tree, const view::Camera& camera) {
  const emit::Options emit = emit_options_of(options.model);
  const emit::Look look = emit::make_look(emit.scene, tree, csg::make_positive(tree), camera);
  std::vector<study::CurvesChoice> possible;
  std::vector<std::string> left_out;
  for (const study::CurvesChoice& choice : study::curves_choices()) {
    if (const auto reason = choice.why_not({tree, camera, machine, emit, look}))
      left_out.push_back(fmt::format("not {}: {}", emit::name_of(choice.curves), *reason));
    else
      possible.push_back(choice);
  }
  if (possible.size() > 1) {
    for (const std::string& reason : left_out) tell_line("--knobs curves, " + reason);
    return possible;
  }
  if (names_knob(options, "curves"))
    throw InputError(fmt::format("--knobs curves, facets alone; {}", fmt::join(left_out, "; ")));
  return {};
}

study::Knobs knobs_of(const Options& options, const machines::Machine& machine, const model::Tree& tree,
                      const facet::Scene& scene, const view::Camera& camera) {
  study::Knobs knobs;
  if (!options.knobs.empty()) knobs.names = study::parse_words(options.knobs);
  knobs.tolerances = options.tolerances.empty() ? study::usual_tolerances(glm::length(scene.box.high - scene.box.low))
                                                : tolerances_in(options.tolerances);
  if (std::ranges::find(knobs.names, "curves") != knobs.names.end())
    knobs.curves = curves_of(options, machine, tree, camera);
  return knobs;
}

/// All that is measured.
struct Study {
  model::Tree tree;
  machines::Machine machine;
  view::Camera camera;
  std::vector<study::WantedSettings> wanted;
};

Study study_of(const Options& options) {
  machines::Machine machine = machine_of(options.model);
  const std::string machine_hash = study::hash_of(machine);
  machine.array.memory_bits = study::ample_memory_bits;
  ModelFile file = read_model_file(options.model);
  const facet::Faceting faceting = faceting_of(options.model, machine, file.tree);
  const facet::Scene scene = facet::make_scene(file.tree, faceting);
  if (scene.box.empty()) throw InputError(options.model.model + ": nothing in it to measure; every solid is empty");
  const view::Camera camera = camera_of(options.model, machine, file.tree, scene);
  refuse_see_through(options.model, file.tree, camera);
  std::vector<study::WantedSettings> wanted;
  const study::Inputs inputs{file.hash, machine_hash, version_and_build()};
  for (study::Settings& point : study::points(sampling_of(options.model, machine), faceting,
                                              knobs_of(options, machine, file.tree, scene, camera))) {
    // Small pictures cannot be divided as often: some sizes are the same.
    const bool is_known = std::any_of(wanted.begin(), wanted.end(), [&](const study::WantedSettings& one) {
      return one.point.knob == point.knob && one.point.value == point.value;
    });
    if (!is_known) wanted.push_back({std::move(point), inputs});
  }
  return {std::move(file.tree), std::move(machine), camera, std::move(wanted)};
}

study::Meter meter_of(const Options& options, const Study& study) {
  return {study.tree, study::turned_views(study.camera, options.views), study.machine, emit_options_of(options.model)};
}

study::Measurement measure(const study::WantedSettings& wanted, const Study& study, study::Meter& meter) {
  const view::Sampling& sampling = wanted.point.sampling;
  study::Measurement row = with_memory_for_picture({sampling.width, sampling.height, study.machine.array.memory_bits},
                                                   [&] { return meter.measure(wanted.point); });
  row.inputs = wanted.inputs;
  return row;
}

void complete(const Options& options, const Study& study, Table& table) {
  study::Meter meter = meter_of(options, study);
  const bool show = shows_progress(options.progress);
  sim::LongWork work("this study", "fewer --views and a smaller --size take less; what is measured is kept");
  std::size_t number = 0;
  std::size_t known = 0;
  for (const study::WantedSettings& wanted : study.wanted) {
    ++number;
    if (table.find(wanted) != nullptr) {
      ++known;
      continue;
    }
    if (show)
      tell(fmt::format("\r\x1b[K{} of {} points: {} {}", number, study.wanted.size(), wanted.point.knob,
                       wanted.point.value));
    table.add(measure(wanted, study, meter));
    work.at_point(number - known, study.wanted.size() - known);
  }
  if (show) tell("\r\x1b[K");
}

report::Page page_of(const Options& options, const std::string& points, const std::vector<study::Measurement>& rows) {
  std::vector<std::string> front;
  for (const study::Measurement& row : study::pareto_front(of_both(rows))) front.push_back(row.value);
  return report::accuracy_page(report::Json::parse(points), front, options.views,
                               study_context(options.report, options.model, {{machine_of(options.model)}}));
}

void run_shard(const Options& options, const Command& command) {
  const Study study = study_of(options);
  study::Meter meter = meter_of(options, study);
  measure_shard<study::Measurement>(command, options.folder, *options.shard, study.wanted, options.progress,
                                    [&](const std::vector<std::size_t>& points, const auto& finished) {
                                      for (const std::size_t i : points)
                                        finished(measure(study.wanted[i], study, meter));
                                    });
}

void run(const Options& options, const Command& command, const study::Gathered* gathered) {
  if (options.shard) return run_shard(options, command);
  std::optional<Study> study;
  if (gathered == nullptr) study = study_of(options);
  const StudyFolder folder(options.folder, "accuracy", options.model.inputs());
  ReportFile report(options.report, options.model.inputs());
  const std::string title = title_of(options, command);
  const std::filesystem::path table_path = folder.path() / "accuracy.csv";
  Table table(table_path, title);
  if (study) {
    tell_stale(table_path, table.drop_stale(std::span<const study::WantedSettings>(study->wanted)));
    complete(options, *study, table);
  } else {
    put_rows(*gathered, table_path, table);
  }
  print_table(table.rows(), options.views);
  print_front(table.rows());
  print_equal(table.rows());
  const std::string points = study::points_json(title, table.rows());
  write_file(folder.path() / "accuracy.json", points);
  if (!options.no_plots)
    study::draw_plots(table.rows(), {study::plot_stem(options.model.model), options.views}, folder.path());
  if (report.asked()) report.write(page_of(options, points, table.rows()));
  fmt::print("\n{}: accuracy.csv, accuracy.json{}\n", printable(options.folder),
             options.no_plots ? "" : ", and plots (.png, .svg) a knob and of the front");
}

void add(CommandLine& line, const study::Gathered* gathered) {
  const auto options = std::make_shared<Options>();
  Command command =
      line.add("accuracy", "Show what accuracy costs in clocks: turn every knob and measure the errors",
               "Example:\n  csgsim accuracy carburettor.csg --camera 220,-255,135,2,0,5 -o carburettor-accuracy\n"
               "What has been measured is in accuracy.csv at once; the same command goes on after an interruption.");
  options->model.add_to(command);
  command.remove("--memory-bits");  // what is needed is one of the results
  command.option("-o,--output", options->folder, "Folder for accuracy.csv, accuracy.json and the plots")
      .required()
      .check(not_empty);
  command.option("--views", options->views, "Views that a point is measured in: the camera turned about the vertical")
      .between(1, 64);
  command.option("--knobs", options->knobs, "Which knobs are turned; all if not given")
      .list_of(study::knob_names(), "knob");
  command
      .option("--tolerances", options->tolerances,
              "List of faceting tolerances, model units, in place of the usual ones, which are parts of the model's "
              "diagonal")
      .check(is_read_by(tolerances_in));
  command.flag("--no-plots", options->no_plots, "Do without plots (gnuplot)");
  add_shard(command, options->shard);
  options->report.add_to(command);
  add_progress(command, options->progress);
  command.prints_summary();
  command.runs([options, command, gathered] { run(*options, command, gathered); });
}

}  // namespace

void add_accuracy(CommandLine& line) { add(line, nullptr); }
void gather_accuracy(CommandLine& line, const study::Gathered& gathered) { add(line, &gathered); }

}  // namespace csgsim::app
