#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/observe/bound.h"
#include "sim/plots/number_text.h"
#include "sim/report/points.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/machine_list.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/text_columns.h"
#include "sim/studies/corpus/files.h"
#include "sim/studies/corpus/measure.h"
#include "sim/studies/groups.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const CorpusRow>;

using Lines = std::vector<std::vector<std::string>>;

std::vector<std::string> row_line(const CorpusRow& row) {
  const std::string name = "  " + row.point.machine;
  if (!row.is_drawn()) return {name, row.reason};
  return {name,
          grouped(row.clocks),
          grouped(row.render),
          grouped(row.classify),
          grouped(row.merge),
          grouped(row.shade),
          grouped(row.pixel_operations),
          std::to_string(row.used_bits),
          observe::rate_text(row.frames_per_second),
          row.bound_by};
}

void add_model(std::span<const CorpusRow> rows, Lines& lines) {
  const auto drawn = std::ranges::find_if(rows, &CorpusRow::is_drawn);
  if (drawn == rows.end()) {
    lines.push_back({with_model_name(rows.front().point.model, rows.front().reason)});
    return;
  }
  lines.push_back(
      {fmt::format("{}: {}, {}, {}", drawn->point.model, session::count_text(drawn->primitives, "primitive"),
                   session::count_text(drawn->pieces, "piece"), session::count_text(drawn->halfspaces, "half-space"))});
  for (const CorpusRow& row : rows) lines.push_back(row_line(row));
}

void print_rows(Rows rows) {
  Lines lines{{"model and machine", "clocks", "render", "classify", "merge", "shade", "pixel operations", "bits",
               "frames/s", "limited by"}};
  for (const std::span<const CorpusRow> model : group_by_model(rows)) add_model(model, lines);
  fmt::print("{}", session::format_columns(lines, "<>>>>>>>><"));
}

std::vector<std::string> distribution_line(const CorpusColumn& column, const Distribution& one) {
  using plots::number_text;
  return {std::string("  ") + column.heading,
          number_text(one.minimum),
          number_text(one.first_quartile),
          number_text(one.median),
          number_text(one.third_quartile),
          number_text(one.maximum),
          column.adds_up ? number_text(one.total) : ""};
}

void print_distributions(Rows rows) {
  for (const std::string& machine : machines_of(rows)) {
    const auto of_machine = [&](const CorpusRow& row) { return row.point.machine == machine; };
    const auto models = std::ranges::count_if(rows, of_machine);
    const auto drawn =
        std::ranges::count_if(rows, [&](const CorpusRow& row) { return of_machine(row) && row.is_drawn(); });
    fmt::print("\n{}: {} of {} models\n", machine, drawn, models);
    if (drawn == 0) continue;
    Lines lines{{"", "minimum", "quartile", "median", "quartile", "maximum", "total"}};
    for (const CorpusColumn& column : corpus_columns())
      lines.push_back(distribution_line(column, distribution_of(rows, machine, column)));
    fmt::print("{}", session::format_columns(lines, "<>>>>>>"));
  }
}

constexpr std::pair<const char*, const char*> marks[] = {{"minimum", "minimum"}, {"first_quartile", "first quartile"},
                                                         {"median", "median"},   {"third_quartile", "third quartile"},
                                                         {"maximum", "maximum"}, {"total", "total"}};

