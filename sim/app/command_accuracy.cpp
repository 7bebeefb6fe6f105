#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <memory>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "sim/app/commands.h"
#include "sim/app/model_options.h"
#include "sim/app/study_files.h"
#include "sim/study/measure.h"
#include "sim/study/pareto.h"
#include "sim/study/plots.h"
#include "sim/study/table.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelOptions model;
  std::string folder;
  unsigned views = 4;
  bool no_plots = false;
  std::string progress = "auto";
};

std::string title_of(const Options& options, const machines::Machine& machine, const view::Camera& camera) {
  const machines::Size picture = machines::picture_size(machine);
  return fmt::format(
      "csgsim accuracy {} {} {}x{} camera {},{},{},{},{},{} {} views {} z-bits {} fraction-bits {} edge-on {} "
      "tolerance {}",
      std::filesystem::path(options.model.model).filename().string(), machine.name, picture.width, picture.height,
      camera.eye.x, camera.eye.y, camera.eye.z, camera.centre.x, camera.centre.y, camera.centre.z,
      options.model.projection, options.views, options.model.z_bits, options.model.fraction_bits, options.model.edge_on,
      tolerance_text(options.model));
}

void print_row(const study::Measurement& row) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13.2e}{:>10.2f}{:>11}{:>13.2e}{:>9.3f}\n", row.knob, row.value,
             row.clocks, row.halfspaces, row.memory_bits, row.wrong, row.unexplained, row.depth_p999,
             row.depth_p999_steps, row.facet_wrong, row.facet_depth_p999, row.picture_difference);
}

void print_table(const std::vector<study::Measurement>& rows) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13}{:>10}{:>11}{:>13}{:>9}\n", "knob", "value", "clocks",
             "planes", "bits", "wrong", "unexpl.", "depth p99.9", "in steps", "facet diff", "facet p99.9", "colour");
  for (const study::Measurement& row : rows) print_row(row);
}

void print_front(const std::vector<study::Measurement>& rows) {
  std::vector<study::Measurement> together;
  for (const study::Measurement& row : rows) {
    if (row.knob == "together") together.push_back(row);
  }
  const std::vector<study::Measurement> front = study::pareto_front(together);
  fmt::print("\nPareto front of z bits / fraction bits:\n");
  for (const study::Measurement& row : front)
    fmt::print("  {:>6}{:>12} clocks{:>10} wrong pixels\n", row.value, row.clocks, row.wrong);
  for (const study::Halving& step : study::halvings(front)) {
    fmt::print("From {} to {}: {} wrong pixels become {} for {:.1f} % more clocks\n", step.from.value, step.to.value,
               step.from.wrong, step.to.wrong, 100.0 * step.more_clocks);
  }
}

void run(const Options& options) {
  machines::Machine machine = machine_of(options.model);
  machine.array.memory_bits = study::ample_memory_bits;
  const model::Tree tree = read_model(options.model);
  const facet::Faceting faceting = faceting_of(options.model, machine, tree);
  const facet::Scene scene = facet::make_scene(tree, faceting);
  if (scene.box.empty()) throw InputError(options.model.model + ": nothing in it to measure; every solid is empty");
  const view::Camera camera = camera_of(options.model, machine, scene);
  const std::filesystem::path folder = study_folder(options.folder);

  const std::string title = title_of(options, machine, camera);
  study::Table<study::Measurement> table(folder / "accuracy.csv", title);
  study::Meter meter(tree, study::turned_views(camera, options.views), machine);
  const std::vector<study::Settings> points =
      study::points(sampling_of(options.model, machine), faceting, glm::length(scene.box.high - scene.box.low));
  const bool show = options.progress == "auto" && ::isatty(STDERR_FILENO) != 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (table.find(points[i]) != nullptr) continue;
    if (show)
      fmt::print(stderr, "\r\x1b[K{} of {} points: {} {}", i + 1, points.size(), points[i].knob, points[i].value);
    table.add(meter.measure(points[i]));
  }
  if (show) fmt::print(stderr, "\r\x1b[K");
  print_table(table.rows());
  print_front(table.rows());
  write_points(folder / "accuracy.json", title, table.rows(), study::to_json<study::Measurement>);
  if (!options.no_plots) {
    study::draw_plots(table.rows(), std::filesystem::path(options.model.model).stem().string(), folder);
  }
  fmt::print("\n{}: accuracy.csv, accuracy.json{}\n", options.folder,
             options.no_plots ? "" : ", and plots (.png, .svg) a knob and of the front");
}

}  // namespace

void add_accuracy(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *app.add_subcommand("accuracy", "Show what accuracy costs in clocks: turn every knob and measure the errors");
  command.footer(
      "Example:\n  csgsim accuracy carburettor.csg --camera 220,-255,135,2,0,5 -o carburettor-accuracy\n"
      "What has been measured is in accuracy.csv at once; the same command goes on after an interruption.");
  options->model.add_to(command);
  command.add_option("-o,--output", options->folder, "Folder for accuracy.csv, accuracy.json and the plots")
      ->required();
  command
      .add_option("--views", options->views, "Views that a point is measured in: the camera turned about the vertical")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command.add_flag("--no-plots", options->no_plots, "Do without plots (gnuplot)");
  command.add_option("--progress", options->progress, "auto (when standard error is a terminal) or none")
      ->check(CLI::IsMember({"auto", "none"}))
      ->capture_default_str();
  command.callback([options] { run(*options); });
}

}  // namespace csgsim::app
