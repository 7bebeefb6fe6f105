#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/text.h"
#include "hw/machines/hash.h"
#include "hw/machines/names.h"
#include "sim/report/points.h"
#include "sim/session/model/transparent_parts.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/session/run/memory.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/design/meter.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/explore/options.h"
#include "sim/studies/explore/show.h"
#include "sim/studies/folder.h"
#include "sim/studies/groups.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/sensitivity/outcome.h"
#include "sim/studies/sensitivity/show.h"
#include "sim/studies/sensitivity/variants.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

/// Combined hash of the machine and of all parameters of the process.
std::string with_process(const std::string& machine_hash, const process::Process& process) {
  Hash hash;
  hash.add(machine_hash);
  for (const machines::Figure& figure : process.figures) hash.add(fmt::format("\n{}={}", figure.key, figure.value));
  return hash.text();
}

/// Table of a group's front.
report::Table front_table(const report::Json& data, std::size_t number) {
  const report::Json& group = data["fronts"][number];
  const std::string at = "/fronts/" + std::to_string(number);
  const std::string model = group["model"].is_null() ? "All models" : group["model"].get<std::string>();
  report::Table table{model + ": Pareto-optimal designs", {"knee"}, {}};
  std::vector<std::string> keys;
  for (const report::Json& one : group["front"]) {
    for (const auto& [key, value] : one["design"].items()) {
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  for (const std::string& key : keys) table.columns.push_back(key);
  for (const report::Json& axis : group["axes"]) table.columns.push_back(axis.get<std::string>());
  for (std::size_t i = 0; i < group["front"].size(); ++i) {
    const report::Json& one = group["front"][i];
    const std::string design = fmt::format("{}/front/{}/design", at, i);
    const std::string values = fmt::format("{}/front/{}/values", at, i);
    const bool is_knee = one["design"] == group["knee"]["design"];
    report::Row row{report::Cell{is_knee ? "knee" : ""}};
    for (const std::string& key : keys) row.push_back(report::cell(data, report::child_pointer(design, key)));
    for (const report::Json& axis : group["axes"])
      row.push_back(report::cell(data, report::child_pointer(values, axis.get<std::string>())));
    table.rows.push_back(std::move(row));
  }
  return table;
}

class Explore : public StudyOf<ExploreRow> {
 public:
  void add_options(session::OptionList& command) override {
    options_.add_to(command);
    command_ = &command;
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    std::vector<std::string> files = options_.models;
    if (!options_.model.scene_file.empty()) files.push_back(options_.model.scene_file);
    if (const std::string_view file = machines::file_of(options_.process); !file.empty()) files.emplace_back(file);
    return session::input_files(files, {options_.model.machine});
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    std::set<std::string> names{"vary",    "points",  "seed",        "search", "axes",
                                "machine", "process", "sensitivity", "samples"};
    for (const Axis& axis : axes()) names.emplace(axis.key);
    return names;
  }

  std::vector<PointRequest> request_points() override {
    grid_.emplace(options_.designs());
    variants_ = options_.variants();
    check_number();
    process_ = options_.loaded_process();
    std::vector<PointRequest> requested = ask_from(0);
    refuse_unread();
    return requested;
  }

  [[nodiscard]] bool is_adaptive() const override { return options_.search > 0; }

  /// Neighbours of designs on the front of all models (or of the only model).
  std::vector<PointRequest> request_more_points() override {
    const std::size_t before = grid_->designs().size();
    const std::size_t found = before - first_designs_;
    if (found >= options_.search || groups_.empty()) return {};
    const ExploreGroup& group = groups_.back().group;
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < group.rows.size(); ++i)
      if (group.front[i]) front.push_back(design_of_point_[group.rows[i]]);
    grid_->add_neighbours(front, options_.search - found);
    return ask_from(before);
  }

  void print() const override {
    print_explored(stated(), groups_);
    if (sensitivity_) print_sensitivity(rows(), *sensitivity_, designs_of(stated(), *sensitivity_));
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    return explore_json(title, rows(), groups_, sensitivity_ ? &*sensitivity_ : nullptr);
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    std::vector<plots::Plot> all = plots_of_explore(groups_);
    if (sensitivity_)
      std::ranges::move(plots_of_sensitivity(*sensitivity_, designs_of(stated(), *sensitivity_)),
                        std::back_inserter(all));
    return all;
  }

  [[nodiscard]] std::string page_title() const override { return "Design space"; }

  [[nodiscard]] PageSubject page_subject() const override {
    return page_subject_of_models(without_duplicates(options_.models), options_.model, options_.model.machine);
  }

  [[nodiscard]] std::vector<report::Section> sections(const report::Json& data) const override {
    report::Section fronts{"Fronts", {}};
    report::Table commands{"Commands that draw the knees", {"model", "command"}, {}, true};
    for (std::size_t i = 0; i < data["fronts"].size(); ++i) {
      const report::Json& group = data["fronts"][i];
      if (!group.contains("knee")) continue;
      fronts.parts.emplace_back(front_table(data, i));
      for (std::size_t j = 0; j < group["knee"]["commands"].size(); ++j) {
        const std::string at = "/fronts/" + std::to_string(i);
        commands.rows.push_back({group["model"].is_null() ? report::Cell{"all"} : report::cell(data, at + "/model"),
                                 report::cell(data, at + "/knee/commands/" + std::to_string(j))});
      }
    }
    std::vector<report::Section> sections;
    if (!fronts.parts.empty()) {
      fronts.parts.emplace_back(std::move(commands));
      sections.push_back(std::move(fronts));
    }
    if (data.contains("sensitivity")) {
      if (report::Section section = sensitivity_section(data); !section.parts.empty())
        sections.push_back(std::move(section));
    }
    return sections;
  }

  void refuse() const override {
    const std::span<const ExploreRow> all = rows();
    if (std::ranges::none_of(all, &ExploreRow::is_compiled) && group_by_model(all).size() == 1)
      throw InputError(all.front().reason);
    if (std::ranges::any_of(all, [](const ExploreRow& row) { return row.unexplained > 0; }))
      throw_inconsistent_results("the errors of a picture exceed the bounds of docs/numbers.md", are_read());
    refuse_failed_models(all, "explore.csv");
  }

 protected:
  [[nodiscard]] ExploreRow measure_point(std::size_t point) override {
    const Job& job = jobs_[point];
    return session::with_memory_for_picture(
        {job.machine.picture.width, job.machine.picture.height, session::ample_memory_bits},
        [&] { return ExploreRow(meter_.measure(points_[point], job, process_of(points_[point]))); });
  }

  void derive_results() override {
    const std::vector<ExploreAxis> axes = parse_axes(options_.requested_axes());
    groups_.clear();
    if (options_.sensitivity) take_variants(axes);
    for (ExploreGroup& group : groups_of(stated(), axes)) {
      std::vector<std::string> commands = commands_of(group);
      groups_.push_back({std::move(group), std::move(commands)});
    }
  }

 private:
  /// Requests the designs from index `first` on.
  std::vector<PointRequest> ask_from(std::size_t first) {
    std::vector<PointRequest> requested;
    for (const std::string& model : without_duplicates(options_.models)) {
      for (std::size_t i = first; i < grid_->designs().size(); ++i) {
        for (const Variant& variant : variants_.all) {
          session::ModelRequest design = grid_->designs()[i];
          design.model = model;
          design.machine += name_suffix(variants_, variant, false);
          add(design, name_suffix(variants_, variant, true));
          design_of_point_.push_back(i);
          requested.push_back({point_cells<ExploreRow>(points_.back()), jobs_.back().inputs});
        }
      }
    }
    if (first == 0) first_designs_ = grid_->designs().size();
    return requested;
  }

  /// Throws InputError, before anything is written, if no model can be read.
  void refuse_unread() const {
    if (!jobs_.empty() && std::ranges::none_of(jobs_, [](const Job& job) { return job.subject != nullptr; }))
      throw InputError(jobs_.front().reason);
  }

  /// The rows with the stated figures: all, without --sensitivity.
  [[nodiscard]] std::span<const ExploreRow> stated() const {
    return sensitivity_ ? std::span<const ExploreRow>(stated_) : rows();
  }

  /// Throws UsageError if there are too many points.
  void check_number() const {
    const std::size_t points = grid_->designs().size() * variants_.all.size();
    if (variants_.all.size() == 1 || points <= max_designs) return;
    throw session::UsageError(
        "--sensitivity", fmt::format("{} designs with {} variants each are {} points, the maximum is {}; vary fewer "
                                     "parameters or take fewer --samples",
                                     grid_->designs().size(), variants_.all.size(), points, grouped(max_designs)));
  }

  /// The variants follow from the options and the files of the machine and the process, also for gathered rows.
  void take_variants(std::span<const ExploreAxis> axes) {
    if (variants_.figures.empty()) variants_ = options_.variants();
    const std::size_t models = without_duplicates(options_.models).size();
    if (rows().size() % (models * variants_.all.size()) != 0)
      throw InputError(
          "the file of the machine or of the process has changed since the points were measured; "
          "measure them again");
    stated_ = stated_rows(rows(), variants_.all.size());
    sensitivity_ = sensitivity_of(rows(), models, variants_, axes);
  }

  /// Adds a design. If its parameters are inconsistent, its row holds the reason.
  void add(const session::ModelRequest& design, const std::string& process_changes) {
    try {
      Job job = maker_.make_job(design);
      refuse_unseen(design, job);
      DesignPoint point = point_of(design, job.machine.picture);
      if (options_.has_memory(design)) point.memory_bits = job.machine.array.memory_bits;
      add(std::move(point), std::move(job), process_changes);
    } catch (const InputError& error) {
      add_refused(design, process_changes, error.what());
    } catch (const session::UsageError& error) {
      add_refused(design, process_changes, error.what());
    }
  }

  void add_refused(const session::ModelRequest& design, const std::string& process_changes, const std::string& why) {
    session::ModelRequest plain = options_.model;
    plain.model = design.model;
    plain.sets = design.sets;
    Job job = maker_.make_job(plain);
    job.reason = escaped(why);
    add(point_of(design, {}), std::move(job), process_changes);
  }

  void add(DesignPoint point, Job job, const std::string& process_changes) {
    if (process_) {
      point.process = escaped(process_->name) + process_changes;
      job.inputs.machine_hash = with_process(job.inputs.machine_hash, load_changed(point.process, process_changes));
    }
    points_.push_back(std::move(point));
    jobs_.push_back(std::move(job));
  }

  /// The process of that name in a point, with changes in addition to those of --process.
  const process::Process& load_changed(const std::string& name, const std::string& changes) {
    const auto [known, is_new] = processes_.try_emplace(name);
    if (is_new) known->second = changes.empty() ? *process_ : process::load_process(options_.process + changes);
    return known->second;
  }

  [[nodiscard]] const process::Process* process_of(const DesignPoint& point) const {
    return point.process.empty() ? nullptr : &processes_.at(point.process);
  }

  /// Rejects designs with transparent solids, which cannot be compared with an exact picture.
  void refuse_unseen(const session::ModelRequest& design, Job& job) {
    if (!job.reason.empty()) return;
    const auto [known, is_new] = transparency_.try_emplace(job.subject.get());
    if (is_new) {
      try {
        session::refuse_transparent_parts(session::emit_options_of(design), job.subject->tree, job.camera);
      } catch (const InputError& error) {
        known->second = escaped(error.what());
      }
    }
    job.reason = known->second;
  }

  /// Commands that draw a group's knee, one per model of the group, with enough memory for all of them.
  [[nodiscard]] std::vector<std::string> commands_of(const ExploreGroup& group) const {
    if (!group.knee) return {};
    const DesignPoint& knee = stated()[group.rows[*group.knee]].point;
    std::vector<const ExploreRow*> drawn;
    std::uint32_t memory_bits = 0;
    for (const ExploreRow& row : stated()) {
      DesignPoint same = row.point;
      same.model = knee.model;
      const bool is_meant = group.model.empty() || row.point.model == group.model;
      if (!is_meant || same != knee) continue;
      drawn.push_back(&row);
      memory_bits = std::max(memory_bits, row.point.memory_bits.value_or(row.used_bits));
    }
    std::vector<std::string> commands;
    for (const ExploreRow* const row : drawn) {
      const std::string picture = plot_stem(row->point.model) + "-knee.png";
      commands.push_back(render_command(options_, *command_, *row, memory_bits, picture));
    }
    return commands;
  }

  ExploreOptions options_;
  const session::OptionList* command_ = nullptr;
  std::optional<process::Process> process_;            ///< as stated
  std::map<std::string, process::Process> processes_;  ///< by their names in points
  Variants variants_;
  std::optional<DesignGrid> grid_;
  std::size_t first_designs_ = 0;  ///< number of designs before the search
  JobMaker maker_;
  std::vector<DesignPoint> points_;
  std::vector<std::size_t> design_of_point_;  ///< index in the grid
  std::vector<Job> jobs_;
  std::map<const Subject*, std::string>
      transparency_;  ///< why a model cannot be compared with an exact picture; empty if it can
  DesignMeter meter_;
  std::vector<ShownGroup> groups_;
  std::vector<ExploreRow> stated_;  ///< only with --sensitivity
  std::optional<SensitivityOutcome> sensitivity_;
};

}  // namespace

