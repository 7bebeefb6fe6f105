#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/read/source.h"
#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"
#include "sim/report/points.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/version.h"
#include "sim/software/work.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/json_export.h"
#include "sim/studies/mesh/price.h"
#include "sim/studies/mesh/show.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/processors.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

const std::vector<std::string> flatnesses{flatness_of_plane, flatness_of_sides};
const std::vector<std::string> repairs{repair_by_filter, repair_by_quadtree};

std::vector<std::string> parse_flatness(const std::string& text) {
  return session::parse_names(text, "flatness test", flatnesses);
}
std::vector<std::string> repairs_in(const std::string& text) { return session::parse_names(text, "repair", repairs); }

std::vector<software::Priced> parse_meshing_processors(const std::string& list) {
  std::vector<software::Priced> processors = parse_processors(list);
  for (const software::Priced& one : processors)
    if (!one.processor) throw InputError(one.name + " has no prices; use a processor by name or .toml file");
  return processors;
}

class Mesh : public StudyOf<MeshRow> {
 public:
  void add_options(session::OptionList& command) override {
    command.option("MODEL", model_, "File of commands (.jan) with sweeps or patches").required();
    command.option("--tolerances", tolerances_, "Tolerances in model units, separated by commas")
        .check(session::check_by_parsing(parse_tolerances));
    command
        .option("--flatness", flatness_,
                "Flatness tests, separated by commas: plane (the thesis's; distances from a plane) or sides (also "
                "distances "
                "of the sides from straight lines)")
        .words(flatnesses, session::check_by_parsing(parse_flatness));
    command
        .option("--repairs", repairs_,
                "Methods that close cracks between elements, separated by commas: filter (the thesis's) or quadtree")
        .words(repairs, session::check_by_parsing(repairs_in));
    command
        .option("--processors", processors_,
                "Processors for which seconds are computed: names or .toml files, separated by commas")
        .check(session::check_by_parsing(parse_meshing_processors));
    json_.add_to(command, "Write the vertices and elements of each mesh");
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return session::input_files({model_}, session::parse_words(processors_));
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    return {"tolerances", "flatness", "repairs", "processors"};
  }
  [[nodiscard]] std::string table_model() const override { return model_; }

  std::vector<PointRequest> request_points() override {
    const std::string text = read_file(model_, read::model_file);
    if (const std::string ending = std::filesystem::path(model_).extension().string();
        ending == ".csg" || ending == ".scad")
      throw InputError(
          fmt::format("{}: only sweeps and patches of command files (.jan) can be meshed; csgsim convert makes "
                      "a mesh of other models",
                      session::shown_name(model_)));
    Hash hash;
    hash.add(text);
    inputs_ = {hash.text(), "none", session::version_and_build()};
    surfaces_ = commands::read_surfaces(text, session::shown_name(model_));
    if (surfaces_.empty())
      throw InputError(fmt::format("{}: contains no sweep and no patch to mesh", session::shown_name(model_)));
    std::vector<PointRequest> requested;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      for (const std::string& flatness : parse_flatness(flatness_)) {
        for (const std::string& repair : repairs_in(repairs_)) {
          for (const double tolerance : parse_tolerances(tolerances_)) {
            points_.push_back({surfaces_[i].name, tolerance, flatness, repair});
            numbers_.push_back(i);
            requested.push_back({to_line(points_.back()), inputs_});
          }
        }
      }
    }
    write_meshes();
    return requested;
  }

  void print() const override {
    fmt::print("{}: elements of its surfaces, as in table 3.1 of the thesis\n", printable(session::shown_name(model_)));
    print_meshes(rows(), parse_meshing_processors(processors_));
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    const std::vector<software::Priced> processors = parse_meshing_processors(processors_);
    const SetPoint columns = make_point_setter(std::span<const MeshRow>(rows()));
    return points_json_text(title, rows().size(), [&](nlohmann::ordered_json& json, std::size_t point) {
      columns(json, point);
      const MeshRow& row = rows()[point];
      if (!row.is_meshed()) return;
      for (const software::Priced& processor : processors) {
        const MeshSeconds seconds = seconds_of(row, *processor.processor);
        json["seconds"][processor.name] = {{"subdividing", seconds.subdividing}, {"repairing", seconds.repairing}};
      }
    });
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override { return plots_of_meshes(rows(), plot_stem(model_)); }

  [[nodiscard]] std::string page_title() const override { return "Meshes of surfaces"; }
  [[nodiscard]] PageSubject page_subject() const override { return {{}, {}, false, model_}; }

  void refuse() const override {
    if (std::ranges::none_of(rows(), &MeshRow::is_meshed)) throw InputError(rows().front().reason);
  }

 protected:
  [[nodiscard]] MeshRow measure_point(std::size_t point) override {
    return studies::measure(points_[point], inputs_, surfaces_[numbers_[point]]);
  }

 private:
  void write_meshes() const {
    const auto facts = [&] { return nlohmann::ordered_json{{"model", session::shown_name(model_)}}; };
    json_.write(inputs(), facts, "meshes", [&](const JsonExport::Put& put) {
      for (std::size_t i = 0; i < points_.size(); ++i) put(mesh_json(points_[i], surfaces_[numbers_[i]]));
    });
  }

  std::string model_;
  std::string tolerances_ = "0.1,0.05,0.01,0.001";
  std::string flatness_ = flatness_of_plane;
  std::string repairs_ = "filter,quadtree";
  std::string processors_ = "mc68000,i486dx2";
  JsonExport json_;
  Inputs inputs_;
  std::vector<commands::NamedSurface> surfaces_;
  std::vector<MeshPoint> points_;
  std::vector<std::size_t> numbers_;  ///< surface of each point
};

}  // namespace

extern const StudyRow mesh_row{
    .name = "mesh",
    .does = "Count the cost of meshing sweeps and patches: elements, vertices, storage of the integrity filter",
    .example =
        "  csgsim mesh patch.jan\n"
        "  csgsim mesh vase.jan --tolerances 0.1,0.05 --flatness plane,sides -o out\n"
        "The surfaces are those of a file of commands (docs/reproduction.md). Both repairs make\n"
        "the same mesh; the filter stores the elements along the border of the finished\n"
        "part, the quadtree stores all of them.",
    .plots = "plots (.png, .svg) of elements against tolerance",
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Mesh>()); }};

}  // namespace csgsim::studies
