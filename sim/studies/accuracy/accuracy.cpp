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
#include "hw/machines/hash.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/transparent_parts.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/version.h"
#include "sim/session/run/memory.h"
#include "sim/studies/accuracy/measure.h"
#include "sim/studies/accuracy/show.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

struct Options {
  session::ModelRequest model;
  unsigned views = 4;
  std::string knobs;
  std::string tolerances;
};

/// Whether --knobs lists the knob explicitly.
bool names_knob(const Options& options, const std::string& knob) {
  if (options.knobs.empty()) return false;
  const std::vector<std::string> named = session::parse_words(options.knobs);
  return std::ranges::find(named, knob) != named.end();
}

/// The ways to draw curved surfaces that are possible here. If only facets are possible: none, or InputError if --knobs
/// lists curves explicitly. Reports the impossible ways with their reasons.
std::vector<CurvesChoice> curves_of(const Options& options, const machines::Machine& machine, const model::Tree& tree,
                                    const view::Camera& camera) {
  const emit::Options emit = session::emit_options_of(options.model);
  const emit::Look look = emit::make_look(emit.scene, tree, csg::make_positive_tree(tree), camera);
  std::vector<CurvesChoice> possible;
  std::vector<std::string> left_out;
  for (const CurvesChoice& choice : curves_choices()) {
    if (const auto reason = choice.why_not({tree, camera, machine, emit, look}))
      left_out.push_back(fmt::format("not {}: {}", emit::name_of(choice.curves), *reason));
    else
      possible.push_back(choice);
  }
  if (possible.size() > 1) {
    for (const std::string& reason : left_out) report_line("--knobs curves, " + reason);
    return possible;
  }
  if (names_knob(options, "curves"))
    throw InputError(fmt::format("--knobs curves: only facets are possible; {}", fmt::join(left_out, "; ")));
  return {};
}

Knobs knobs_of(const Options& options, const machines::Machine& machine, const model::Tree& tree,
               const facet::Geometry& scene, const view::Camera& camera) {
  Knobs knobs;
  if (!options.knobs.empty()) knobs.names = session::parse_words(options.knobs);
  knobs.tolerances =
      options.tolerances.empty() ? default_tolerances(scene.box.diagonal()) : parse_tolerances(options.tolerances);
  if (std::ranges::find(knobs.names, "curves") != knobs.names.end())
    knobs.curves = curves_of(options, machine, tree, camera);
  return knobs;
}

class Accuracy : public StudyOf<Measurement> {
 public:
  void add_options(session::OptionList& command) override {
    options_.model.add_to(command);
    command.remove("--memory-bits");  // the required number is a result
    command.option("--views", options_.views, "Number of views per point: the camera rotated about the vertical axis")
        .between(1, 64);
    command
        .option(
            "--knobs", options_.knobs,
            "Settings to vary, separated by commas; `together` is z-bits and fraction-bits at the same time; default: "
            "all")
        .list_of(knob_names(), "setting");
    command
        .option("--tolerances", options_.tolerances,
                "Faceting tolerances in model units, separated by commas; default: fractions of the model's "
                "diagonal")
        .check(session::check_by_parsing(parse_tolerances));
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override { return options_.model.inputs(); }
  [[nodiscard]] std::string table_model() const override { return options_.model.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<PointRequest> request_points() override {
    machine_ = session::machine_of(options_.model);
    session::ModelFile file = session::read_model_file(options_.model);
    const Inputs inputs{file.hash, machines::hash_of(machine_), session::version_and_build()};
    machine_.array.memory_bits = session::ample_memory_bits;
    tree_ = std::move(file.tree);
    const facet::Faceting faceting = session::faceting_of(options_.model, machine_, tree_);
    const facet::Geometry scene = facet::make_geometry(tree_, faceting);
    if (scene.box.empty()) throw InputError(options_.model.model + ": nothing to measure; every solid is empty");
    const view::Camera camera = session::camera_of(options_.model, machine_, tree_, scene);
    session::refuse_transparent_parts(session::emit_options_of(options_.model), tree_, camera);
    points_ = accuracy_points(session::sampling_of(options_.model, machine_), faceting,
                              knobs_of(options_, machine_, tree_, scene, camera));
    // Small pictures cannot be divided as often, so some sizes coincide.
    std::set<std::string> known;
    std::erase_if(points_, [&](const Settings& point) { return !known.insert(cells_of(point)).second; });
    meter_ = std::make_unique<Meter>(tree_, rotated_cameras(camera, options_.views), machine_,
                                     session::emit_options_of(options_.model));
    std::vector<PointRequest> requested;
    for (const Settings& point : points_) requested.push_back({cells_of(point), inputs});
    inputs_ = inputs;
    return requested;
  }

  void print() const override { print_accuracy(rows(), options_.views); }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return plots_of_accuracy(rows(), {plot_stem(options_.model.model), options_.views});
  }

  [[nodiscard]] std::string page_title() const override { return "Cost of accuracy"; }
  [[nodiscard]] PageSubject page_subject() const override {
    return {options_.model, {session::machine_of(options_.model)}};
  }

 protected:
  [[nodiscard]] Measurement measure_point(std::size_t point) override {
    const view::Sampling& sampling = points_[point].sampling;
    Measurement row = session::with_memory_for_picture({sampling.width, sampling.height, machine_.array.memory_bits},
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
  std::unique_ptr<Meter> meter_;  ///< caches pictures between points
};

}  // namespace

extern const StudyRow accuracy_row{
    .name = "accuracy",
    .does = "Measure the cost of accuracy in clocks: vary every setting and count the errors",
    .example =
        "  csgsim accuracy carburettor.csg --camera 220,-255,135,2,0,5 -o carburettor-accuracy\n"
        "Each result is written to accuracy.csv immediately; after an interruption, the same command resumes.",
    .plots = "plots (.png, .svg) per setting and of the front",
    .is_parallel = false,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Accuracy>()); }};

}  // namespace csgsim::studies
