#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/report/points.h"
#include "sim/studies/advise/options.h"
#include "sim/studies/advise/show.h"
#include "sim/studies/folder.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"
#include "sim/studies/vocabulary.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const AdviceRow>;

/// Draws a recommended choice again, with its own strategy, colouring and ALU, and checks that the result is the same.
void check_by_drawing(const AdviseOptions& options, const AdviceSearch& question, const AdviceRow& row, bool are_read) {
  MeasurementSettings measured = question.measured;
  measured.colour_bits = {row.point.colour_bits};
  const Job job = question.make_job(options, row.point);
  if (to_line(AdviceRow(DesignMeter(measured).measure(row.point, job))) == to_line(row)) return;
  throw_inconsistent_results("drawing a recommended choice gives another result than its row", are_read);
}

std::string picture_name(const AdviseOptions& options, const std::string& what) {
  std::string name = plot_stem(options.model.model) + "-" + what + ".png";
  for (char& c : name) c = c == ' ' ? '-' : c;
  return name;
}

Advice advice_of(const AdviseOptions& options, const session::OptionList& command, const AdviceSearch& question,
                 Rows rows, bool are_read) {
  Advice advice{recommend(rows, question.requirements), {}};
  for (const Recommendation& one : advice.recommendations) {
    check_by_drawing(options, question, one.row, are_read);
    advice.commands.push_back(
        render_command(options, command, one.row, picture_name(options, kind_of(one.requirement).best)));
  }
  const AdviceRow nearest = nearest_choices(rows, question.requirements, 1).front();
  if (meets_all(nearest, question.requirements)) return advice;
  check_by_drawing(options, question, nearest, are_read);
  advice.nearest = nearest;
  advice.nearest_command = render_command(options, command, nearest, picture_name(options, "nearest"));
  return advice;
}

/// A picture of each recommended choice; one choice may be the best by several requirements.
std::vector<report::Picture> pictures_of(const AdviseOptions& options, const Advice& advice) {
  std::vector<std::pair<AdviceRow, std::string>> choices;
  const auto add = [&](const AdviceRow& row, const std::string& name) {
    const auto known = std::ranges::find(choices, row, &std::pair<AdviceRow, std::string>::first);
    if (known == choices.end()) {
      choices.emplace_back(row, name);
    } else {
      known->second += ", " + name;
    }
  };
  for (const Recommendation& one : advice.recommendations) add(one.row, kind_of(one.requirement).best);
  if (advice.nearest) add(*advice.nearest, "closest to all requirements");
  std::vector<report::Picture> pictures;
  pictures.reserve(choices.size());
  for (const auto& [row, name] : choices) pictures.push_back(picture_of(options, row, name));
  return pictures;
}

std::vector<report::PointColumn> advised_columns() {
  return page_columns(
      "used_bits,z_bits,fraction_bits,colour_bits,colour_error,strategy,stack_bits,colouring,alu_bits,clocks,"
      "frames_per_second,wrong");
}

report::Table requirements_table(const report::Json& data) {
  report::Table table{"Requirements", {"requirement", "value"}, {}};
  for (const Requirement requirement : all_requirements)
    table.rows.push_back(
        {{kind_of(requirement).title}, report::cell(data, std::string("/wishes/") + kind_of(requirement).key)});
  return table;
}

/// JSON pointers of the recommendations, and of the nearest choice if present.
std::vector<std::string> recommended(const report::Json& data) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < data["recommendations"].size(); ++i)
    all.push_back("/recommendations/" + std::to_string(i));
  if (data.contains("nearest")) all.emplace_back("/nearest");
  return all;
}

report::Cell name_of(const report::Json& data, const std::string& at) {
  const report::Cell what = report::cell(data, at + "/what");
  return what.at.empty() ? report::Cell{"closest to all requirements"} : what;
}

