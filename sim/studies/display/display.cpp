#include <fmt/format.h>
#include <fmt/ranges.h>

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
#include "sim/software/display/rows.h"
#include "sim/software/methods/rows.h"
#include "sim/software/space/directory.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/display/show.h"
#include "sim/studies/folder.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/processors.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

constexpr unsigned max_display_fragments = 4096;
constexpr unsigned max_bucket_size = 10'000;

std::vector<std::string> parse_display_methods(const std::string& text) {
  return session::parse_names(text, "method", software::row_names(software::display_methods()));
}
std::vector<unsigned> parse_display_fragments(const std::string& text) {
  return session::parse_numbers(text, 3, max_display_fragments);
}
std::vector<std::string> parse_display_directories(const std::string& text) {
  return session::parse_names(text, "directory", software::halving_directories());
}
std::vector<unsigned> parse_bucket_sizes(const std::string& text) {
  return session::parse_numbers(text, 1, max_bucket_size);
}

/// Exact methods must see the same surfaces of the same facets. Describes the first difference; empty if there is none.
std::string display_difference(std::span<const DisplayStudyRow> rows) {
  const auto is_judged = [](const DisplayStudyRow& row) {
    return row.is_drawn() && software::display_method(row.point.method).is_exact;
  };
  for (const DisplayStudyRow& one : rows) {
    for (const DisplayStudyRow& other : rows) {
      const bool are_alike =
          one.point.tolerance == other.point.tolerance && one.point.fragments == other.point.fragments;
      if (is_judged(one) && is_judged(other) && are_alike && one.surfaces != other.surfaces) {
        return fmt::format("the surfaces seen by {} differ from those seen by {}, for facets {}", other.point.method,
                           one.point.method, faceting_text(one.point));
      }
    }
  }
  return "";
}

