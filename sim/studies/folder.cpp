#include "sim/studies/folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/folder.h"
#include "hw/base/messages.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/usage.h"
#include "sim/studies/plot_names.h"

namespace csgsim::studies {

namespace {

/// Extensions of the files that studies write.
constexpr auto written_endings = std::to_array<std::string_view>({".csv", ".study", ".json", ".png", ".svg"});

std::filesystem::path create_output_folder(const std::filesystem::path& folder) {
  if (folder.empty()) throw session::UsageError("--output", "the name is empty; specify a folder");
  if (is_standard_output(folder))
    throw session::UsageError("--output", "the study writes several files; specify a folder");
  make_folder(folder);
  return folder;
}

/// Files in the folder whose names a study may use for output.
std::vector<std::filesystem::path> find_study_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const bool is_written = std::any_of(written_endings.begin(), written_endings.end(), [&](std::string_view ending) {
      return session::has_extension(entry->path(), ending);
    });
    if (is_written) files.push_back(entry->path());
  }
  if (error) throw InputError(folder.native() + ": cannot be read (" + error.message() + ")");
  return files;
}

/// Rejects files that a study must not write to: a link would redirect the output, a pipe or device would block.
void refuse_special_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(file, error);
  if (std::filesystem::is_regular_file(status) || std::filesystem::is_directory(status) ||
      !std::filesystem::exists(status))
    return;
  throw InputError(
      fmt::format("{} is {}; a study may write a file with this name: delete it, or choose another folder with -o",
                  file.native(), std::filesystem::is_symlink(status) ? "a link" : "a pipe or a device"));
}

}  // namespace

StudyFolder::StudyFolder(const std::filesystem::path& folder, const std::string& study,
                         std::span<const std::filesystem::path> inputs)
    : path_(create_output_folder(folder)), lock_(path_, study) {
  for (const std::filesystem::path& file : find_study_files(path_)) {
    session::refuse_clashes(inputs, std::span(&file, 1));
    refuse_special_file(file);
  }
}

std::filesystem::path default_output_folder(const std::filesystem::path& model, std::string_view study) {
  if (model == standard_stream) return fmt::format("model-{}", study);
  std::error_code error;
  std::filesystem::path named = std::filesystem::absolute(model, error).lexically_normal();
  if (!named.has_filename()) named = named.parent_path();
  return fmt::format("{}-{}", plot_stem(named), study);
}

std::string study_title(const session::OptionList& command, const std::set<std::string>& excluded_options) {
  std::string title = "csgsim " + command.name();
  for (const session::GivenOption& option : command.given()) {
    const bool has_effect = std::ranges::find(options_without_effect, option.name) == options_without_effect.end();
    if (!has_effect || option.is_default || excluded_options.contains(option.name)) continue;
    title += fmt::format(" --{} {}", option.name, escaped(option.value));
  }
  return title;
}

std::string with_model_name(const std::string& model, const std::string& reason) {
  return reason.starts_with(model) ? reason : model + ": " + reason;
}

std::string failed_models_message(std::span<const std::string> failed, std::size_t model_count,
                                  const std::string& table_name) {
  constexpr std::size_t max_named = 5;
  const std::span<const std::string> named = failed.first(std::min(failed.size(), max_named));
  return fmt::format("{} of {} models could not be drawn: {}{}; see {} for the reasons", failed.size(), model_count,
                     fmt::join(named, ", "), named.size() < failed.size() ? " and others" : "", table_name);
}

void throw_inconsistent_results(const std::string& fault, bool has_read_rows) {
  if (!has_read_rows) throw std::logic_error(fault);
  throw InputError(fault +
                   "; rows read from the table may have been changed: measure everything again in another folder "
                   "(-o), and if the error remains, report it");
}

void warn_stale_rows(const std::filesystem::path& table, const std::set<std::string>& changed_inputs) {
  if (changed_inputs.empty()) return;
  report_line(fmt::format("{}: {} {} changed since some points were measured; they are measured again", table.native(),
                          fmt::join(changed_inputs, " and "), changed_inputs.size() == 1 ? "has" : "have"));
}

}  // namespace csgsim::studies