report::Table recommendations_table(const report::Json& data) {
  report::Table table{
      "Best choice by each requirement", {"best by", "meets all requirements", "misses its own by"}, {}};
  const std::vector<report::PointColumn> columns = advised_columns();
  for (const report::PointColumn& column : columns) table.columns.emplace_back(column.title);
  for (const std::string& at : recommended(data)) {
    const bool is_nearest = at == "/nearest";
    report::Row row{name_of(data, at),
                    is_nearest ? report::cell(data, "/meets_all") : report::cell(data, at + "/meets_all"),
                    is_nearest ? report::Cell{} : report::cell(data, at + "/missed_by")};
    for (const report::PointColumn& column : columns) row.push_back(report::cell(data, at + "/point/" + column.key));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table commands_table(const report::Json& data) {
  report::Table table{"Commands that render them", {"best by", "command"}, {}, true};
  for (const std::string& at : recommended(data))
    table.rows.push_back({name_of(data, at), report::cell(data, at + "/command")});
  return table;
}

/// The recommendations section of a page.
report::Section recommendations(const report::Json& data, std::uint64_t searched, std::uint64_t refused,
                                std::vector<report::Picture> pictures) {
  const char* const outcome =
      data["meets_all"].get<bool>()
          ? "Each of these is the best by one requirement among the choices that meet the others."
          : "No choice meets all requirements. Each of these is the best by one requirement among the choices that "
            "meet the others; the column 'misses its own by' shows how far that requirement is missed.";
  report::Section section{"Recommendations",
                          {report::Paragraph{fmt::format("{} choices were searched; {} of them cannot be drawn.",
                                                         grouped(searched), grouped(refused))},
                           report::Paragraph{outcome}}};
  if (!pictures.empty()) section.parts.emplace_back(report::Gallery{std::move(pictures)});
  section.parts.emplace_back(recommendations_table(data));
  section.parts.emplace_back(commands_table(data));
  section.parts.emplace_back(requirements_table(data));
  return section;
}

class Advise : public StudyOf<AdviceRow> {
 public:
  void add_options(session::OptionList& command) override {
    options_.add_to(command);
    command_ = &command;
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override { return options_.model.inputs(); }
  /// One table serves all requirements and all ranges.
  [[nodiscard]] std::set<std::string> varied_options() const override {
    const std::vector<std::string> own = advise_only_options();
    std::set<std::string> names(own.begin(), own.end());
    names.erase("machine");
    names.erase("set");
    return names;
  }
  [[nodiscard]] std::string table_model() const override { return options_.model.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<PointRequest> request_points() override {
    question_ = make_search(options_);
    meter_ = std::make_unique<DesignMeter>(question_.measured);
    std::vector<PointRequest> requested;
    for (const DesignPoint& point : question_.points)
      requested.push_back({point_cells<AdviceRow>(point), question_.jobs.begin()->second.inputs});
    return requested;
  }

  void print() const override {
    const machines::Size size = question_.jobs.begin()->second.machine.picture;
    print_search(
        fmt::format("{}, {} x {} pixels, on {}", options_.model.model, size.width, size.height, options_.model.machine),
        rows(), question_.requirements);
    studies::print_front(rows(), question_.requirements);
    print_advice(advice_, question_.requirements);
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    return advice_json(title, question_.requirements, rows(), advice_);
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return {plot_of_advice(rows(), question_.requirements, advice_.recommendations, plot_stem(options_.model.model))};
  }

  [[nodiscard]] std::string page_title() const override { return "Cheapest memory"; }
  [[nodiscard]] PageSubject page_subject() const override {
    return {options_.model, {session::machine_of(options_.model)}, false};
  }

  /// Omits the thousands of searched points.
  [[nodiscard]] report::Json page_data(report::Json file) const override {
    file.erase("points");
    return file;
  }

  [[nodiscard]] std::vector<report::Section> sections(const report::Json& data) const override {
    const auto refused = std::ranges::count_if(rows(), [](const AdviceRow& row) { return !row.is_compiled(); });
    return {recommendations(data, rows().size(), static_cast<std::uint64_t>(refused), pictures_of(options_, advice_)),
            {"Front",
             {report::points_table(data, "/front", "Pareto-optimal choices, fewest memory bits first",
                                   advised_columns())}}};
  }

  void refuse() const override {
    if (std::ranges::any_of(rows(), [](const AdviceRow& row) { return row.unexplained > 0; }))
      throw_inconsistent_results("the errors of a picture exceed the bounds of docs/numbers.md", are_read());
    if (advice_.nearest)
      throw InputError("no choice meets all requirements; the closest one has " +
                       misses_text(*advice_.nearest, question_.requirements));
  }

 protected:
  [[nodiscard]] AdviceRow measure_point(std::size_t point) override {
    const DesignPoint& design = question_.points[point];
    return AdviceRow(meter_->measure(design, question_.make_job(options_, design)));
  }

  /// Adjacent points with the same z bits and fraction bits share one exact picture, which would block threads that
  /// need it at the same time. Each thread therefore works on another picture.
  [[nodiscard]] std::vector<std::size_t> measuring_order(std::span<const std::size_t> points,
                                                         unsigned threads) const override {
    std::map<std::pair<unsigned, unsigned>, std::size_t> pictures;
    std::vector<std::size_t> counts;  // number of points per picture
    std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> turns;
    for (const std::size_t point : points) {
      const DesignPoint& design = question_.points[point];
      const std::size_t picture =
          pictures.emplace(std::pair(design.z_bits, design.fraction_bits), pictures.size()).first->second;
      counts.resize(pictures.size());
      turns.emplace_back(picture / threads, counts[picture]++, point);
    }
    std::ranges::sort(turns);
    std::vector<std::size_t> order;
    order.reserve(turns.size());
    for (const auto& turn : turns) order.push_back(std::get<2>(turn));
    return order;
  }

  void derive_results() override {
    if (std::ranges::none_of(rows(), &AdviceRow::is_compiled)) throw InputError(rows().front().reason);
    advice_ = advice_of(options_, *command_, question_, rows(), are_read());
  }

 private:
  AdviseOptions options_;
  const session::OptionList* command_ = nullptr;
  AdviceSearch question_;
  std::unique_ptr<DesignMeter> meter_;
  studies::Advice advice_;
};

}  // namespace

extern const StudyRow advise_row{
    .name = "advise",
    .does = "Find the cheapest memory for a model that meets limits on bits, wrong pixels, speed and colours",
    .example =
        "  csgsim advise carburettor.csg --camera 220,-255,135,2,0,5 --max-bits 64 --max-wrong-pixels 10 --min-fps 20\n"
        "  csgsim advise carburettor.csg --alu-bits 1,2,4,8 --min-colour-bits 12 -o carburettor-advice\n"
        "Lists are separated by commas, ranges are written 3..8; every combination is measured. Results are kept\n"
        "in advise.csv; after an interruption, the same command resumes. Changed requirements need no new "
        "measurements.",
    .plots = "a plot (.png, .svg) of frame rate against memory",
    .has_shards = false,
    .is_quick = true,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Advise>()); }};

}  // namespace csgsim::studies
