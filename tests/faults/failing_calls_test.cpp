/// Fails the n-th write, fsync, rename, ... of a command, one at a time, through a preloaded library.

#include "hw/base/address_sanitizer.h"
#include "tests/faults/commands.h"
#include "tests/support/test.h"

namespace {

using namespace csgsim::testing::faults;

enum class Ends { in_failure, in_failure_but_table, in_success };

/// A kind of call and the error that it returns.
struct Trial {
  const char* kind;
  const char* error;
  Ends ends;
};

/// Up to the command's `most`, every n is tried; beyond it, the first, the last and some between.
constexpr Trial trials[] = {
    {"write", "ENOSPC", Ends::in_failure}, {"fsync", "EIO", Ends::in_failure},
    {"rename", "EIO", Ends::in_failure},   {"open", "EMFILE", Ends::in_failure},
    {"mkdir", "ENOSPC", Ends::in_failure}, {"mkfifo", "ENOSPC", Ends::in_failure},
};

/// Errors handled by the same code for every n: one n is enough.
constexpr Trial single_trials[] = {{"write", "SHORT", Ends::in_failure}, {"close", "EIO", Ends::in_failure}};

/// Errors tried only in the full run (./setup.sh faults), at up to eight calls each.
constexpr Trial more_trials[] = {
    {"write", "EDQUOT", Ends::in_failure},  {"write", "EIO", Ends::in_failure},
    {"write", "HALF", Ends::in_success},    {"write", "EINTR", Ends::in_success},
    {"fsync", "ENOSPC", Ends::in_failure},  {"fsync", "EDQUOT", Ends::in_failure},
    {"fsync", "EINTR", Ends::in_success},   {"rename", "ENOSPC", Ends::in_failure},
    {"rename", "EACCES", Ends::in_failure}, {"open", "ENOSPC", Ends::in_failure},
    {"open", "EROFS", Ends::in_failure},    {"close", "EDQUOT", Ends::in_failure},
    {"close", "EINTR", Ends::in_success},   {"memfd_create", "EMFILE", Ends::in_failure},
};

bool is_full_run() { return std::getenv("CSGSIM_FAULTS") != nullptr; }

Conditions with_fault(const Bench& bench, const std::string& fault) {
  Conditions conditions;
  conditions.environment = {{"LD_PRELOAD", CSGSIM_FAULT_LIBRARY}, {"CSGSIM_FAULT_REPORT", bench.report()}};
  if (!fault.empty()) conditions.environment["CSGSIM_FAULT"] = fault;
#if CSGSIM_ADDRESS_SANITIZER
  conditions.environment["ASAN_OPTIONS"] = "verify_asan_link_order=0:detect_leaks=0:quarantine_size_mb=16";
#endif
  return conditions;
}

using Counts = std::map<std::string, std::size_t>;

/// Number of calls of each kind that the command makes.
Counts count_calls(const Bench& bench) {
  bench.reset();
  const ChildResult ended = bench.run(with_fault(bench, ""));
  REQUIRE(bench.success_mismatch(ended) == "");
  Counts counts;
  std::ifstream report(bench.report());
  std::string word;
  std::string kind;
  for (std::size_t count = 0; report >> word >> kind >> count;) counts[kind] = count;
  REQUIRE(counts["write"] > 0);
  return counts;
}

/// The numbers 1 to `count` if these are at most `most`; else the first `most` / 2, and up to `most` - `most` / 2
/// evenly spaced ones that include the last. Empty if `most` is 0.
std::vector<std::size_t> some_of(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (most == 0) return chosen;
  for (std::size_t n = 1; n <= count; ++n) {
    const bool is_first = n <= most / 2;
    const bool is_step = n * (most - most / 2) / count != (n - 1) * (most - most / 2) / count;
    if (count <= most || is_first || is_step) chosen.push_back(n);
  }
  return chosen;
}

std::string wrong_in(const Bench& bench, const ChildResult& ended, Ends ends) {
  switch (ends) {
    case Ends::in_failure: return bench.failure_mismatch(ended);
    case Ends::in_failure_but_table: return bench.failure_mismatch_except_table(ended);
    case Ends::in_success: return bench.success_mismatch(ended);
  }
  return "no end";
}

/// The library's report about the first call that failed.
struct Failed {
  std::string word;
  std::string kind;
  std::size_t number = 0;
  std::string after;
  std::size_t renames = 0;
};

/// Checks that no file is renamed into place before it is complete and synced, and, except in studies, not before all
/// files are.
std::string wrong_in_order(const Bench& bench) {
  Failed failed;
  std::ifstream(bench.report()) >> failed.word >> failed.kind >> failed.number >> failed.after >> failed.renames;
  if (failed.word != "failed") return "the report has no failed call";
  if (bench.replaced() > failed.renames) return "a file was renamed into place before the call that failed";
  const bool makes_files = failed.kind == "write" || failed.kind == "open" || failed.kind == "close";
  const bool syncs_files = failed.kind == "fsync" && failed.number <= bench.command().outputs.size();
  const bool is_late = bench.command().table.empty() && (makes_files || syncs_files) && failed.renames > 0;
  return is_late ? "files are still made when others are in their places" : "";
}

/// Describes the fault after a failing run; a study must also continue from the remains to its normal result.
std::string wrong_after(const Bench& bench, const std::string& fault, Ends ends, bool goes_on) {
  bench.reset();
  const ChildResult ended = bench.run(with_fault(bench, fault));
  std::string wrong = wrong_in(bench, ended, ends);
  if (wrong.empty() && ends != Ends::in_success) wrong = wrong_in_order(bench);
  if (wrong.empty() && !csgsim::testing::cli::content(bench.report()).starts_with("failed "))
    wrong = "the report has no failed call";
  if (!wrong.empty() || !goes_on) return wrong;
  const std::string wrong_then = bench.success_mismatch(bench.run());
  return wrong_then.empty() ? "" : "when it goes on: " + wrong_then;
}

void print_row(const Bench& bench, const Trial& trial, std::size_t calls, std::size_t runs, std::size_t clean) {
  static bool has_heading = false;
  if (!std::exchange(has_heading, true))
    std::printf("%-26s%-14s%-8s%8s%8s%8s\n", "command", "failing call", "error", "calls", "runs", "clean");
  std::printf("%-26s%-14s%-8s%8zu%8zu%8zu\n", bench.command().name.c_str(), trial.kind, trial.error, calls, runs,
              clean);
  std::fflush(stdout);
}

void try_calls(const Bench& bench, const Trial& trial, std::size_t calls, std::size_t most) {
  std::size_t runs = 0;
  std::size_t clean = 0;
  const std::vector<std::size_t> chosen = some_of(calls, most);
  for (const std::size_t n : chosen) {
    const std::string fault = std::string(trial.kind) + ":" + std::to_string(n) + ":" + trial.error;
    const bool is_study = !bench.command().table.empty() && trial.ends != Ends::in_success;
    const bool goes_on = is_study && (is_full_run() || n == chosen[chosen.size() / 2]);
    CAPTURE(fault);
    const std::string wrong = wrong_after(bench, fault, trial.ends, goes_on);
    CHECK(wrong == "");
    ++runs;
    if (wrong.empty()) ++clean;
  }
  if (is_full_run() && runs > 0) print_row(bench, trial, calls, runs, clean);
}

/// Number of calls of each kind to try in a short run.
std::size_t usual_most(const Bench& bench) {
  const std::size_t most = bench.command().most;
  return csgsim::testing::cases(most, std::min<std::size_t>(most, 2));
}

/// Runs all trials of a command; a `most` of 0 restricts it to the full run (./setup.sh faults).
void try_command(const std::string& name) {
  if (command(name).most == 0 && !is_full_run()) return;
  CAPTURE(name);
  const Bench bench(command(name));
  Counts counts = count_calls(bench);
  for (const Trial& trial : trials) {
    const std::size_t calls = counts[trial.kind];
    try_calls(bench, trial, calls, is_full_run() ? calls : usual_most(bench));
  }
  for (const Trial& trial : single_trials) try_calls(bench, trial, counts[trial.kind], is_full_run() ? 8 : 1);
  if (!is_full_run()) return;
  for (const Trial& trial : more_trials) try_calls(bench, trial, counts[trial.kind], 8);
}

}  // namespace

