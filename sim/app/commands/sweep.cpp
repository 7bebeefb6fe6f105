#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/memory.h"
#include "sim/app/numbers.h"
#include "sim/app/options.h"
#include "sim/app/paths.h"
#include "sim/app/report_option.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/studies.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/studies/sweep_options.h"
#include "sim/app/studies/sweep_progress.h"
#include "sim/app/studies/sweep_report.h"
#include "sim/study/plot_stem.h"
#include "sim/study/ranges.h"
#include "sim/study/sweep_plots.h"
#include "sim/study/table.h"

namespace csgsim::app {

namespace {

using study::SweepRow;
using Rows = std::vector<SweepRow>;
using Table = study::Table<SweepRow>;

/// Everything that all points share; tables of other sweeps are refused by it. The rest is in each point.
std::string title_of(const Command& command) {
  return study_title(command, {"strategy", "stack-bits", "z-bits", "colouring", "curves", "pruning", "machine",
                               "memory-bits", "no-draw"});
}

study::WantedPoint wanted(const SweepOptions& options, const study::SweepJob& job) {
  return {job.point, job.inputs, !options.no_draw};
}

/// Jobs in parallel.
void measure_jobs(const SweepOptions& options, const std::vector<study::SweepJob>& jobs,
                  const std::function<void(SweepRow)>& finished) {
  with_memory_for_threads(options.threads, "points",
                          [&] { study::measure_all(jobs, !options.no_draw, options.threads, finished); });
}

/// Measures the points that the table has not, and returns all in their order. So they are in the file at the end,
/// before what it has of other points.
Rows complete(const SweepOptions& options, const std::vector<study::SweepJob>& jobs, Table& table) {
  std::vector<study::SweepJob> missing;
  for (const study::SweepJob& job : jobs) {
    if (table.find(wanted(options, job)) == nullptr) missing.push_back(job);
  }
  SweepProgress progress(jobs.size(), jobs.size() - missing.size(), shows_progress(options.progress), options.threads);
  measure_jobs(options, missing, [&](SweepRow row) {
    table.add(std::move(row));
    progress.done();
  });
  Rows rows;
  for (const study::SweepJob& job : jobs) rows.push_back(*table.find(wanted(options, job)));
  Rows all = rows;
  for (const SweepRow& row : table.rows()) {
    const bool is_asked =
        std::any_of(jobs.begin(), jobs.end(), [&](const study::SweepJob& job) { return job.point == row.point; });
    if (!is_asked) all.push_back(row);
  }
  table.replace(std::move(all));
  return rows;
}

/// Rows of each model, by a name for its plots: that of its file, numbered where several have it.
std::vector<std::pair<std::string, Rows>> by_model(const Rows& rows) {
  std::vector<std::pair<std::string, Rows>> models;
  std::map<std::string, unsigned> uses;
  for (const SweepRow& row : rows) {
    if (models.empty() || models.back().second.front().point.model != row.point.model) {
      const std::string stem = study::plot_stem(row.point.model);
      const unsigned use = ++uses[stem];
      models.emplace_back(use == 1 ? stem : fmt::format("{}-{}", stem, use), Rows{});
    }
    models.back().second.push_back(row);
  }
  return models;
}

bool is_compiled(const SweepRow& row) { return row.compiled(); }

/// A model of which there is no Program at all.
void refuse_models(const Rows& rows) {
  std::vector<std::string> failed;
  const std::vector<std::pair<std::string, Rows>> models = by_model(rows);
  for (const auto& [name, of_model] : models) {
    if (std::ranges::none_of(of_model, is_compiled)) failed.push_back(of_model.front().point.model);
  }
  if (!failed.empty()) throw InputError(failed_models(failed, models.size(), "sweep.csv"));
}

/// Whether every machine draws the same surfaces of a model: facets, or all that can be curved.
bool draws_alike(const Rows& rows) {
  std::map<std::string, std::uint64_t> halfspaces;
  return std::ranges::all_of(rows, [&](const SweepRow& row) {
    return !is_compiled(row) || halfspaces.try_emplace(row.point.model, row.halfspaces).first->second == row.halfspaces;
  });
}

void refuse_failures(const SweepOptions& options, const Rows& rows, bool has_read_rows) {
  if (std::ranges::none_of(rows, is_compiled) && by_model(rows).size() == 1) throw InputError(rows.front().reason);
  const std::vector<study::WrongPicture> wrong = study::wrong_pictures(rows);
  if (wrong.empty()) {
    if (!options.no_draw && std::ranges::any_of(rows, is_compiled))
      fmt::print("\nAll pictures of a model with the same {} are the same, byte for byte.\n",
                 draws_alike(rows) ? "size and z bits" : "size, z bits and surfaces, curved or faceted,");
    refuse_models(rows);
    return;
  }
  const study::PointNames names(rows);
  fmt::print("\n");
  for (const study::WrongPicture& one : wrong) {
    const std::string what = one.reference ? "the picture differs from that of " + names.name(*one.reference)
                                           : "a linear expression does not fit its width";
    fmt::print("WRONG: {}, {}: {}\n", one.point.model, names.name(one.point), what);
  }
  throw InputError(fmt::format("{} of {} pictures are not what they have to be; {}", wrong.size(), rows.size(),
                               whose_fault(has_read_rows)));
}

std::vector<study::WantedPoint> wanted_of(const SweepOptions& options, const std::vector<study::SweepJob>& jobs) {
  std::vector<study::WantedPoint> all;
  all.reserve(jobs.size());
  for (const study::SweepJob& job : jobs) all.push_back(wanted(options, job));
  return all;
}

/// With a picture of the first model on the first machine.
report::Page page_of(const SweepOptions& options, const std::string& points) {
  ModelOptions model = options.view;
  model.model = options.models.front();
  std::vector<machines::Machine> machines;
  for (const std::string& name : study::parse_words(options.machines)) {
    model.machine = name;
    machines.push_back(machine_of(model));
  }
  report::StudyContext context = study_context(options.report, model, machines);
  if (options.models.size() > 1) context.model = counted(options.models.size(), "model");
  return report::sweep_page(report::Json::parse(points), context);
}

void run_shard(const SweepOptions& options, const Command& command) {
  const std::vector<study::SweepJob> jobs = jobs_of(options);
  measure_shard<SweepRow>(command, options.folder, *options.shard, wanted_of(options, jobs), options.progress,
                          [&](const std::vector<std::size_t>& points, const auto& finished) {
                            std::vector<study::SweepJob> missing;
                            missing.reserve(points.size());
                            for (const std::size_t i : points) missing.push_back(jobs[i]);
                            measure_jobs(options, missing, finished);
                          });
}

/// Rows that the table has or gets.
Rows rows_of(const SweepOptions& options, const std::vector<study::SweepJob>& jobs,
             const std::filesystem::path& table_path, Table& table) {
  tell_stale(table_path, table.drop_stale(std::span<const study::WantedPoint>(wanted_of(options, jobs))));
  return complete(options, jobs, table);
}

void run(const SweepOptions& options, const Command& command, const study::Gathered* gathered) {
  if (options.shard) return run_shard(options, command);
  std::vector<study::SweepJob> jobs;
  if (gathered == nullptr) jobs = jobs_of(options);
  const auto inputs = input_files(options.models, study::parse_words(options.machines));
  const StudyFolder folder(options.folder, "sweep", inputs);
  ReportFile report(options.report, inputs);
  const std::string title = title_of(command);
  const std::filesystem::path table_path = folder.path() / "sweep.csv";
  Table table(table_path, title);
  const bool has_read_rows = gathered != nullptr || !table.rows().empty();
  const Rows rows =
      gathered != nullptr ? put_rows(*gathered, table_path, table) : rows_of(options, jobs, table_path, table);
  const std::string points = study::points_json(title, rows);
  write_file(folder.path() / "sweep.json", points);
  for (const auto& [name, of_model] : by_model(rows)) {
    print_sweep(of_model);
    if (!options.no_plots && std::ranges::any_of(of_model, is_compiled))
      study::draw_sweep(of_model, name, folder.path());
  }
  if (report.asked()) report.write(page_of(options, points));
  fmt::print(
      "\n{}: sweep.csv, sweep.json{}\n", printable(options.folder),
      options.no_plots ? "" : ", and for each model plots (.png, .svg) of scan-conversions, clocks, bits and memory");
  refuse_failures(options, rows, has_read_rows);
}

void add(CommandLine& line, const study::Gathered* gathered) {
  const auto options = std::make_shared<SweepOptions>();
  Command command = line.add(
      "sweep", "Show what memory bits buy: every strategy with every number of bits, in parallel",
      "Example:\n  csgsim sweep carburettor.csg --camera 220,-255,135,2,0,5 -o carburettor-sweep\n"
      "  csgsim sweep *.csg --strategy bits --stack-bits 3..12 --no-draw -o table_6_1\n"
      "  csgsim sweep a.csg b.csg --strategy stack,list --z-bits 16,20 --colouring rebroadcast,field -o out\n"
      "  csgsim sweep a.csg --strategy list --pruning all,no-space,no-picture,no-separation,none -o out\n"
      "Lists are with commas, ranges of numbers as 3..8; every combination is a point. What has been measured is in\n"
      "sweep.csv at once; the same command goes on after an interruption, and with other ranges measures what is new.");
  options->add_to(command);
  command.prints_summary();
  command.runs([options, command, gathered] { run(*options, command, gathered); });
}

}  // namespace

void add_sweep(CommandLine& line) { add(line, nullptr); }
void gather_sweep(CommandLine& line, const study::Gathered& gathered) { add(line, &gathered); }

}  // namespace csgsim::app
