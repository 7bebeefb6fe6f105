#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/machines/hash.h"
#include "sim/observe/bound.h"
#include "sim/report/points.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/transparent_parts.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/machine_list.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/version.h"
#include "sim/session/run/memory.h"
#include "sim/studies/compare/ideal.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/compare/software.h"
#include "sim/studies/compare/words.h"
#include "sim/studies/folder.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const ComparisonRow>;

constexpr unsigned most_fragments = 4096;

struct Options {
  session::ModelRequest model;
  std::string machines = session::studied_machines_text();
  std::string sides = "128,256,512";
  std::string fragments = "8,16,32,64";
  std::string with = "none";
  bool ideal = false;
};

/// Treats an empty list like `none`, for compatibility with earlier versions.
bool is_none(const std::string& text) { return text.empty() || text == "none"; }

std::vector<unsigned> parse_fragments(const std::string& text) {
  return is_none(text) ? std::vector<unsigned>{} : session::parse_numbers(text, 3, most_fragments);
}
std::vector<unsigned> parse_sides(const std::string& text) {
  return is_none(text) ? std::vector<unsigned>{} : session::parse_numbers(text, 1, isa::max_array_side);
}

std::vector<SoftwareChoice> parse_software_option(const std::string& text) {
  return is_none(text) ? std::vector<SoftwareChoice>{} : parse_software_choices(text);
}

/// A machine with the picture size given by --size.
struct Named {
  std::string name;
  machines::Machine machine;
};

std::vector<Named> named_machines(const Options& options) {
  std::vector<Named> machines;
  for (const std::string& name : session::with_parameters(session::parse_words(options.machines), options.model.sets)) {
    session::ModelRequest one = options.model;
    one.machine = name;  // with its figures as set
    one.sets = session::divide_settings(one.sets).scene;
    machines.push_back({escaped(name), session::machine_of(one)});
  }
  return machines;
}

/// The points of --ideal: the machine's picture, on the machine as described and with each parameter made ideal.
std::vector<ComparisonPoint> ideal_points(const Named& machine) {
  const machines::Size& picture = machine.machine.picture;
  std::vector<ComparisonPoint> points{{machine.name, picture.width, picture.height, 0}};
  for (const std::string& choice : ideal_choices(machine.machine)) {
    points.push_back(points.front());
    points.back().ideal = choice;
  }
  return points;
}

/// The points of a machine: its picture with the model's own facets and with each of --fragments, and each of --sides.
std::vector<ComparisonPoint> points_of(const Options& options, const Named& machine) {
  if (options.ideal) return ideal_points(machine);
  const machines::Size& picture = machine.machine.picture;
  std::vector<ComparisonPoint> points{{machine.name, picture.width, picture.height, 0}};
  const auto add = [&](const ComparisonPoint& point) {
    if (std::ranges::find(points, point) == points.end()) points.push_back(point);
  };
  for (const unsigned fragments : parse_fragments(options.fragments))
    add({machine.name, picture.width, picture.height, static_cast<double>(fragments)});
  for (const unsigned side : parse_sides(options.sides)) add({machine.name, side, side, 0});
  return points;
}

view::Sampling sampling_at(const Options& options, const ComparisonPoint& point, const machines::Machine& machine) {
  view::Sampling sampling = session::sampling_of(options.model, machine);
  sampling.width = point.width;
  sampling.height = point.height;
  return sampling;
}

/// Width of the column of machine names: the longest name and a space.
std::size_t name_width(Rows rows) {
  std::size_t width = 16;
  for (const ComparisonRow& row : rows) width = std::max(width, row.point.machine.size() + 1);
  return width;
}

void print_row(const ComparisonRow& row, std::size_t width) {
  const std::string facets = row.point.fragments == 0 ? "own" : fmt::format("{}", row.point.fragments);
  fmt::print("{:<{}}{:>11}{:>7}", row.point.machine, width, fmt::format("{}x{}", row.point.width, row.point.height),
             facets);
  if (!row.is_drawn()) {
    fmt::print("  {}\n", row.reason);
    return;
  }
  const auto of_count = [](std::uint64_t count) { return quantity(static_cast<double>(count), ""); };
  fmt::print("{:>8}{:>13}{:>9}{:>10}{:>12}{:>12}{:>10}{:>11}{:>13}{:>9.3f}\n", row.halfspaces,
             row.clocks > 0 ? grouped(row.clocks) : "-", quantity(row.simulated_seconds, "s"),
             observe::rate_text(row.frames_per_second), of_count(row.pixel_operations), grouped(row.processors),
             of_count(row.processor_clocks), quantity(static_cast<double>(row.machine_memory_bits), "bit"),
             row.machine_transistors ? of_count(*row.machine_transistors) : "-", 100.0 * row.utilisation);
}