report::Table distribution_table(const report::Json& data, const std::string& machine) {
  report::Table table{machine + ": distribution over the models that it can draw", {"count", "models"}, {}};
  for (const auto& [key, title] : marks) table.columns.emplace_back(title);
  const std::string at = report::child_pointer("/distributions", machine);
  for (const auto& [name, distribution] : data["distributions"][machine].items()) {
    const std::string here = report::child_pointer(at, name);
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    report::Row row{{words}, report::cell(data, here + "/count")};
    for (const auto& [key, title] : marks) row.push_back(report::cell(data, here + "/" + key));
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::ordered_json distribution_json(const Distribution& one, bool adds_up) {
  nlohmann::ordered_json json{{"count", one.count},
                              {"minimum", one.minimum},
                              {"first_quartile", one.first_quartile},
                              {"median", one.median},
                              {"third_quartile", one.third_quartile},
                              {"maximum", one.maximum}};
  if (adds_up) json["total"] = one.total;
  return json;
}

class Corpus : public StudyOf<CorpusRow> {
 public:
  void add_options(session::OptionList& command) override {
    command.option("MODEL", models_, "Models (.csg, .scad or .jan), or folders that contain them").required();
    command.option("--machines", machines_, "Machines, as names or .toml files separated by commas")
        .check(session::check_by_parsing(session::check_machines));
    view_.add_view_to(command);
    command.option("--z-bits", view_.z_bits, "Depth bits").between(view::min_z_bits, view::max_z_bits);
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return session::input_files(corpus_files(models_), session::parse_words(machines_));
  }
  [[nodiscard]] std::filesystem::path output_named_after() const override { return models_.front(); }
  [[nodiscard]] std::set<std::string> varied_options() const override { return {"machines"}; }

  /// Requests all machines of a model before the next model.
  std::vector<PointRequest> request_points() override {
    JobMaker maker;
    std::vector<PointRequest> requested;
    for (const std::string& model : corpus_files(models_)) {
      for (const std::string& machine : session::parse_words(machines_)) {
        session::ModelRequest one = view_;
        one.model = model;
        one.machine = machine;
        points_.push_back({escaped(model), escaped(machine)});
        jobs_.push_back(maker.make_job(one));
        requested.push_back({to_line(points_.back()), jobs_.back().inputs});
      }
    }
    return requested;
  }

  void print() const override {
    print_rows(rows());
    print_distributions(rows());
  }

  /// Adds the distribution of each column for each machine.
  [[nodiscard]] std::string json(const std::string& title) const override {
    nlohmann::ordered_json json = points_json(title, rows().size(), make_point_setter(Rows(rows())));
    json["distributions"] = nlohmann::ordered_json::object();
    for (const std::string& machine : machines_of(Rows(rows()))) {
      for (const CorpusColumn& column : corpus_columns())
        json["distributions"][machine][column.name] =
            distribution_json(distribution_of(rows(), machine, column), column.adds_up);
    }
    return json_file_text(json);
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override { return plots_of_corpus(rows()); }
  [[nodiscard]] std::string page_title() const override { return "Cost of many models"; }

  [[nodiscard]] PageSubject page_subject() const override {
    PageSubject subject = page_subject_on_machines(view_, machines_);
    subject.has_picture = false;
    subject.model.model = rows().front().point.model;
    const std::size_t models = group_by_model(Rows(rows())).size();
    if (models > 1) subject.name = session::count_text(models, "model");
    return subject;
  }

  [[nodiscard]] std::vector<report::Section> sections(const report::Json& data) const override {
    report::Section distributions{"Distributions", {}};
    for (const auto& [machine, counts] : data["distributions"].items())
      distributions.parts.emplace_back(distribution_table(data, machine));
    return {std::move(distributions)};
  }

  void refuse() const override { refuse_failed_models(Rows(rows()), "corpus.csv"); }

 protected:
  [[nodiscard]] CorpusRow measure_point(std::size_t point) override {
    return studies::measure(points_[point], jobs_[point]);
  }

 private:
  session::ModelRequest view_;
  std::vector<std::string> models_;  ///< files and folders
  std::string machines_ = session::studied_machines_text();
  std::vector<CorpusPoint> points_;
  std::vector<Job> jobs_;
};

}  // namespace

extern const StudyRow corpus_row{
    .name = "corpus",
    .does = "Count the cost of many models on many machines: totals, distributions, plots",
    .example =
        "  csgsim corpus parts -o parts-corpus\n"
        "  csgsim corpus a.csg b.scad parts --machines pixel-planes-4,mine.toml --size 256x256 -o out\n"
        "If a model cannot be read or a machine cannot draw it, its row holds the reason; the exit code is 1 if "
        "some\n"
        "model can be drawn by no machine. Each result is written to corpus.csv immediately; after an interruption,\n"
        "the same command resumes, and with more models or machines it measures only the new ones.",
    .plots = "plots (.png, .svg) of clocks and frames/s",
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Corpus>()); }};

}  // namespace csgsim::studies
