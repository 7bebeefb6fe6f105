#include "sim/studies/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/interruption.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/plots/common_looks.h"
#include "sim/plots/files.h"
#include "sim/report/points.h"
#include "sim/report/study_pages.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"
#include "sim/studies/folder.h"
#include "sim/studies/progress.h"
#include "sim/studies/shard_run.h"
#include "sim/studies/table.h"
#include "sim/studies/vocabulary.h"

namespace csgsim::studies {

namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::string>;

/// Number of rows that are written together if they arrive faster than the disk can take single rows.
constexpr std::size_t max_pending = 8;

fs::path folder_of(const StudyCommand& request) {
  return request.options.folder.empty() ? default_output_folder(request.study->output_named_after(), request.row->name)
                                        : fs::path(request.options.folder);
}

std::string title_of(const StudyCommand& request) {
  const std::string model = request.study->table_model();
  std::string title = study_title(request.command, request.study->varied_options());
  if (!model.empty()) title += " of " + escaped(fs::path(model).filename().native());
  return title;
}

unsigned threads_of(const StudyCommand& request) { return request.row->is_parallel ? request.options.threads : 1; }

void measure(StudyCommand& request, std::span<const std::size_t> points, const Study::Finished& finished) {
  const unsigned threads = threads_of(request);
  session::with_memory_for_threads(threads, "points", [&] { request.study->measure(points, threads, finished); });
}

/// Measures the points that are missing from the table.
Rows complete(StudyCommand& request, std::span<const PointRequest> points, Table& table) {
  const std::vector<std::size_t> missing = table.missing(points);
  {
    Progress progress(points.size(), points.size() - missing.size(), session::shows_progress(request.options.progress),
                      threads_of(request));
    Rows pending;
    const auto write = [&] { table.add(std::exchange(pending, {})); };
    const std::size_t at_once = request.row->is_quick ? max_pending : 1;
    measure(request, missing, [&](std::size_t /*point*/, std::string row) {
      pending.push_back(std::move(row));
      if (pending.size() == at_once) write();
      progress.finish_point();
      throw_if_interrupted();
    });
    write();
  }
  return table.ordered_rows(points);
}

/// Combined inputs of all points.
Inputs inputs_of(std::span<const PointRequest> points) {
  Hash models;
  Hash machines;
  for (const PointRequest& one : points) {
    models.add(one.inputs.model_hash + "\n");
    machines.add(one.inputs.machine_hash + "\n");
  }
  return {models.text(), machines.text(), session::version_and_build()};
}

void refuse_page(const StudyCommand& request) {
  if (!request.options.report.is_requested()) return;
  throw session::UsageError("--report", "a shard has no page; csgsim gather writes one from all shards");
}

void run_shard(StudyCommand& request) {
  refuse_page(request);
  if (request.study->is_adaptive())
    throw session::UsageError(
        "--shard", "a search depends on earlier results and cannot be sharded; remove --shard or the search");
  const std::vector<PointRequest> points = request.study->request_points();
  if (points.size() > max_points)
    throw InputError(
        fmt::format("{} points are too many to be sharded, the maximum is {}; split them into several studies",
                    points.size(), max_points));
  ShardRun run(
      folder_of(request),
      {*request.options.shard, points.size(), inputs_of(points), request.command.words(options_without_effect)},
      request.command.words(options_of_shard), request.study->format().columns);
  {
    Progress progress(run.points(), run.points() - run.missing().size(),
                      session::shows_progress(request.options.progress));
    measure(request, run.missing(), [&](std::size_t point, std::string row) {
      run.add(point, std::move(row));
      progress.finish_point();
    });
  }
  run.print();
}

report::StudyContext page_context(const StudyCommand& request, const PageSubject& subject) {
  const session::ReportOption& report = request.options.report;
  report::StudyContext context = subject.has_picture
                                     ? session::study_context(report, subject.model, subject.machines)
                                     : session::plain_study_context(report, subject.model.model, subject.machines);
  if (!subject.name.empty()) context.model = subject.name;
  return context;
}

report::Page page_of(const StudyCommand& request, const std::string& json, std::span<const plots::Plot> plots) {
  const Study& study = *request.study;
  const report::StudyContext context = page_context(request, study.page_subject());
  report::Page page = report::begin_page(study.page_title() + ": " + context.model,
                                         study.page_data(report::Json::parse(json)), context);
  for (report::Section& section : study.sections(page.data)) page.sections.push_back(std::move(section));
  if (report::Section section = report::plots_section(plots); !section.parts.empty())
    page.sections.push_back(std::move(section));
  if (page.data.contains("points"))
    page.sections.push_back(
        {"Points",
         {report::points_table(page.data, "/points", "All measured points", page_columns(study.format().columns))}});
  report::end_page(page, context);
  return page;
}

/// Destinations of the results.
struct Places {
  std::optional<StudyFolder> folder;  ///< empty if results are not kept
  session::ReportFile report;
  std::string title;

  Places(const StudyCommand& request, std::span<const fs::path> inputs)
      : report(request.options.report, inputs), title(title_of(request)) {
    const bool is_kept = request.folder != Folder::optional || !request.options.folder.empty();
    if (is_kept) folder.emplace(folder_of(request), request.row->name, inputs);
  }

