#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/kinds/rows.h"
#include "hw/machines/hash.h"
#include "sim/report/points.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/version.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"
#include "sim/studies/subdivide/show.h"

namespace csgsim::studies {

namespace {

std::vector<unsigned> parse_levels(const std::string& text) {
  constexpr unsigned max_levels = 20;
  return session::parse_numbers(text, 0, max_levels);
}

bool subdivides(const machines::Kind& kind) {
  return kind.subdivided(machines::blank_machine(kind), 0, machines::Parts::segments).has_value();
}

machines::Machine subdividing_machine(const session::ModelRequest& options) {
  machines::Machine machine = session::machine_of(options);
  if (subdivides(*machine.kind)) return machine;
  std::vector<std::string_view> kinds;
  for (const machines::Kind* const kind : kinds::all()) {
    if (subdivides(*kind)) kinds.push_back(kind->name);
  }
  throw InputError(fmt::format("{} does not draw square by square; use a machine of kind {}", machine.name,
                               fmt::join(kinds, " or ")));
}

/// Nests columns: `segments_count` becomes `count` of `segments`, and so on. Omits empty columns.
nlohmann::ordered_json with_parts(const nlohmann::ordered_json& columns) {
  nlohmann::ordered_json json;
  for (const auto& [name, value] : columns.items()) {
    if (value.is_null()) continue;
    nlohmann::ordered_json* place = &json;
    std::string_view rest = name;
    for (const std::string_view part : {"segments", "subsegments", "stages", "seconds"}) {
      if (!rest.starts_with(part) || !rest.substr(part.size()).starts_with('_')) continue;
      place = &(*place)[std::string(part)];
      rest.remove_prefix(part.size() + 1);
    }
    (*place)[std::string(rest)] = value;
  }
  return json;
}

constexpr report::PointColumn square_columns[] = {{"subdivisions", "levels"},
                                                  {"tolerance", "tolerance"},
                                                  {"segments/count", "segments"},
                                                  {"segments/touched", "touched"},
                                                  {"segments/kept_primitives_mean", "primitives drawn per segment"},
                                                  {"segments/kept_halfspaces_mean", "half-spaces per segment"},
                                                  {"segments/clocks", "clocks per frame"},
                                                  {"subsegments/count", "subsegments"},
                                                  {"subsegments/touched", "touched"},
                                                  {"subsegments/kept_halfspaces_mean", "half-spaces per subsegment"},
                                                  {"subsegments/clocks", "clocks per frame"},
                                                  {"stages/seconds/total", "drawing time, s"}};

class Subdivide : public StudyOf<SubdivideRow> {
 public:
  void add_options(session::OptionList& command) override {
    options_.machine = "pixel-square";
    options_.add_to(command);
    command.option("--subdivisions", levels_, "List of levels of binary subdivision, each 0 to 20")
        .check(session::check_by_parsing(parse_levels));
    command
        .option("--tolerances", tolerances_,
                "Tolerances in model units for faceting curved solids, separated by commas")
        .check(session::check_by_parsing(parse_tolerances))
        .excludes("--tolerance");
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override { return options_.inputs(); }
  [[nodiscard]] std::set<std::string> varied_options() const override { return {"subdivisions", "tolerances"}; }
  [[nodiscard]] std::string table_model() const override { return options_.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  /// Requests all tolerances of a level before the next level.
  std::vector<PointRequest> request_points() override {
    machine_ = subdividing_machine(options_);
    session::ModelFile file = session::read_model_file(options_);
    tree_ = std::move(file.tree);
    std::vector<std::optional<double>> tolerances{std::nullopt};
    if (tolerances_.empty()) {
      faceting_ = session::faceting_of(options_, machine_, tree_);
    } else {
      const std::vector<double> requested = parse_tolerances(tolerances_);
      tolerances.assign(requested.begin(), requested.end());
    }
    std::vector<PointRequest> requested;
    for (const unsigned levels : parse_levels(levels_)) {
      for (const std::optional<double>& tolerance : tolerances) {
        SubdivideRow point;
        point.subdivisions = levels;
        point.tolerance = tolerance;
        point.inputs = {file.hash, machines::hash_of(machine_), session::version_and_build()};
        requested.push_back({to_cell(levels) + "," + to_cell(tolerance), point.inputs});
        points_.push_back(std::move(point));
      }
    }
    return requested;
  }

  void print() const override {
    fmt::print("{}: remaining work per square, as in tables 7.2 and 7.3 of the thesis\n",
               printable(session::shown_name(options_.model)));
    print_subdivision(rows());
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    nlohmann::ordered_json json =
        points_json(title, rows().size(), make_point_setter(std::span<const SubdivideRow>(rows())));
    for (nlohmann::ordered_json& point : json["points"]) point = with_parts(point);
    return json_file_text(json);
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return plots_of_subdivision(rows(), plot_stem(options_.model));
  }

  [[nodiscard]] std::string page_title() const override { return "Remaining work per square"; }
  [[nodiscard]] PageSubject page_subject() const override { return {options_, {session::machine_of(options_)}}; }

  [[nodiscard]] std::vector<report::Section> sections(const report::Json& data) const override {
    return {{"Squares", {report::points_table(data, "/points", "Means are over touched squares", square_columns)}}};
  }

 protected:
  [[nodiscard]] SubdivideRow measure_point(std::size_t number) override {
    const SubdivideRow& point = points_[number];
    const facet::Geometry scene =
        facet::make_geometry(tree_, point.tolerance ? facet::Faceting{.tolerance = point.tolerance} : faceting_);
    const view::View view = view::make_view(scene, tree_, session::camera_of(options_, machine_, tree_, scene),
                                            session::sampling_of(options_, machine_));
    SubdivideRow row =
        measure_squares({tree_, scene, view, machine_, session::emit_options_of(options_)}, point.subdivisions);
    row.subdivisions = point.subdivisions;
    row.tolerance = point.tolerance;
    row.inputs = point.inputs;
    row.primitives = tree_.primitives.size();
    row.halfspaces = scene.halfspaces();
    return row;
  }

 private:
  session::ModelRequest options_;
  std::string levels_ = "4,6,8";
  std::string tolerances_;
  machines::Machine machine_;
  model::Tree tree_;
  facet::Faceting faceting_;  ///< for points without a tolerance
  std::vector<SubdivideRow> points_;
};

}  // namespace

extern const StudyRow subdivide_row{
    .name = "subdivide",
    .does = "Show the work that remains in each square of a subdivided picture",
    .example =
        "  csgsim subdivide carburettor.csg --size 256x256 --camera 220,-255,135,2,0,5\n"
        "  csgsim subdivide carburettor.csg --size 256x256 --subdivisions 6 --tolerances 0.2,0.05,0.01 -o out\n"
        "Levels are binary subdivisions of the picture into segments; each has 4 x 4 subsegments. On a machine of\n"
        "kind multi-processor they are its own segments, with a subsegment per node, and the times of its stages\n"
        "are shown next to those of the thesis.",
    .plots = "a plot (.png, .svg) of half-spaces and clocks",
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Subdivide>()); }};

}  // namespace csgsim::studies