extern const StudyRow explore_row{
    .name = "explore",
    .does = "Explore the design space of a machine: vary parameters, show the Pareto front and its knee",
    .example =
        "  csgsim explore carburettor.csg --size 128x128 --vary alu.bits=1,2,4 --vary memory.reads=1,2 "
        "--vary z-bits=12..20 -o carburettor-explore\n"
        "  csgsim explore *.csg --vary link.width=8,16,32 --vary z-bits=10..24 --vary fraction-bits=2..12 "
        "--points 500 --seed 2 --axes time,memory -o out\n"
        "  csgsim explore *.csg --vary z-bits=8..30 --vary fraction-bits=0..16 --points 20 --search 200 -o out\n"
        "  csgsim explore carburettor.csg --vary alu.bits=2 --vary evaluator.bits=1,2 --process nmos-3um --sensitivity "
        "-o ranges\n"
        "A design is on the front if no other is as good on every axis and better on one. The knee is the design on "
        "the\n"
        "front that is closest to the best values of all axes: logarithms are scaled from 0, the minimum on the front, "
        "to\n"
        "1, the maximum, and the sum of squares is minimized. Unless the memory bits per pixel are specified, each\n"
        "design has as many as its Program uses. Results are written to explore.csv in small groups; after an "
        "interruption,\n"
        "the same command resumes, and with other values it measures only the new designs.",
    .plots = "plots (.png, .svg) of the front of each model and of all models",
    .is_quick = true,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Explore>()); }};

}  // namespace csgsim::studies
