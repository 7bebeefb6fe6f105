// Files of a study's table, as an interrupted study leaves them or somebody has changed them.

#include "sim/study/table.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "sim/study/comparison.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace study = csgsim::study;

namespace {

/// In memory where there is such a folder: on a disk, files written anew so often are waited for.
std::filesystem::path scratch_folder() {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  return std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path();
}

/// A file of this process alone.
class ScratchFile {
 public:
  ScratchFile() : path_(scratch_folder() / ("csgsim_fuzz_" + std::to_string(::getpid()) + ".csv")) {}
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  void write(std::string_view text) const {
    std::ofstream file(path_, std::ios::binary | std::ios::trunc);
    file << text << std::flush;
    if (!file) fuzz::broken("the scratch file can be written");
  }

 private:
  std::filesystem::path path_;
};

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  const study::Table<study::ComparisonRow> table(path, "title");
  std::vector<std::string> lines;
  for (const study::ComparisonRow& row : table.rows()) lines.push_back(study::to_line(row));
  return lines;
}

/// What was read is still there when the file is opened again, and a row can be added.
void check(const std::filesystem::path& path, std::vector<std::string> lines) {
  try {
    fuzz::require(lines_of(path) == lines, "a table opened again holds the same rows");
    study::ComparisonRow row;
    row.reason = "commas, \"quotes\"";
    study::Table<study::ComparisonRow>(path, "title").add(row);
    lines.push_back(study::to_line(row));
    fuzz::require(lines_of(path) == lines, "a row that was added follows those that were there");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

}  // namespace

/// Any file is either a table that can go on or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile file;
  file.write(fuzz::text_of(data, size));
  try {
    check(file.path(), lines_of(file.path()));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, file.path().native());
  }
  return 0;
}