  [[nodiscard]] fs::path file(const StudyCommand& request, const char* ending) const {
    return folder->path() / (std::string(request.row->name) + ending);
  }
};

Table table_of(const StudyCommand& request, const Places& places) {
  const Study& study = *request.study;
  const auto serves = [&study](std::size_t point, const std::string& row) {
    return study.has_requested_results(point, row);
  };
  if (!places.folder) return Table(study.format(), serves);
  return {places.file(request, ".csv"), places.title, study.format(), serves};
}

/// Writes plots and the page if requested; returns whether plot files were written.
bool write_shown(const StudyCommand& request, Places& places, const std::string& json) {
  const bool has_plot_files = places.folder && !request.options.no_plots;
  std::vector<plots::Plot> plots;
  if (has_plot_files || places.report.is_requested()) plots = request.study->plots();
  // Series with the same name look the same in all plots of the study, even if several models have their own plots.
  plots::set_common_looks(plots);
  const bool are_drawn = has_plot_files && !plots.empty();
  if (are_drawn) plots::write_plots(plots, places.folder->path());
  if (places.report.is_requested()) places.report.write(page_of(request, json, plots));
  return are_drawn;
}

void show(const StudyCommand& request, Places& places) {
  const Study& study = *request.study;
  const std::string json = places.folder || places.report.is_requested() ? study.json(places.title) : "";
  if (places.folder) write_file(places.file(request, ".json"), json);
  study.print();
  const bool are_drawn = write_shown(request, places, json);
  if (places.folder)
    fmt::print("\n{}: {}.csv, {}.json{}\n", printable(folder_of(request).native()), request.row->name,
               request.row->name, are_drawn ? fmt::format(", and {}", request.row->plots) : "");
  study.refuse();
}

/// Measures all points that the study requests, or takes them from the table.
void measure_all(StudyCommand& request, std::vector<PointRequest> more, const Places& places) {
  Study& study = *request.study;
  Table table = table_of(request, places);
  const bool are_read = !table.rows().empty();
  std::vector<PointRequest> points;
  do {
    points.insert(points.end(), more.begin(), more.end());
    const std::set<std::string> changed = table.drop_stale(points, study.is_of_one_machine());
    if (places.folder) warn_stale_rows(places.file(request, ".csv"), changed);
    study.set_rows(complete(request, points, table), are_read);
    more = study.request_more_points();
  } while (!more.empty());
}

void add_shard(session::OptionList& command, std::optional<Shard>& shard) {
  command.read_option(
      "--shard",
      [&shard](const std::string& text) {
        try {
          shard = parse_shard(text);
        } catch (const InputError& error) {
          throw session::UsageError("--shard", error.what());
        }
      },
      "Measure only shard k of n of the points, such as 3/16, into FOLDER/shards; csgsim gather joins the shards");
}

void add_folder(const StudyRow& row, Folder kept, session::OptionList& command, std::string& folder) {
  std::string default_value;
  if (kept == Folder::usual) default_value = fmt::format("; default: MODEL-{}, of the first model", row.name);
  if (kept == Folder::optional) default_value = "; without a folder, results are not kept";
  command
      .option("-o,--output", folder,
              fmt::format("Folder for {}.csv, {}.json and the plots{}", row.name, row.name, default_value))
      .folder();
}

/// Adds the options that every study has.
std::shared_ptr<StudyCommand> describe_kept(session::OptionList& list, const StudyRow& row, Folder kept) {
  auto request = std::make_shared<StudyCommand>(StudyCommand{&row, row.make(), {}, list, kept});
  RunnerOptions& options = request->options;
  options.threads = std::max(1U, std::thread::hardware_concurrency());
  request->study->add_options(list);
  add_folder(row, kept, list, options.folder);
  if (row.is_parallel)
    list.option("--threads", options.threads, "Number of points to measure in parallel")
        .between(1U, session::max_threads);
  list.flag("--no-plots", options.no_plots, "Omit plots (drawn by gnuplot)");
  if (row.has_shards) add_shard(list, options.shard);
  options.report.add_to(list);
  session::add_progress_option(list, options.progress);
  return request;
}

}  // namespace

std::shared_ptr<StudyCommand> add_study_options(session::OptionList& list, const StudyRow& row) {
  return describe_kept(list, row, Folder::usual);
}

std::shared_ptr<StudyCommand> add_library_study_options(session::OptionList& list, const StudyRow& row) {
  std::shared_ptr<StudyCommand> request = describe_kept(list, row, Folder::optional);
  if (row.has_shards) list.remove("--shard");
  return request;
}

std::string run_study_to_json(StudyCommand& request) {
  std::vector<PointRequest> points = request.study->request_points();
  Places places(request, request.study->inputs());
  measure_all(request, std::move(points), places);
  std::string json = request.study->json(places.title);
  if (places.folder) write_file(places.file(request, ".json"), json);
  write_shown(request, places, json);
  request.study->refuse();
  return json;
}

void run_study(StudyCommand& request) {
  if (request.options.shard) return run_shard(request);
  std::vector<PointRequest> points = request.study->request_points();
  Places places(request, request.study->inputs());
  measure_all(request, std::move(points), places);
  show(request, places);
}

void show_merged_shards(StudyCommand& request, const MergedShards& gathered) {
  Places places(request, request.study->inputs());
  Table table = table_of(request, places);
  request.study->set_rows(table.put(gathered), true);
  show(request, places);
}

std::vector<std::string> insert_words(const std::vector<std::string>& command,
                                      const std::vector<std::string>& added_words) {
  std::vector<std::string> words = command;
  words.insert(words.begin() + 1, added_words.begin(), added_words.end());
  return words;
}

}  // namespace csgsim::studies
