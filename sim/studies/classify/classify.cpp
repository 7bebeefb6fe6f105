#include <fmt/format.h>

#include <algorithm>
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
#include "sim/studies/classify/events.h"
#include "sim/studies/classify/show.h"
#include "sim/studies/folder.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/processors.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

constexpr const char* no_coherence = "none";

std::vector<std::string> parse_methods(const std::string& text) {
  return session::parse_names(text, "method", software::row_names(software::methods()));
}
std::vector<std::string> parse_coherences(const std::string& text) {
  return session::parse_names(text, "coherence", software::row_names(software::coherences()));
}
std::vector<std::string> parse_shapes(const std::string& text) {
  return session::parse_names(text, "shape", software::row_names(software::shapes()));
}
std::vector<std::string> parse_reductions(const std::string& text) {
  return session::parse_names(text, "reduction", software::row_names(software::prunings()));
}

template <class Rows>
std::string all_of(const Rows& rows) {
  return fmt::format("{}", fmt::join(software::row_names(rows), ","));
}

/// The rays of a picture do not depend on the classification method, so all methods must see the same surfaces.
/// Describes the first difference; empty if there is none.
std::string difference_of(std::span<const ClassifyRow> rows) {
  const auto first = std::ranges::find_if(rows, &ClassifyRow::is_drawn);
  for (const ClassifyRow& row : rows) {
    if (row.is_drawn() && row.surfaces != first->surfaces) {
      return fmt::format("the surfaces seen by {}/{} differ from those seen by {}/{}", row.point.method,
                         row.point.coherence, first->point.method, first->point.coherence);
    }
  }
  return "";
}

class Classify : public StudyOf<ClassifyRow> {
 public:
  void add_options(session::OptionList& command) override {
    add_model_options_without_machine(options_, command);
    command.option("--methods", methods_, "Methods, separated by commas; see csgsim manual methods")
        .words(software::row_names(software::methods()), session::check_by_parsing(parse_methods));
    command
        .option("--coherences", coherences_,
                "Coherences, separated by commas: the data that methods keep between points")
        .words(software::row_names(software::coherences()), session::check_by_parsing(parse_coherences));
    command.option("--shapes", shapes_, "Shapes of the tree, separated by commas")
        .words(software::row_names(software::shapes()), session::check_by_parsing(parse_shapes));
    command
        .option("--reduced", reduced_,
                "Ways to prune trees in advance, separated by commas: none; cells (to the primitives in a cell of the "
                "picture); "
                "inside (while a ray is inside a primitive, to those that intersect it)")
        .words(software::row_names(software::prunings()), session::check_by_parsing(parse_reductions));
    add_processors_option(command, processors_);
    json_.add_to(command, "Write the surfaces that each ray intersects, in order, and the visible one");
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return model_and_processor_files(options_, processors_);
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    return {"methods", "coherences", "shapes", "reduced", "processors"};
  }
  [[nodiscard]] std::string table_model() const override { return options_.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<PointRequest> request_points() override {
    const machines::Machine machine = session::machine_of(options_);
    session::ModelFile file = session::read_model_file(options_);
    tree_ = std::move(file.tree);
    geometry_ = facet::make_geometry(tree_, session::faceting_of(options_, machine, tree_));
    view_ = view::make_view(*geometry_, tree_, session::camera_of(options_, machine, tree_, *geometry_),
                            session::sampling_of(options_, machine));
    inputs_ = {file.hash, machines::hash_of(machine), session::version_and_build()};
    std::vector<PointRequest> requested;
    for (const std::string& shape : parse_shapes(shapes_)) {
      for (const std::string& reduced : parse_reductions(reduced_)) add_points(shape, reduced);
    }
    for (const ClassifyPoint& point : points_) requested.push_back({to_line(point), inputs_});
    write_events(json_, inputs(), {tree_, *geometry_, view_, survey_});
    return requested;
  }

  void print() const override {
    fmt::print("{}: cost of classifying its rays, as in tables 4.9 and 4.10 of the thesis\n",
               printable(session::shown_name(options_.model)));
    print_classification(rows(), parse_processors(processors_));
    if (difference_of(rows()).empty()) fmt::print("\nAll methods see the same surfaces at every pixel.\n");
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    const std::vector<software::Priced> processors = parse_processors(processors_);
    const SetPoint columns = make_point_setter(std::span<const ClassifyRow>(rows()));
    return points_json_text(title, rows().size(), [&](nlohmann::ordered_json& json, std::size_t point) {
      columns(json, point);
      const ClassifyRow& row = rows()[point];
      if (!row.is_drawn()) return;
      for (const software::Priced& processor : processors) {
        if (!processor.processor) continue;
        const software::PricedSeconds seconds = seconds_of(row, processor);
        json["seconds"][processor.name] = {{"classification", seconds.classification}, {"all", seconds.all}};
      }
    });
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return plots_of_classification(rows(), parse_processors(processors_), plot_stem(options_.model));
  }

  [[nodiscard]] std::string page_title() const override { return "Cost of classifying rays"; }
  [[nodiscard]] PageSubject page_subject() const override { return {options_, {session::machine_of(options_)}}; }

  void refuse() const override {
    if (std::ranges::none_of(rows(), &ClassifyRow::is_drawn)) throw InputError(rows().front().reason);
    if (const std::string difference = difference_of(rows()); !difference.empty())
      throw_inconsistent_results(difference, are_read());
  }

 protected:
  [[nodiscard]] ClassifyRow measure_point(std::size_t point) override {
    return studies::measure(points_[point], inputs_, {tree_, *geometry_, view_, survey_});
  }

 private:
  /// Adds all methods, each with all coherences. Methods that take whole rays have no coherence and no reduced trees.
  void add_points(const std::string& shape, const std::string& reduced) {
    for (const std::string& method : parse_methods(methods_)) {
      const software::Choice choice = software::choice_of(method);
      if (choice.coherence == nullptr) {
        if (reduced == parse_reductions("none").front()) points_.push_back({method, no_coherence, shape, reduced});
        continue;
      }
      for (const std::string& coherence : parse_coherences(coherences_))
        points_.push_back({method, coherence, shape, reduced});
    }
  }

  session::ModelRequest options_;
  std::string methods_ = all_of(software::methods());
  std::string coherences_ = all_of(software::coherences());
  std::string shapes_ = "balanced";
  std::string reduced_ = "none";
  std::string processors_ = "mc68000,i486dx2,this-computer";
  JsonExport json_;
  model::Tree tree_;
  std::optional<facet::Geometry> geometry_;
  view::View view_;
  Inputs inputs_;
  std::vector<ClassifyPoint> points_;
  std::optional<software::Survey> survey_;
};

}  // namespace

extern const StudyRow classify_row{
    .name = "classify",
    .does = "Count and price the operations of software that classifies a model's rays, for every method",
    .example =
        "  csgsim classify carburettor.csg --camera 220,-255,135,2,0,5 --projection perspective\n"
        "  csgsim classify carburettor.csg --methods standard,status --shapes written,balanced -o out\n"
        "The methods are those of chapter 4 of the thesis and some later ones. They use the integers of the machines "
        "and\n"
        "see the same surfaces. Their operations are counted by kind; a processor's file gives the price of each kind.",
    .plots = "plots (.png, .svg) of seconds by method",
    .is_parallel = false,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Classify>()); }};

}  // namespace csgsim::studies
