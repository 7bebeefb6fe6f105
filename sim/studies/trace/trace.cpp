#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/machines/hash.h"
#include "sim/report/points.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/version.h"
#include "sim/software/methods/rows.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/folder.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/processors.h"
#include "sim/studies/study.h"
#include "sim/studies/trace/directory_json.h"
#include "sim/studies/trace/show.h"

namespace csgsim::studies {

namespace {

constexpr unsigned max_mirror_depth = 4;

const std::vector<std::string> cast_names{"primary", "shadow", "mirror"};
const std::vector<std::string> switch_names{"without", "with"};
const std::vector<std::string> facet_test_names{"space", "projected"};
const std::vector<std::string> item_names{"without", "list-priority", "depth-lists"};

std::vector<std::string> parse_directories(const std::string& text) {
  return session::parse_names(text, "directory", software::row_names(software::directories()));
}
std::vector<unsigned> parse_bucket_sizes(const std::string& text) {
  constexpr unsigned max_size = 1000;
  return session::parse_numbers(text, 1, max_size);
}
std::vector<std::string> parse_cast(const std::string& text) { return session::parse_names(text, "ray", cast_names); }
std::vector<std::string> parse_facet_tests(const std::string& text) {
  return session::parse_names(text, "test", facet_test_names);
}
std::vector<std::string> parse_item_buffers(const std::string& text) {
  return session::parse_names(text, "item buffer", item_names);
}
std::vector<std::string> parse_switches(const std::string& text) {
  return session::parse_names(text, "choice", switch_names);
}

/// Pictures do not depend on how rays find facets, so all pictures with the same tolerance must be equal. Describes the
/// first difference; empty if there is none.
std::string difference_of(std::span<const TraceRow> rows) {
  for (const TraceRow& row : rows) {
    if (!row.is_drawn()) continue;
    const auto first = std::ranges::find_if(
        rows, [&](const TraceRow& one) { return one.is_drawn() && one.point.tolerance == row.point.tolerance; });
    if (row.surfaces != first->surfaces)
      return fmt::format("the surfaces seen by {} differ from those seen by {}", row.point.directory,
                         first->point.directory);
  }
  return "";
}

class Trace : public StudyOf<TraceRow> {
 public:
  void add_options(session::OptionList& command) override {
    add_model_options_without_machine(options_, command);
    command
        .option("--directories", directories_,
                "Directories by which rays find facets, separated by commas; see csgsim manual methods")
        .words(software::row_names(software::directories()), session::check_by_parsing(parse_directories));
    command
        .option("--bucket-sizes", bucket_sizes_,
                "List of maximum numbers of facets per cell, each 1 to 1000; a cell with more is divided")
        .check(session::check_by_parsing(parse_bucket_sizes));
    command.option("--cast", cast_, "Rays to cast, separated by commas; each kind includes the preceding ones")
        .words(cast_names, session::check_by_parsing(parse_cast));
    command
        .option("--facet-test", facet_test_,
                "Tests of primary rays, separated by commas: against facets in space, or projected in the picture")
        .words(facet_test_names, session::check_by_parsing(parse_facet_tests));
    command
        .option(
            "--item-buffer", item_buffer_,
            "How the facets that primary rays hit are found, separated by commas: by casting the rays (`without`), or "
            "by drawing the facets by list priority with a depth buffer (`list-priority`) or with lists of all depths "
            "(`depth-lists`)")
        .words(item_names, session::check_by_parsing(parse_item_buffers));
    command
        .option("--mailboxes", mailboxes_,
                "Whether a ray is tested only once against a facet in several cells (with), or in each cell (without)")
        .words(switch_names, session::check_by_parsing(parse_switches));
    command.option("--reflections", reflections_, "Maximum number of successive reflections, 1 to 4")
        .between(1U, max_mirror_depth);
    command
        .option("--tolerances", tolerances_,
                "Tolerances in model units for faceting curved solids, separated by commas")
        .check(session::check_by_parsing(parse_tolerances))
        .excludes("--tolerance");
    add_processors_option(command, processors_);
    json_.add_to(command, "Write the facets and the cells of the first space-halving directory");
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return model_and_processor_files(options_, processors_);
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    return {"directories", "bucket-sizes", "cast",       "facet-test",
            "item-buffer", "mailboxes",    "tolerances", "processors"};
  }
  [[nodiscard]] std::string table_model() const override { return options_.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<PointRequest> request_points() override {
    machine_ = session::machine_of(options_);
    session::ModelFile file = session::read_model_file(options_);
    tree_ = std::move(file.tree);
    faceting_ = session::flat_faceting_of(options_, machine_, tree_);
    inputs_ = {file.hash, machines::hash_of(machine_), session::version_and_build()};
    std::vector<std::optional<double>> tolerances{std::nullopt};
    if (!tolerances_.empty()) {
      const std::vector<double> requested = parse_tolerances(tolerances_);
      tolerances.assign(requested.begin(), requested.end());
    }
    for (const std::optional<double>& tolerance : tolerances) add_points(tolerance);
    std::vector<PointRequest> requested;
    for (const TracePoint& point : points_) requested.push_back({to_line(point), inputs_});
    write_cells();
    return requested;
  }

  void print() const override {
    fmt::print("{}: cost of tracing its rays, as in section 5.3 of the thesis\n",
               printable(session::shown_name(options_.model)));
    print_tracing(rows(), parse_processors(processors_));
    if (difference_of(rows()).empty()) fmt::print("\nAll directories see the same surfaces at every pixel.\n");
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    const std::vector<software::Priced> processors = parse_processors(processors_);
    const SetPoint columns = make_point_setter(std::span<const TraceRow>(rows()));
    return points_json_text(title, rows().size(), [&](nlohmann::ordered_json& json, std::size_t point) {
      columns(json, point);
      const TraceRow& row = rows()[point];
      if (!row.is_drawn()) return;
      for (const software::Priced& processor : processors) {
        if (!processor.processor) continue;
        const TraceSeconds seconds = seconds_of(row, processor);
        json["seconds"][processor.name] = {{"build", build_seconds_of(row, processor)},
                                           {"projection", seconds.projection},
                                           {"traversal", seconds.traversal},
                                           {"intersection", seconds.intersection},
                                           {"classification", seconds.classification},
                                           {"shading", seconds.shading},
                                           {"all", seconds.all}};
      }
    });
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return plots_of_tracing(rows(), parse_processors(processors_), plot_stem(options_.model));
  }

  [[nodiscard]] std::string page_title() const override { return "Cost of tracing rays"; }
  [[nodiscard]] PageSubject page_subject() const override { return {options_, {session::machine_of(options_)}}; }

  void refuse() const override {
    if (std::ranges::none_of(rows(), &TraceRow::is_drawn)) throw InputError(rows().front().reason);
    if (const std::string difference = difference_of(rows()); !difference.empty())
      throw_inconsistent_results(difference, are_read());
  }

 protected:
  [[nodiscard]] TraceRow measure_point(std::size_t number) override {
    const TracePoint& point = points_[number];
    if (!subject_ || subject_tolerance_ != point.tolerance) make_subject(point.tolerance);
    return measure_trace(point, inputs_, *subject_);
  }

 private:
  void add_points(const std::optional<double>& tolerance) {
    for (const std::string& directory : parse_directories(directories_)) {
      for (const unsigned bucket_size : parse_bucket_sizes(bucket_sizes_)) {
        for (const std::string& cast : parse_cast(cast_)) {
          for (const std::string& mailboxes : parse_switches(mailboxes_)) {
            add_points({.directory = directory,
                        .bucket_size = bucket_size,
                        .cast = cast,
                        .mailboxes = mailboxes,
                        .tolerance = tolerance});
          }
        }
      }
    }
  }

  /// Adds the point with every facet test and every item buffer.
  void add_points(TracePoint point) {
    for (const std::string& facet_test : parse_facet_tests(facet_test_)) {
      for (const std::string& item_buffer : parse_item_buffers(item_buffer_)) {
        point.facet_test = facet_test;
        point.item_buffer = item_buffer;
        points_.push_back(point);
      }
    }
  }

  /// Exports the first directory that halves space, for the first tolerance and bucket size.
  void write_cells() {
    if (!json_.is_requested()) return;
    const std::vector<std::string> halving = software::halving_directories();
    const auto found = std::ranges::find_if(
        points_, [&](const TracePoint& point) { return std::ranges::find(halving, point.directory) != halving.end(); });
    if (found == points_.end())
      throw InputError("--json needs a directory that halves space; add one of these to --directories: " +
                       fmt::format("{}", fmt::join(halving, ", ")));
    make_subject(found->tolerance);
    write_directory_json(json_, inputs(), *subject_, found->directory, found->bucket_size);
  }

  void make_subject(const std::optional<double>& tolerance) {
    facet::Geometry geometry =
        facet::make_geometry(tree_, tolerance ? facet::Faceting{.tolerance = tolerance} : faceting_);
    view::View view = view::make_view(geometry, tree_, session::camera_of(options_, machine_, tree_, geometry),
                                      session::sampling_of(options_, machine_));
    subject_ =
        std::make_unique<TraceSubject>(tree_, std::move(geometry), std::move(view), options_.scene(), reflections_);
    subject_tolerance_ = tolerance;
  }

  session::ModelRequest options_;
  std::string directories_ = "excell,excell-recursive,boxes,octree,grid,kd-tree,bvh";
  std::string bucket_sizes_ = "8";
  std::string cast_ = "primary,shadow,mirror";
  std::string facet_test_ = "space";
  std::string item_buffer_ = "without,list-priority";
  std::string mailboxes_ = "with";
  std::string tolerances_;
  std::string processors_ = "mc68000,i486dx2,this-computer";
  unsigned reflections_ = 1;
  JsonExport json_;
  machines::Machine machine_;
  model::Tree tree_;
  facet::Faceting faceting_;  ///< for points without a tolerance
  Inputs inputs_;
  std::vector<TracePoint> points_;
  std::unique_ptr<TraceSubject> subject_;  ///< subject of the last measured point
  std::optional<double> subject_tolerance_;
};

}  // namespace

extern const StudyRow trace_row{
    .name = "trace",
    .does = "Count and price the operations of ray tracing a model, for every directory of its facets",
    .example =
        "  csgsim trace carburettor.csg --camera 220,-255,135,2,0,5 --size 256x256\n"
        "  csgsim trace carburettor.csg --directories excell --bucket-sizes 1..24 --cast primary --item-buffer without "
        "-o out\n"
        "Rays find nearby facets by EXCELL, the spatial directory of the thesis, or by an alternative. Pictures are "
        "those\nof the machines; shadow and mirror rays use floating-point arithmetic, with the scene's lights and "
        "mirrors, or\nwith all facets as mirrors if it has none.",
    .plots = "plots (.png, .svg) of cells per ray, and of seconds against bucket size and polygons",
    .is_parallel = false,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Trace>()); }};

}  // namespace csgsim::studies
