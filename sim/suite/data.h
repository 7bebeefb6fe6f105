// The files of the benchmark suite.
// Used by sim/app.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "sim/suite/results.h"
#include "sim/suite/suite.h"

namespace csgsim::suite {

/// A folder with suite.toml, expected.csv, programs/, pictures/ and models/.
class Data {
 public:
  /// `folder` may be empty: the folder is then that of the build tree or of the installation to which the running
  /// program belongs. Throws InputError if it has no suite.toml, or as read_suite() and read_results() do.
  explicit Data(const std::filesystem::path& folder);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const Suite& suite() const { return suite_; }
  [[nodiscard]] const std::vector<Row>& expected() const { return expected_; }

  [[nodiscard]] std::filesystem::path program_file(const Case& one) const;
  [[nodiscard]] std::filesystem::path picture_file(const Case& one) const;
  [[nodiscard]] std::filesystem::path model_file(const Case& one) const;

  /// Whether the machine, given as for --machine, runs the stored Programs: its kind is that of a machine in
  /// Suite::stored. Throws InputError for an unknown machine.
  [[nodiscard]] bool runs_stored(const std::string& machine) const;

 private:
  std::filesystem::path folder_;
  Suite suite_;
  std::vector<Row> expected_;
};

/// Reads a table of results. Throws InputError.
std::vector<Row> read_results_file(const std::filesystem::path& path);

/// The bytes of a file of the suite. Throws InputError.
std::string read_suite_file(const std::filesystem::path& path);

}  // namespace csgsim::suite