TEST_CASE("render leaves old or complete new files after any failing call") { try_command("render"); }

TEST_CASE("render to standard output leaves no temporary files after any failing call") {
  try_command("render to standard output");
}

TEST_CASE("compile leaves the old or the complete new file after any failing call") { try_command("compile"); }

TEST_CASE("run leaves old or complete new files after any failing call") { try_command("run"); }

TEST_CASE("disasm leaves the old or the complete new file after any failing call") { try_command("disasm"); }

TEST_CASE("convert leaves old or complete new files after any failing call") { try_command("convert"); }

TEST_CASE("explain leaves the old or the complete new file after any failing call") { try_command("explain"); }

TEST_CASE("wave leaves old or complete new files after any failing call") { try_command("wave"); }

TEST_CASE("subdivide leaves the old or the complete new file after any failing call") { try_command("subdivide"); }

TEST_CASE("explore leaves the old or the complete new file after any failing call") { try_command("explore"); }

TEST_CASE("accuracy leaves complete lines after any failing call and resumes from them") {
  try_command("accuracy");
  try_command("accuracy going on");
}

TEST_CASE("advise leaves complete lines after any failing call and resumes from them") {
  try_command("advise");
  try_command("advise going on");
}

TEST_CASE("sweep leaves complete lines after any failing call and resumes from them") {
  try_command("sweep");
  try_command("sweep going on");
}

TEST_CASE("compare leaves complete lines after any failing call and resumes from them") {
  try_command("compare");
  try_command("compare going on");
}

TEST_CASE("a study's plots are old or completely new after any failing call") {
  try_command("sweep with plots");
  try_command("advise with plot");
  try_command("compare with plots");
}

TEST_CASE("a study resumes even if its table can neither be written nor truncated") {
  const Bench bench(command("sweep"));
  const Counts counts = count_calls(bench);
  for (std::size_t n = 2; n <= 4; ++n) {
    const std::string fault = "write:" + std::to_string(n) + ":SHORT,ftruncate:1:EIO";
    CAPTURE(fault);
    CHECK(wrong_after(bench, fault, Ends::in_failure_but_table, true) == "");
  }
}

TEST_CASE("partial or interrupted writes and interrupted syncs cause no error") {
  for (const char* const name : {"render", "wave", "sweep"}) {
    CAPTURE(name);
    const Bench bench(command(name));
    CHECK(wrong_after(bench, "write:1:HALF,write:3:EINTR,fsync:1:EINTR", Ends::in_success, false) == "");
  }
}

TEST_CASE("a full disk is reported once even if later calls fail as well") {
  for (const char* const name : {"render", "wave", "sweep"}) {
    const Bench bench(command(name));
    for (const char* const fault : {"write:1+:ENOSPC", "fsync:1+:EIO", "rename:1+:ENOSPC"}) {
      CAPTURE(name);
      CAPTURE(fault);
      CHECK(wrong_after(bench, fault, Ends::in_failure, false) == "");
    }
  }
}
