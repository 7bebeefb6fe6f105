#include "hw/base/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <sstream>
#include <system_error>
#include <utility>

#include "hw/base/descriptor.h"
#include "hw/base/error.h"
#include "hw/base/folder.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "hw/base/output_file.h"
#include "hw/base/partial_files.h"

namespace csgsim {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = ".csgsim-files";
constexpr InputKind list_kind{"a list of files", std::size_t{1} << 20U, "delete it"};
constexpr InputKind listed_kind{"a file of the folder", std::size_t{1} << 30U, "delete it"};

void require_done(const fs::path& path, const std::error_code& error) {
  if (error) fail_to_write(path, error);
}

std::string content_hash(std::string_view content) {
  Hash hash;
  hash.add(content);
  return hash.text();
}

[[noreturn]] void refuse_folder(const fs::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}; name an empty folder or a new one", path.native(), why));
}

/// Hashes of the files in a folder's list, by name; empty for a folder without a list.
std::map<fs::path, std::string> listed(const fs::path& folder) {
  std::map<fs::path, std::string> files;
  if (!fs::exists(fs::symlink_status(folder / list_name))) return files;
  std::istringstream lines(read_regular_file(folder / list_name, list_kind));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    if (space != line.npos) files.emplace(line.substr(space + 1), line.substr(0, space));
  }
  return files;
}

/// Throws if a listed file was edited: the edit would be lost.
void check_unedited(const fs::path& requested, const fs::path& folder) {
  for (const auto& [name, hash] : listed(folder)) {
    const fs::path path = folder / name;
    if (fs::is_regular_file(fs::symlink_status(path)) && content_hash(read_regular_file(path, listed_kind)) != hash)
      refuse_folder(requested / name, "it has been edited and would be overwritten");
  }
}

void require_replaceable(const fs::path& requested, const fs::path& place) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) refuse_folder(requested, "it is not a folder");
  const auto [end, ignored] = std::ranges::mismatch(place, fs::current_path());
  if (end == place.end()) refuse_folder(requested, "it contains the current folder and cannot be replaced");
  const bool is_empty = fs::is_empty(place, error);
  require_done(requested, error);
  if (!is_empty && !fs::exists(fs::symlink_status(place / list_name)))
    refuse_folder(requested, "it contains files that csgsim did not write");
  check_unedited(requested, place);
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder) : requested_(std::move(folder)) {
  std::error_code error;
  final_ = fs::weakly_canonical(fs::absolute(resolve_links(requested_)), error);
  require_done(requested_, error);
  if (!final_.has_filename()) final_ = final_.parent_path();
  require_replaceable(requested_, final_);
  make_folder(final_.parent_path());
  const fs::path partial = final_.parent_path() / unique_file_name();
  if (::mkdir(partial.c_str(), 0777) != 0) fail_to_write(requested_, last_error());
  partial_ = partial;
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove_all(partial_, ignored);
}

void OutputFolder::write(const fs::path& name, std::string_view content) {
  make_folder((partial_ / name).parent_path());
  write_file(partial_ / name, content);
  list_ += fmt::format("{} {}\n", content_hash(content), name.native());
}

void OutputFolder::commit() {
  write_file(partial_ / list_name, list_);
  std::error_code error;
  if (!fs::exists(final_) || fs::is_empty(final_, error)) {
    require_done(requested_, error);
    fs::rename(partial_, final_, error);
    require_done(requested_, error);
    partial_.clear();
  } else {
    exchange();
    keep_unlisted_files();
  }
  const Descriptor parent(::open(final_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (parent.is_open()) require_done(requested_, sync(parent));
}

/// Exchanges the two folders. Without RENAME_EXCHANGE the place is empty for a moment between two renames.
void OutputFolder::exchange() {
  struct stat old {};
  if (::stat(final_.c_str(), &old) == 0) static_cast<void>(::chmod(partial_.c_str(), old.st_mode & 0777U));
  if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) fail_to_write(requested_, last_error());
  const fs::path away = final_.parent_path() / unique_file_name();
  std::error_code error;
  fs::rename(final_, away, error);
  require_done(requested_, error);
  fs::rename(partial_, final_, error);
  std::error_code ignored;
  if (error) fs::rename(away, final_, ignored);
  require_done(requested_, error);
  partial_ = away;
}

void OutputFolder::keep_unlisted_files() {
  const std::map<fs::path, std::string> ours = listed(partial_);
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(partial_, error); !error && entry != fs::end(entry);
       entry.increment(error)) {
    const fs::path name = entry->path().lexically_relative(partial_);
    const bool is_other = !entry->is_directory() || entry->is_symlink();
    if (!is_other || name == list_name || ours.contains(name) || fs::exists(fs::symlink_status(final_ / name)))
      continue;
    make_folder((final_ / name).parent_path());
    fs::rename(entry->path(), final_ / name, error);
    require_done(requested_, error);
  }
  require_done(requested_, error);
}

}  // namespace csgsim
