#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/output_file.h"
#include "hw/base/output_folder.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/run_request.h"
#include "sim/suite/compare.h"
#include "sim/suite/data.h"
#include "sim/suite/program_text.h"
#include "sim/suite/run.h"

namespace csgsim::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> cases;
  std::string machines;
  std::string level = "functional";
  bool lists = false;
  bool compiles = false;
  std::string output;
  std::string results;
  std::string compared;
  std::string suite;
  std::string progress = "auto";
};

std::vector<const suite::Case*> chosen_cases(const Options& options, const suite::Suite& suite) {
  std::vector<const suite::Case*> chosen;
  for (const std::string& name : options.cases) chosen.push_back(&suite::case_named(suite, name));
  if (chosen.empty())
    for (const suite::Case& one : suite.cases) chosen.push_back(&one);
  return chosen;
}

std::vector<std::string> chosen_machines(const Options& options, const suite::Suite& suite) {
  if (!options.machines.empty()) return parse_words(options.machines);
  std::vector<std::string> all = suite.stored;
  all.insert(all.end(), suite.compiled.begin(), suite.compiled.end());
  return all;
}

std::vector<suite::Job> chosen_jobs(const Options& options, const suite::Suite& suite) {
  std::vector<suite::Job> jobs;
  for (const suite::Case* const one : chosen_cases(options, suite))
    for (const std::string& machine : chosen_machines(options, suite))
      jobs.push_back({one, machine, options.level, options.compiles});
  return jobs;
}

void list_cases(const Options& options, const suite::Suite& suite) {
  fmt::print("suite {}: {}\n{:<20}{:<10}{:<9}{:<13}{}\n", suite.version, count_text(suite.cases.size(), "case"), "case",
             "group", "size", "projection", "model");
  for (const suite::Case* const one : chosen_cases(options, suite))
    fmt::print("{:<20}{:<10}{:<9}{:<13}{}\n", one->name, one->group, one->settings[0].second, one->settings[2].second,
               printable(one->about));
}

/// Writes the suite for another simulator: the list, the expected values, pictures, models, and one Program per case
/// and machine, but only one per case for all machines that run the stored Program.
void write_suite(const Options& options, const suite::Data& data) {
  OutputFolder folder(options.output);
  for (const char* const name : {"suite.toml", "expected.csv"})
    folder.write(name, suite::read_suite_file(data.folder() / name));
  std::size_t programs = 0;
  std::string last_stored;  // the case whose stored Program has been written
  for (const suite::Job& job : chosen_jobs(options, data.suite())) {
    const bool is_stored = data.runs_stored(job.machine);
    if (is_stored && last_stored == job.one->name) continue;
    if (is_stored) last_stored = job.one->name;
    const std::string name = is_stored ? job.one->name : job.one->name + "." + job.machine;
    folder.write(fs::path("programs") / (name + ".txt"), suite::text_of(suite::prepare(data, job).program));
    ++programs;
  }
  const std::vector<const suite::Case*> cases = chosen_cases(options, data.suite());
  for (const suite::Case* const one : cases) {
    folder.write(fs::path("models") / data.model_file(*one).filename(), suite::read_suite_file(data.model_file(*one)));
    // A case that is being added has no picture yet.
    const fs::path picture = data.picture_file(*one);
    if (fs::exists(picture)) folder.write(fs::path("pictures") / picture.filename(), suite::read_suite_file(picture));
  }
  folder.commit();
  fmt::print("{}: suite {}, {}, {}\n", printable(options.output), data.suite().version,
             count_text(cases.size(), "case"), count_text(programs, "Program"));
}

/// Counts of a comparison of several rows.
struct Totals {
  std::size_t rows = 0;
  std::size_t values = 0;
  std::size_t differences = 0;
  std::size_t other_rows = 0;  ///< rows with a difference
};

constexpr std::size_t shown_differences = 5;

void print_header() {
  fmt::print("{:<20}{:<28}{:>15}{:>10}  {}\n", "case", "machine", "clocks", "seconds", "compared with the suite");
}

/// Prints a line about the row, and one per difference.
void print_row(const suite::Row& row, const suite::Comparison& comparison, Totals& totals) {
  const std::size_t count = comparison.differences.size();
  std::string verdict = fmt::format("{} equal", count_text(comparison.values, "value"));
  if (comparison.values == 0) verdict = "no expected values";
  if (count > 0) verdict = fmt::format("differing values: {} of {}", count, comparison.values);
  fmt::print("{:<20}{:<28}{:>15}{:>10}  {}\n", printable(row.name()), printable(row.machine()), row.at("clocks"),
             row.at("seconds"), verdict);
  for (std::size_t i = 0; i < count && i < shown_differences; ++i) {
    const suite::Difference& one = comparison.differences[i];
    fmt::print("    {}: expected {}, found {}\n", one.column, one.expected, one.found);
  }
  if (count > shown_differences) fmt::print("    and {} more\n", count - shown_differences);
  ++totals.rows;
  totals.values += comparison.values;
  totals.differences += count;
  totals.other_rows += count > 0 ? 1 : 0;
}