/// Prints the gain of each idealization of a machine relative to the machine as described, whose row precedes them.
void print_ideal_rows(Rows rows) {
  const std::size_t width = name_width(rows);
  fmt::print("{:<{}}{:<28}{:>13}{:>9}{:>10}{:>11}{:>9}\n", "machine", width, "ideal", "clocks", "time", "frames/s",
             "with host", "gain %");
  const ComparisonRow* as_described = nullptr;
  for (const ComparisonRow& row : rows) {
    if (row.point.ideal.empty()) as_described = &row;
    fmt::print("{:<{}}{:<28}", row.point.machine, width, row.point.ideal.empty() ? "as described" : row.point.ideal);
    if (!row.is_drawn()) {
      fmt::print("  {}\n", row.reason);
      continue;
    }
    fmt::print("{:>13}{:>9}{:>10}{:>11}", grouped(row.clocks), quantity(row.simulated_seconds, "s"),
               observe::rate_text(row.frames_per_second), observe::rate_text(row.hosted_frames_per_second));
    if (as_described != nullptr && as_described->is_drawn())
      fmt::print("{:>9.2f}", 100.0 * (1.0 - row.simulated_seconds / as_described->simulated_seconds));
    fmt::print("\n");
  }
}

void print_rows(Rows rows) {
  const std::size_t width = name_width(rows);
  fmt::print("{:<{}}{:>11}{:>7}{:>8}{:>13}{:>9}{:>10}{:>12}{:>12}{:>10}{:>11}{:>13}{:>9}\n", "machine", width,
             "picture", "$fn", "halfsp.", "clocks", "time", "frames/s", "operations", "processors", "capacity",
             "memory", "transistors", "util. %");
  for (const ComparisonRow& row : rows) print_row(row, width);
  fmt::print(
      "operations: at all pixels; capacity: processors times clocks.\n"
      "Transistor counts are estimates (docs/hardware.md) of the processors with their memory; -: not synthesized.\n");
}

/// The gain of each idealization of a machine relative to the machine as described, whose row precedes them.
report::Table worth_table(const report::Json& data) {
  report::Table table{"Gain of each idealization", {"machine", "ideal", "clocks", "seconds", "gain"}, {}};
  double as_described = 0;
  for (std::size_t i = 0; i < data["points"].size(); ++i) {
    const report::Json& point = data["points"][i];
    if (!report::is_measured(point)) continue;
    const std::string at = "/points/" + std::to_string(i);
    const bool is_plain = point["ideal"].get<std::string>().empty();
    if (is_plain) as_described = point["simulated_seconds"].get<double>();
    table.rows.push_back({report::cell(data, at + "/machine"),
                          is_plain ? report::Cell{"as described"} : report::cell(data, at + "/ideal"),
                          report::cell(data, at + "/clocks"), report::cell(data, at + "/simulated_seconds"),
                          is_plain || as_described == 0
                              ? report::Cell{}
                              : report::share(as_described - point["simulated_seconds"].get<double>(), as_described)});
  }
  return table;
}

/// Compares pictures of the same size and facets, which must be equal on all machines. Describes the first difference;
/// empty if there is none.
std::string difference_of(Rows rows) {
  for (const ComparisonRow& row : rows) {
    const auto first = std::ranges::find_if(rows, [&](const ComparisonRow& other) {
      return other.is_drawn() && other.point.width == row.point.width && other.point.height == row.point.height &&
             other.point.fragments == row.point.fragments;
    });
    // Software computes no colours.
    const auto differs = [&] {
      const bool have_colours = !row.picture.empty() && !first->picture.empty();
      return first->surfaces != row.surfaces || (have_colours && first->picture != row.picture);
    };
    if (row.is_drawn() && differs()) {
      return fmt::format("the picture of {} with {}x{} pixels differs from that of {}", row.point.machine,
                         row.point.width, row.point.height, first->point.machine);
    }
  }
  return "";
}

class Compare : public StudyOf<ComparisonRow> {
 public:
  void add_options(session::OptionList& command) override {
    options_.model.add_to(command);
    command.remove("--machine");
    command.remove("--tolerance");
    command.remove("--curves");  // all machines draw the same facets
    command.option("--machines", options_.machines, "Machines to compare, as names or .toml files separated by commas")
        .check(session::check_by_parsing(session::check_machines));
    command
        .option("--fragments", options_.fragments,
                "Values of $fn for all curved solids, separated by commas, which vary the number of half-spaces at one "
                "picture size; `none`: only the model's own")
        .check(session::check_by_parsing(parse_fragments));
    command
        .option("--sides", options_.sides,
                "Sides of square pictures in pixels, separated by commas; `none`: only one size")
        .check(session::check_by_parsing(parse_sides));
    command.flag(
        "--ideal", options_.ideal,
        "Measure the gain of idealizations: make each suitable parameter of a machine ideal, one after another and "
        "all at once; ignores --sides and --fragments, and draws no plots");
    command
        .option("--with", options_.with,
                "Software to compare with, as PROCESSOR:METHOD separated by commas, such as mc68000:status/one-list "
                "(csgsim manual methods, processors; this-computer is measured); `none`: no software")
        .check(session::check_by_parsing(parse_software_option))
        .excludes("--ideal");
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return session::input_files({options_.model.model}, session::parse_words(options_.machines));
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    return {"machines", "sides", "fragments", "with"};
  }
  [[nodiscard]] std::string table_model() const override { return options_.model.model; }

