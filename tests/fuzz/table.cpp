// Files of a study's table after an interruption or an edit.

#include "sim/studies/table.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/compare/measure.h"
#include "tests/fuzz/property.h"
#include "tests/fuzz/scratch_file.h"

namespace fuzz = csgsim::fuzz;
namespace studies = csgsim::studies;

namespace {

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  return studies::Table(path, "title", studies::row_format<studies::ComparisonRow>()).rows();
}

/// Checks that the rows are unchanged when the file is opened again, and that a row can be added.
void check(const std::filesystem::path& path, std::vector<std::string> lines) {
  try {
    fuzz::require(lines_of(path) == lines, "a table opened again holds the same rows");
    studies::ComparisonRow row;
    row.reason = "commas, \"quotes\"";
    lines.push_back(studies::to_line(row));
    studies::Table(path, "title", studies::row_format<studies::ComparisonRow>()).add(std::span(lines).last(1));
    fuzz::require(lines_of(path) == lines, "an added row follows the existing ones");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

}  // namespace

/// Any file gives a table that can be continued, or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  static const std::filesystem::path file = folder.path() / "compare.csv";
  fuzz::write_scratch(file, fuzz::text_of(data, size));
  // Tables of csgsim 0.1.0 from before December 2026 state their study in a comment.
  fuzz::write_scratch(std::filesystem::path(file).replace_extension(".study"), "title\n");
  try {
    check(file, lines_of(file));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, file.native());
  }
  return 0;
}