/// Prints the last line. Throws InputError if anything differs.
void print_totals(const suite::Suite& suite, const Totals& totals) {
  const std::string runs = fmt::format("suite {}: {} of cases", suite.version, count_text(totals.rows, "run"));
  if (totals.differences == 0)
    return fmt::print("{}, {} compared, none differs\n", runs, count_text(totals.values, "value"));
  std::fflush(stdout);
  throw InputError(fmt::format("{}: differing values: {} of {}, in {}", runs, totals.differences, totals.values,
                               count_text(totals.other_rows, "run")));
}

void run_suite(const Options& options, const suite::Data& data) {
  std::unique_ptr<OutputFile> file;
  if (!options.results.empty()) file = std::make_unique<OutputFile>(options.results);
  const std::vector<suite::Job> jobs = chosen_jobs(options, data.suite());
  const bool is_apart = options.level == "cycle" && jobs.size() > 1;
  const bool shows = shows_progress(options.progress);
  std::vector<suite::Row> rows;
  Totals totals;
  print_header();
  for (const suite::Job& job : jobs) {
    std::fflush(stdout);
    if (shows)
      write_message(fmt::format("\r{} of {}: {} on {}\x1b[K\r", rows.size() + 1, jobs.size(), job.one->name,
                                printable(job.machine)));
    rows.push_back(is_apart ? suite::measure_apart(data, job) : suite::measure(suite::prepare(data, job), job, false));
    print_row(rows.back(), suite::compare(data.expected(), rows.back()), totals);
  }
  if (file) {
    file->write(suite::results_text(rows));
    file->commit();
  }
  print_totals(data.suite(), totals);
}

/// Compares the results of another simulator. Only the chosen cases and machines count.
void compare_results(const Options& options, const suite::Data& data) {
  const std::vector<std::string> cases = options.cases.empty() ? suite::case_names(data.suite()) : options.cases;
  const std::vector<std::string> machines =
      options.machines.empty() ? std::vector<std::string>{} : parse_words(options.machines);
  const auto is_chosen = [](const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::ranges::find(names, name) != names.end();
  };
  const std::vector<suite::Row> rows = suite::read_results_file(options.compared);
  for (const suite::Row& row : rows) suite::case_named(data.suite(), row.name());
  Totals totals;
  print_header();
  for (const suite::Row& row : rows) {
    if (is_chosen(cases, row.name()) && is_chosen(machines, row.machine()))
      print_row(row, suite::compare(data.expected(), row), totals);
  }
  print_totals(data.suite(), totals);
}

void bench_suite(const Options& options) {
  const int tasks = (options.lists ? 1 : 0) + (options.output.empty() ? 0 : 1) + (options.compared.empty() ? 0 : 1);
  if (tasks > 1 || (tasks == 1 && !options.results.empty()))
    throw UsageError("give only one of --list, --output, --compare and --results");
  const suite::Data data(options.suite);
  for (const std::string& name : options.cases) suite::case_named(data.suite(), name);
  if (options.lists) return list_cases(options, data.suite());
  if (!options.compared.empty()) return compare_results(options, data);
  if (!options.output.empty()) return write_suite(options, data);
  run_suite(options, data);
}

void add_bench_suite(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "bench-suite", study_group, "Run the benchmark suite and compare its pictures and counts with the expected ones",
      "Example:\n  csgsim bench-suite carburettor grid --machines pixel-planes-4,simdram-ddr4\n"
      "  csgsim bench-suite -o suite     # the suite's files, for another simulator\n"
      "  csgsim bench-suite --compare theirs.csv\n"
      "The exit code is 1 if a value differs. docs/benchmark.md describes the suite and the table of results.");
  command.option("CASE", options->cases, "Cases to run; default: all");
  command.option("--machines", options->machines, "Comma-separated machines; default: all of the suite")
      .check(check_by_parsing(check_machines));
  command.option("--level", options->level, "Level of the runs; at the cycle level each has its own process")
      .one_of(level_names(), "level");
  command.flag("--list", options->lists, "Only list the cases");
  command.flag("--compile", options->compiles,
               "Compile all Programs from the models, instead of using the stored ones");
  command.option("-o,--output", options->output, "Run nothing; write Programs, pictures and counts into this folder")
      .folder();
  command.option("--results", options->results, "Also write the results as a table, .csv").check(not_empty);
  command.option("--compare", options->compared, "Run nothing; compare the results in this table, .csv")
      .check(not_empty);
  command.option("--suite", options->suite, "The suite's folder; default: the one that belongs to csgsim").folder();
  add_progress(command, options->progress);
  command.add_quiet_option();
  command.set_action([options] { bench_suite(*options); });
}

}  // namespace

extern const CommandRow bench_suite_row{.name = "bench-suite", .add = add_bench_suite};

}  // namespace csgsim::app
