#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "host/csg/positive_tree.h"
#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "hw/machines/hash.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/see_through.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/version.h"
#include "sim/session/run/memory.h"
#include "sim/studies/accuracy/measure.h"
#include "sim/studies/accuracy/pareto.h"
#include "sim/studies/accuracy/plots.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

struct Options {
  ModelRequest model;
  unsigned views = 4;
  std::string knobs;
  std::string tolerances;
};

void print_row(const Measurement& row) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13.2e}{:>10.2f}{:>11}{:>13.2e}{:>9.3f}\n", row.knob, row.value,
             grouped(row.clocks), grouped(row.halfspaces), row.used_bits, grouped(row.wrong), grouped(row.unexplained),
             row.depth_p999, row.depth_p999_steps, grouped(row.facet_wrong), row.facet_depth_p999,
             row.picture_difference);
}

void print_table(std::span<const Measurement> rows, unsigned views) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13}{:>10}{:>11}{:>13}{:>9}\n", "knob", "value", "clocks",
             "planes", "bits", "wrong", "unexpl.", "depth p99.9", "in steps", "facet diff", "facet p99.9", "colour");
  for (const Measurement& row : rows) print_row(row);
  if (views > 1)
    fmt::print("Clocks and pixels are sums of {} views, depths those of the worst; p99.9: the 99.9th percentile.\n",
               views);
}

void print_front(std::span<const Measurement> rows) {
  const std::vector<Measurement> front = pareto_front(of_knob(rows, "together"));
  if (front.empty()) return;
  fmt::print("\nPareto front of z bits / fraction bits:\n");
  for (const Measurement& row : front)
    fmt::print("  {:>6}{:>12} clocks{:>10} wrong pixels\n", row.value, grouped(row.clocks), grouped(row.wrong));
  for (const Halving& step : halvings(front)) {
    fmt::print("From {} to {}: {} wrong pixels become {} for {:.1f} % more clocks\n", step.from.value, step.to.value,
               grouped(step.from.wrong), grouped(step.to.wrong), 100.0 * step.more_clocks);
  }
}

void print_equal(std::span<const Measurement> rows) {
  for (const EqualFacets& one : facets_as_right(rows)) {
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
  const std::vector<std::string> named = parse_words(options.knobs);
  return std::ranges::find(named, knob) != named.end();
}

/// Those that can be drawn; none if that is facets alone, unless they are asked for. Says what is left out, and why.
std::vector<CurvesChoice> curves_of(const Options& options, const machines::Machine& machine, const model::Tree& tree,
                                    const view::Camera& camera) {
  const emit::Options emit = emit_options_of(options.model);
  const emit::Look look = emit::make_look(emit.scene, tree, csg::make_positive(tree), camera);
  std::vector<CurvesChoice> possible;
  std::vector<std::string> left_out;
  for (const CurvesChoice& choice : curves_choices()) {
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

Knobs knobs_of(const Options& options, const machines::Machine& machine, const model::Tree& tree,
               const facet::Geometry& scene, const view::Camera& camera) {
  Knobs knobs;
  if (!options.knobs.empty()) knobs.names = parse_words(options.knobs);
  knobs.tolerances =
      options.tolerances.empty() ? usual_tolerances(scene.box.diagonal()) : tolerances_in(options.tolerances);
  if (std::ranges::find(knobs.names, "curves") != knobs.names.end())
    knobs.curves = curves_of(options, machine, tree, camera);
  return knobs;
}

class Accuracy : public StudyOf<Measurement> {
 public:
  void add_options(session::OptionList& command) override {
    options_.model.add_to(command);
    command.remove("--memory-bits");  // what is needed is one of the results
    command.option("--views", options_.views, "Views that a point is measured in: the camera turned about the vertical")
        .between(1, 64);
    command.option("--knobs", options_.knobs, "Which knobs are turned; all if not given").list_of(knob_names(), "knob");
    command
        .option("--tolerances", options_.tolerances,
                "List of faceting tolerances, model units, in place of the usual ones, which are parts of the model's "
                "diagonal")
        .check(is_read_by(tolerances_in));
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override { return options_.model.inputs(); }
  [[nodiscard]] std::string table_model() const override { return options_.model.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<Asked> ask() override {
    machine_ = machine_of(options_.model);
    ModelFile file = read_model_file(options_.model);
    const Inputs inputs{file.hash, machines::hash_of(machine_), version_and_build()};
    machine_.array.memory_bits = ample_memory_bits;
    tree_ = std::move(file.tree);
    const facet::Faceting faceting = faceting_of(options_.model, machine_, tree_);
    const facet::Geometry scene = facet::make_geometry(tree_, faceting);
    if (scene.box.empty()) throw InputError(options_.model.model + ": nothing in it to measure; every solid is empty");
    const view::Camera camera = camera_of(options_.model, machine_, tree_, scene);
    refuse_see_through(options_.model, tree_, camera);
    points_ =
        points(sampling_of(options_.model, machine_), faceting, knobs_of(options_, machine_, tree_, scene, camera));
    // Small pictures cannot be divided as often: some sizes are the same.
    std::set<std::string> known;
    std::erase_if(points_, [&](const Settings& point) { return !known.insert(cells_of(point)).second; });
    meter_ =
        std::make_unique<Meter>(tree_, turned_views(camera, options_.views), machine_, emit_options_of(options_.model));
    std::vector<Asked> asked;
    for (const Settings& point : points_) asked.push_back({cells_of(point), inputs});
    inputs_ = inputs;
    return asked;
  }

  void print() const override {
    print_table(rows(), options_.views);
    print_front(rows());
    print_equal(rows());
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return plots_of_accuracy(rows(), {plot_stem(options_.model.model), options_.views});
  }

  [[nodiscard]] std::string page_title() const override { return "What accuracy costs"; }
  [[nodiscard]] PageSubject page_subject() const override { return {options_.model, {machine_of(options_.model)}}; }

 protected:
  [[nodiscard]] Measurement measured(std::size_t point) override {
    const view::Sampling& sampling = points_[point].sampling;
    Measurement row = with_memory_for_picture({sampling.width, sampling.height, machine_.array.memory_bits},
                                              [&] { return meter_->measure(points_[point]); });
    row.inputs = inputs_;
    return row;
  }

 private:
  static std::string cells_of(const Settings& point) { return to_cell(point.knob) + "," + to_cell(point.value); }

  Options options_;
  model::Tree tree_;
  machines::Machine machine_;
  Inputs inputs_;
  std::vector<Settings> points_;
  std::unique_ptr<Meter> meter_;  ///< keeps pictures from point to point
};

}  // namespace

extern const StudyRow accuracy_row{
    .name = "accuracy",
    .does = "Show what accuracy costs in clocks: turn every knob and measure the errors",
    .example =
        "  csgsim accuracy carburettor.csg --camera 220,-255,135,2,0,5 -o carburettor-accuracy\n"
        "What has been measured is in accuracy.csv at once; the same command goes on after an interruption.",
    .plots = "plots (.png, .svg) a knob and of the front",
    .is_parallel = false,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Accuracy>()); }};

}  // namespace csgsim::studies