class Display : public StudyOf<DisplayStudyRow> {
 public:
  void add_options(session::OptionList& command) override {
    add_model_options_without_machine(options_, command);
    command.option("--methods", methods_, "Methods, separated by commas; see csgsim manual methods")
        .words(software::row_names(software::display_methods()), session::check_by_parsing(parse_display_methods));
    command
        .option("--tolerances", tolerances_,
                "Tolerances in model units for faceting curved solids, separated by commas")
        .check(session::check_by_parsing(parse_tolerances))
        .excludes("--tolerance");
    command.option("--fragments", fragments_, "List of values of $fn for curved solids, in place of the model's own")
        .check(session::check_by_parsing(parse_display_fragments))
        .excludes("--tolerances");
    command.option("--bucket-sizes", bucket_sizes_, "List of maximum numbers of polygons per bucket, for list priority")
        .check(session::check_by_parsing(parse_bucket_sizes));
    command
        .option("--directories", directories_,
                "Directories of list priority, separated by commas; see csgsim manual methods")
        .words(software::halving_directories(), session::check_by_parsing(parse_display_directories));
    add_processors_option(command, processors_);
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return model_and_processor_files(options_, processors_);
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    return {"methods", "tolerances", "fragments", "bucket-sizes", "directories", "processors"};
  }
  [[nodiscard]] std::string table_model() const override { return options_.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<PointRequest> request_points() override {
    machine_ = session::machine_of(options_);
    session::ModelFile file = session::read_model_file(options_);
    tree_ = std::move(file.tree);
    faceting_ = session::flat_faceting_of(options_, machine_, tree_);
    inputs_ = {file.hash, machines::hash_of(machine_), session::version_and_build()};
    std::vector<PointRequest> requested;
    for (const std::string& method : parse_display_methods(methods_)) {
      const bool has_buckets = method.starts_with("list-priority");
      if (!has_buckets) {
        add({.method = method});
        continue;
      }
      for (const std::string& directory : parse_display_directories(directories_)) {
        for (const unsigned size : parse_bucket_sizes(bucket_sizes_))
          add({.method = method, .bucket_size = size, .directory = directory});
      }
    }
    for (const DisplayPoint& point : points_) requested.push_back({to_line(point), inputs_});
    return requested;
  }

  void print() const override {
    fmt::print("{}: cost of displaying it facet by facet, as in table 5.1 of the thesis\n",
               printable(session::shown_name(options_.model)));
    print_display(rows(), parse_processors(processors_));
    if (display_difference(rows()).empty()) fmt::print("\nExact methods see the same surfaces at every pixel.\n");
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    const std::vector<software::Priced> processors = parse_processors(processors_);
    const SetPoint columns = make_point_setter(std::span<const DisplayStudyRow>(rows()));
    return points_json_text(title, rows().size(), [&](nlohmann::ordered_json& json, std::size_t point) {
      columns(json, point);
      const DisplayStudyRow& row = rows()[point];
      if (!row.is_drawn()) return;
      for (const software::Priced& processor : processors) {
        if (!processor.processor) continue;
        const DisplaySeconds seconds = display_seconds(row, processor);
        nlohmann::ordered_json& phase_seconds = json["seconds"][processor.name];
        for (std::size_t phase = 0; phase < software::phases; ++phase)
          phase_seconds[software::phase_rows[phase].name] = seconds.of[phase].value_or(0);
        phase_seconds["total"] = seconds.total;
      }
    });
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return plots_of_display(rows(), parse_processors(processors_), plot_stem(options_.model));
  }

  [[nodiscard]] std::string page_title() const override { return "Cost of displaying facets"; }
  [[nodiscard]] PageSubject page_subject() const override { return {options_, {session::machine_of(options_)}}; }

  void refuse() const override {
    if (std::ranges::none_of(rows(), &DisplayStudyRow::is_drawn)) throw InputError(rows().front().reason);
    if (const std::string difference = display_difference(rows()); !difference.empty())
      throw_inconsistent_results(difference, are_read());
  }

 protected:
  [[nodiscard]] DisplayStudyRow measure_point(std::size_t number) override {
    const DisplayPoint& point = points_[number];
    facet::Faceting faceting = faceting_;
    if (point.tolerance) faceting = {.tolerance = point.tolerance};
    if (point.fragments != 0) faceting = {.fragments = point.fragments};
    const facet::Geometry geometry = facet::make_geometry(tree_, faceting);
    const view::View view = view::make_view(geometry, tree_, session::camera_of(options_, machine_, tree_, geometry),
                                            session::sampling_of(options_, machine_));
    return measure_display(point, inputs_, tree_, geometry, view);
  }

 private:
  /// Adds the point for every requested faceting.
  void add(DisplayPoint point) {
    if (tolerances_.empty() && fragments_.empty()) points_.push_back(point);
    if (!tolerances_.empty()) {
      for (const double tolerance : parse_tolerances(tolerances_)) {
        point.tolerance = tolerance;
        points_.push_back(point);
      }
    } else if (!fragments_.empty()) {
      for (const unsigned fragments : parse_display_fragments(fragments_)) {
        point.fragments = fragments;
        points_.push_back(point);
      }
    }
  }

  session::ModelRequest options_;
  std::string methods_ = fmt::format("{}", fmt::join(software::row_names(software::display_methods()), ","));
  std::string tolerances_;
  std::string fragments_;
  std::string bucket_sizes_ = "24";
  std::string directories_ = "excell";
  std::string processors_ = "mc68000,i486dx2,this-computer";
  machines::Machine machine_;
  model::Tree tree_;
  facet::Faceting faceting_;  ///< for points that specify no faceting
  Inputs inputs_;
  std::vector<DisplayPoint> points_;
};

}  // namespace

extern const StudyRow display_row{
    .name = "display",
    .does = "Count and price the operations of software that draws a model facet by facet, for every method",
    .example =
        "  csgsim display crossing_cylinders.csg --size 256x256 --fragments 12,18,24,32\n"
        "  csgsim display carburettor.csg --methods scan-line,depth-peeling --tolerances 1,0.5 -o out\n"
        "The methods are those of section 5.2 of the thesis and alternatives, on the integers of the machines. Their\n"
        "operations are counted by kind; a processor's file gives the price of each kind. Pixels of list priority "
        "that\n"
        "differ from the machines' are counted by cause.",
    .plots = "a plot (.png, .svg) of seconds against polygons",
    .is_parallel = false,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Display>()); }};

}  // namespace csgsim::studies
