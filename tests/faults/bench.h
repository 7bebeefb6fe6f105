#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/cli.h"
#include "tests/faults/child.h"

namespace csgsim::testing::faults {

/// A command of csgsim that writes files.
struct Command {
  std::string name;
  std::string words;                 ///< arguments, with OUT for the output folder and SOURCE for the source tree
  std::vector<std::string> outputs;  ///< files in OUT that exist before, each replaced as a whole
  std::string table;                 ///< a study's table in OUT that grows by whole lines, next to a title file
  std::size_t lines_before = 0;      ///< complete lines of the table before, followed by half a line; 0 for no table
  std::size_t most = 0;              ///< failing calls of each kind in a short run
};

/// Runs one command repeatedly in separate folders under conditions, and compares the results with an undisturbed run.
class Bench {
 public:
  /// Runs the command once without faults.
  explicit Bench(Command command);

  /// Restores all outputs to their state before the command.
  void reset() const;

  [[nodiscard]] ChildResult run(const Conditions& conditions = {}) const;

  /// Checks a failed run: exit code 1, one line that names a file, each output old or completely new, the table made of
  /// complete lines, no other files. Returns an empty text or a description of the fault.
  [[nodiscard]] std::string failure_mismatch(const ChildResult& result) const;

  /// The same check, except that the table may end in part of a line.
  [[nodiscard]] std::string failure_mismatch_except_table(const ChildResult& result) const;

  /// Checks that the command completed and left no other files; empty if so.
  [[nodiscard]] std::string success_mismatch(const ChildResult& result) const;

  /// Checks that the folder holds only outputs, old or completely new, and complete lines of the table; empty if so.
  [[nodiscard]] std::string files_mismatch() const;

  /// Number of outputs that have been replaced.
  [[nodiscard]] std::size_t replaced() const;

  /// Sizes in bytes of all files that the command writes, without the varying parts, so files may be longer.
  [[nodiscard]] std::vector<std::uint64_t> sizes() const;

  [[nodiscard]] const Command& command() const { return command_; }

  /// Path of the fault library's report.
  [[nodiscard]] std::string report() const { return folder_ / "report"; }

 private:
  [[nodiscard]] std::string out(const std::string& name) const { return (folder_ / "out/") + name; }
  [[nodiscard]] std::string message_mismatch(const ChildResult& result) const;
  [[nodiscard]] std::string outputs_mismatch() const;
  [[nodiscard]] std::string table_mismatch() const;
  [[nodiscard]] std::string left_behind() const;
  [[nodiscard]] std::string table_before() const;
  /// The title file next to the table.
  [[nodiscard]] std::string title() const;

  Command command_;
  cli::Folder folder_;
  std::map<std::string, std::string> wanted_;  ///< content of each output and the table, without varying parts
};

}  // namespace csgsim::testing::faults
