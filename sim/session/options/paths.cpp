#include "sim/session/options/paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>

#include "hw/base/file_roles.h"
#include "hw/base/output_file.h"
#include "hw/base/standard_streams.h"
#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "sim/observe/pictures.h"
#include "sim/pictures/encode.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

bool has_extension(const std::filesystem::path& path, std::string_view extension) {
  return std::ranges::equal(path.extension().string(), extension,
                            [](unsigned char letter, unsigned char wanted) { return std::tolower(letter) == wanted; });
}

std::vector<std::filesystem::path> input_files(const std::vector<std::string>& subjects,
                                               const std::vector<std::string>& machines) {
  std::vector<std::filesystem::path> files(subjects.begin(), subjects.end());
  for (const std::string& machine : machines)
    if (const std::string_view file = kinds::file_of(machine); !file.empty()) files.emplace_back(file);
  return files;
}

void refuse_clashes(std::span<const std::filesystem::path> inputs, std::span<const std::filesystem::path> outputs) {
  std::vector<std::filesystem::path> named;
  std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(named),
               [](const std::filesystem::path& path) { return !path.empty(); });
  const std::optional<Clash> clash = find_clash(inputs, named);
  if (!clash) return;
  throw UsageError(
      clash->output.native(),
      is_standard_output(clash->output) ? "two outputs cannot both go to standard output; name a file for one"
      : clash->is_input ? fmt::format("it is the same file as the input {}; name another output", clash->other.native())
                        : "two outputs cannot be the same file; name another one");
}

bool is_unnamed_stream(const std::filesystem::path& path) {
  return !path.empty() && !path.has_extension() && is_stream(path);
}

std::string shown_name(const std::string& path) { return path == standard_stream ? "standard input" : path; }

void refuse_unknown_format(const std::string& option, const std::filesystem::path& picture) {
  if (picture.empty()) return;
  try {
    observe::check_format(picture);
  } catch (const pictures::FormatError& error) {
    throw UsageError(option, error.what());
  }
}

void refuse_terminal(const std::string& option, const std::filesystem::path& path) {
  if (path.empty() || !is_terminal(path)) return;
  throw UsageError(option, "a terminal cannot show binary data; name a file, or pipe the output to a program");
}

}  // namespace csgsim::session
