#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/memory.h"
#include "sim/app/numbers.h"
#include "sim/app/options.h"
#include "sim/app/paths.h"
#include "sim/app/studies/corpus_options.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/studies.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/studies/sweep_progress.h"
#include "sim/app/text_columns.h"
#include "sim/report/number_text.h"
#include "sim/study/parallel.h"
#include "sim/study/ranges.h"
#include "sim/study/table.h"

namespace csgsim::app {

namespace {

using study::CorpusRow;
using Rows = std::vector<CorpusRow>;
using Table = study::Table<CorpusRow>;

/// Measures jobs at the same time.
void measure_jobs(const CorpusOptions& options, const std::vector<const study::CorpusJob*>& jobs,
                  const std::function<void(CorpusRow)>& finished) {
  with_memory_for_threads(options.threads, "points", [&] {
    study::measure_each(
        jobs.size(), options.threads, [&](std::size_t i) { return study::measure(*jobs[i]); }, finished);
  });
}

/// Measures the points that the table has not, and returns all in their order: so they are in the file at the end,
/// before what it has of other points.
Rows complete(const CorpusOptions& options, const std::vector<study::CorpusJob>& jobs, Table& table) {
  std::vector<const study::CorpusJob*> missing;
  for (const study::CorpusJob& job : jobs) {
    if (table.find(job.wanted) == nullptr) missing.push_back(&job);
  }
  SweepProgress progress(jobs.size(), jobs.size() - missing.size(), shows_progress(options.progress), options.threads);
  measure_jobs(options, missing, [&](CorpusRow row) {
    table.add(std::move(row));
    progress.done();
  });
  Rows rows;
  for (const study::CorpusJob& job : jobs) rows.push_back(*table.find(job.wanted));
  Rows all = rows;
  for (const CorpusRow& row : table.rows()) {
    const bool is_asked =
        std::ranges::any_of(jobs, [&](const study::CorpusJob& job) { return job.wanted.point == row.point; });
    if (!is_asked) all.push_back(row);
  }
  table.replace(std::move(all));
  return rows;
}

using Lines = std::vector<std::vector<std::string>>;

std::vector<std::string> row_line(const CorpusRow& row) {
  const std::string name = "  " + row.point.machine;
  if (!row.drawn()) return {name, row.reason};
  return {name,
          grouped(row.clocks),
          grouped(row.render),
          grouped(row.classify),
          grouped(row.merge),
          grouped(row.shade),
          grouped(row.pixel_operations),
          std::to_string(row.used_bits),
          fmt::format("{:.4g}", row.frames_per_second),
          row.bound_by};
}

bool is_drawn(const CorpusRow& row) { return row.drawn(); }

void add_model(std::span<const CorpusRow> rows, Lines& lines) {
  const auto drawn = std::ranges::find_if(rows, is_drawn);
  if (drawn == rows.end()) {
    lines.push_back({told_of(rows.front().point.model, rows.front().reason)});
    return;
  }
  lines.push_back({fmt::format("{}: {}, {}, {}", drawn->point.model, counted(drawn->primitives, "primitive"),
                               counted(drawn->pieces, "piece"), counted(drawn->halfspaces, "half-space"))});
  for (const CorpusRow& row : rows) lines.push_back(row_line(row));
}

/// Rows of one model follow each other.
std::vector<std::span<const CorpusRow>> by_model(const Rows& rows) {
  std::vector<std::span<const CorpusRow>> models;
  for (auto begin = rows.begin(); begin != rows.end();) {
    const auto end =
        std::find_if(begin, rows.end(), [&](const CorpusRow& row) { return row.point.model != begin->point.model; });
    models.emplace_back(begin, end);
    begin = end;
  }
  return models;
}

void print_rows(const Rows& rows) {
  Lines lines{{"model and machine", "clocks", "render", "classify", "merge", "shade", "pixel operations", "bits",
               "frames/s", "bound by"}};
  for (const std::span<const CorpusRow> model : by_model(rows)) add_model(model, lines);
  fmt::print("{}", in_columns(lines, "<>>>>>>>><"));
}

std::vector<std::string> distribution_line(const study::CorpusColumn& column, const study::Distribution& one) {
  using report::number_text;
  return {std::string("  ") + column.heading,
          number_text(one.minimum),
          number_text(one.first_quartile),
          number_text(one.median),
          number_text(one.third_quartile),
          number_text(one.maximum),
          column.adds_up ? number_text(one.total) : ""};
}

void print_distributions(const Rows& rows) {
  for (const std::string& machine : study::machines_of(rows)) {
    const auto of_machine = [&](const CorpusRow& row) { return row.point.machine == machine; };
    const auto models = std::ranges::count_if(rows, of_machine);
    const auto drawn =
        std::ranges::count_if(rows, [&](const CorpusRow& row) { return of_machine(row) && row.drawn(); });
    fmt::print("\n{}: {} of {} models\n", machine, drawn, models);
    if (drawn == 0) continue;
    Lines lines{{"", "minimum", "quartile", "median", "quartile", "maximum", "total"}};
    for (const study::CorpusColumn& column : study::corpus_columns())
      lines.push_back(distribution_line(column, study::distribution_of(rows, machine, column)));
    fmt::print("{}", in_columns(lines, "<>>>>>>"));
  }
}

/// Models that no machine draws.
void refuse_failures(const Rows& rows) {
  std::vector<std::string> failed;
  const auto models = by_model(rows);
  for (const std::span<const CorpusRow> model : models) {
    if (std::ranges::none_of(model, is_drawn)) failed.push_back(model.front().point.model);
  }
  if (!failed.empty()) throw InputError(failed_models(failed, models.size(), "corpus.csv"));
}

report::Page page_of(const CorpusOptions& options, const Rows& rows, const std::string& points) {
  ModelOptions model = options.view;
  std::vector<machines::Machine> machines;
  for (const std::string& name : study::parse_words(options.machines)) {
    model.machine = name;
    machines.push_back(machine_of(model));
  }
  report::StudyContext context = plain_study_context(options.report, rows.front().point.model, machines);
  const std::size_t models = by_model(rows).size();
  if (models > 1) context.model = counted(models, "model");
  return report::corpus_page(report::Json::parse(points), study::plots_of_corpus(rows), context);
}

std::vector<study::WantedCorpusPoint> wanted_of(const std::vector<study::CorpusJob>& jobs) {
  std::vector<study::WantedCorpusPoint> wanted;
  wanted.reserve(jobs.size());
  for (const study::CorpusJob& job : jobs) wanted.push_back(job.wanted);
  return wanted;
}

void run_shard(const CorpusOptions& options, const Command& command) {
  const std::vector<study::CorpusJob> jobs = corpus_jobs(options);
  measure_shard<CorpusRow>(command, options.folder, *options.shard, wanted_of(jobs), options.progress,
                           [&](const std::vector<std::size_t>& points, const auto& finished) {
                             std::vector<const study::CorpusJob*> missing;
                             missing.reserve(points.size());
                             for (const std::size_t i : points) missing.push_back(&jobs[i]);
                             measure_jobs(options, missing, finished);
                           });
}

/// Rows that the table has or gets.
Rows rows_of(const CorpusOptions& options, const std::filesystem::path& table_path, Table& table) {
  const std::vector<study::CorpusJob> jobs = corpus_jobs(options);
  tell_stale(table_path, table.drop_stale(std::span<const study::WantedCorpusPoint>(wanted_of(jobs))));
  return complete(options, jobs, table);
}

void run(const CorpusOptions& options, const Command& command, const study::Gathered* gathered) {
  if (options.shard) return run_shard(options, command);
  const std::vector<std::filesystem::path> inputs =
      input_files(corpus_files(options.models), study::parse_words(options.machines));
  const StudyFolder folder(options.folder, "corpus", inputs);
  ReportFile report(options.report, inputs);
  const std::string title = study_title(command, {"machines"});
  const std::filesystem::path table_path = folder.path() / "corpus.csv";
  Table table(table_path, title);
  const Rows rows = gathered != nullptr ? put_rows(*gathered, table_path, table) : rows_of(options, table_path, table);
  const std::string points = study::corpus_json(title, rows);
  write_file(folder.path() / "corpus.json", points);
  print_rows(rows);
  print_distributions(rows);
  const bool has_plots = !options.no_plots && !study::draw_corpus(rows, folder.path()).empty();
  if (report.asked()) report.write(page_of(options, rows, points));
  fmt::print("\n{}: corpus.csv, corpus.json{}\n", printable(options.folder),
             has_plots ? ", and plots (.png, .svg) of clocks and frames a second" : "");
  refuse_failures(rows);
}

void add(CommandLine& line, const study::Gathered* gathered) {
  const auto options = std::make_shared<CorpusOptions>();
  Command command = line.add(
      "corpus", "Count what many models take on many machines: totals, distributions, plots",
      "Example:\n  csgsim corpus parts -o parts-corpus\n"
      "  csgsim corpus a.csg b.scad parts --machines pixel-planes-4,mine.toml --size 256x256 -o out\n"
      "A model that cannot be read, or that a machine does not draw, is a row that says why; the exit code is 1 if no\n"
      "machine draws some model. What has been measured is in corpus.csv at once; the same command goes on after an\n"
      "interruption, and with other models or machines measures what is new.");
  options->add_to(command);
  command.prints_summary();
  command.runs([options, command, gathered] { run(*options, command, gathered); });
}

}  // namespace

void add_corpus(CommandLine& line) { add(line, nullptr); }
void gather_corpus(CommandLine& line, const study::Gathered& gathered) { add(line, &gathered); }

}  // namespace csgsim::app
