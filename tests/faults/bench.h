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
  std::string words;                 ///< OUT stands for the folder of its outputs, SOURCE for the source tree
  std::vector<std::string> outputs;  ///< in OUT, there before, each replaced as a whole
  std::string table;             ///< in OUT, if it is a study: grows by whole lines, beside a file that says of what
  std::size_t lines_before = 0;  ///< of the table that are there before, and half of the next one; 0 for no table
  std::size_t most = 0;          ///< places at which a call of each kind fails, where not everything is tried
};

/// One command in folders of its own, run under conditions again and again, and held against a run without any.
class Bench {
 public:
  /// Runs the command once, as it should be.
  explicit Bench(Command command);

  /// Puts all outputs as they were before the command.
  void reset() const;

  [[nodiscard]] Ended run(const Conditions& conditions = {}) const;

  /// Empty if the command failed as it must: exit code 1, one line that names a file, each output old or wholly new,
  /// the table of whole lines, nothing else left. Otherwise what is wrong.
  [[nodiscard]] std::string wrong_in_failure(const Ended& ended) const;

  /// The same, but the table may end in part of a line.
  [[nodiscard]] std::string wrong_in_failure_but_table(const Ended& ended) const;

  /// Empty if the command did all of its work, with nothing else left.
  [[nodiscard]] std::string wrong_in_success(const Ended& ended) const;

  /// Empty if nothing but outputs, old or wholly new, and whole lines of the table is there.
  [[nodiscard]] std::string wrong_in_files() const;

  /// Outputs that are not the old ones any more.
  [[nodiscard]] std::size_t replaced() const;

  /// Of all files that the command writes, bytes; what differs each time does not count, so they may be longer.
  [[nodiscard]] std::vector<std::uint64_t> sizes() const;

  [[nodiscard]] const Command& command() const { return command_; }

  /// A place for the fault library's report.
  [[nodiscard]] std::string report() const { return folder_ / "report"; }

 private:
  [[nodiscard]] std::string out(const std::string& name) const { return (folder_ / "out/") + name; }
  [[nodiscard]] std::string wrong_in_words(const Ended& ended) const;
  [[nodiscard]] std::string wrong_in_outputs() const;
  [[nodiscard]] std::string wrong_in_table() const;
  [[nodiscard]] std::string left_behind() const;
  [[nodiscard]] std::string table_before() const;
  /// The file beside the table.
  [[nodiscard]] std::string title() const;

  Command command_;
  cli::Folder folder_;
  std::map<std::string, std::string> wanted_;  ///< of each output and the table, without what differs each time
};

}  // namespace csgsim::testing::faults