  std::vector<PointRequest> request_points() override {
    session::ModelFile file = session::read_model_file(options_.model);
    tree_ = std::move(file.tree);
    const facet::Geometry scene = facet::make_geometry(tree_);
    const std::vector<Named> machines = named_machines(options_);
    for (const Named& machine : machines) add_jobs(machine, std::nullopt, file.hash, scene);
    // Software draws the pictures of the first machine, and only opaque solids.
    for (const SoftwareChoice& software : parse_software_option(options_.with)) {
      session::refuse_transparent_parts(session::emit_options_of(options_.model), tree_,
                                        session::camera_of(options_.model, machines.front().machine, tree_, scene));
      add_jobs({software.name, machines.front().machine}, software, file.hash, scene);
    }
    std::vector<PointRequest> requested;
    for (const ComparisonJob& job : jobs_) requested.push_back({to_line(job.point), job.inputs});
    return requested;
  }

  void print() const override {
    options_.ideal ? print_ideal_rows(rows()) : print_rows(rows());
    print_comparison_summary(rows());
    if (std::ranges::any_of(rows(), &ComparisonRow::is_drawn) && difference_of(rows()).empty())
      fmt::print("\nPictures of the same size and facets are identical on all machines.\n");
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    if (options_.ideal) return {};
    // The first point has the first machine's own picture.
    const ComparisonPoint& first = rows().front().point;
    return plots_of_comparison(rows(), {first.width, first.height}, plot_stem(options_.model.model));
  }

  [[nodiscard]] std::string page_title() const override { return "Comparison of machines"; }

  [[nodiscard]] PageSubject page_subject() const override {
    PageSubject subject{options_.model, {}};
    for (const Named& machine : named_machines(options_)) subject.machines.push_back(machine.machine);
    return subject;
  }

  [[nodiscard]] std::vector<report::Section> sections(const report::Json& data) const override {
    if (!options_.ideal) return {};
    return {{"Idealizations", {worth_table(data)}}};
  }

  void refuse() const override {
    if (std::ranges::none_of(rows(), &ComparisonRow::is_drawn)) throw InputError(rows().front().reason);
    if (const std::string difference = difference_of(rows()); !difference.empty())
      throw_inconsistent_results(difference, are_read());
  }

 protected:
  [[nodiscard]] ComparisonRow measure_point(std::size_t point) override {
    const ComparisonJob& job = jobs_[point];
    return session::with_memory_for_picture({job.point.width, job.point.height, job.machine.array.memory_bits},
                                            [&] { return studies::measure(job, tree_); });
  }

 private:
  void add_jobs(const Named& machine, const std::optional<SoftwareChoice>& software, const std::string& hash,
                const facet::Geometry& scene) {
    const Inputs inputs{hash, software ? hash_of(software->processor) : machines::hash_of(machine.machine),
                        session::version_and_build()};
    const view::Camera camera = session::camera_of(options_.model, machine.machine, tree_, scene);
    for (const ComparisonPoint& point : points_of(options_, machine)) {
      jobs_.push_back({point, inputs, with_ideal_parameters(machine.machine, point.ideal), camera,
                       sampling_at(options_, point, machine.machine), session::emit_options_of(options_.model),
                       software});
    }
  }

  Options options_;
  model::Tree tree_;
  std::vector<ComparisonJob> jobs_;
};

}  // namespace

extern const StudyRow compare_row{
    .name = "compare",
    .does = "Draw a model on several machines and compare clocks, time, memory, utilization and growth",
    .example =
        "  csgsim compare carburettor.csg --camera 220,-255,135,2,0,5\n"
        "  csgsim compare carburettor.csg --machines pixel-planes-4,mine.toml --sides 64,128 --fragments 8,16 -o out\n"
        "  csgsim compare carburettor.csg --camera 220,-255,135,2,0,5 --with mc68000:status/one-list\n"
        "  csgsim compare carburettor.csg --camera 220,-255,135,2,0,5 --ideal -o carburettor-ideal\n"
        "Each result is written to compare.csv immediately; after an interruption, the same command resumes.",
    .plots = "plots (.png, .svg) of the machines and of the time against half-spaces and pixels",
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Compare>()); },
    .group = session::everyday_group};

}  // namespace csgsim::studies
