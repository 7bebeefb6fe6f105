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
#include "hw/base/text.h"

namespace csgsim {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = ".csgsim-files";
constexpr InputKind list_kind{"a list of files", std::size_t{1} << 20U, "delete it"};
constexpr InputKind listed_kind{"a file of the folder", std::size_t{1} << 30U, "delete it"};

void require_done(const fs::path& path, const std::error_code& error) {
  if (error) fail_to_write(path, error);
}

std::string hash_of(std::string_view content) {
  Hash hash;
  hash.add(content);
  return hash.text();
}

[[noreturn]] void refuse_folder(const fs::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}; name a folder that is empty or not there", printable(path.native()), why));
}

/// The hashes of the files in a folder's list, by name; of a folder without one, none.
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

/// Throws if an edit would be lost.
void check_unedited(const fs::path& asked, const fs::path& folder) {
  for (const auto& [name, hash] : listed(folder)) {
    const fs::path path = folder / name;
    if (fs::is_regular_file(fs::symlink_status(path)) && hash_of(read_regular_file(path, listed_kind)) != hash)
      refuse_folder(asked / name, "it has been edited, and would be replaced");
  }
}

void require_replaceable(const fs::path& asked, const fs::path& place) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) refuse_folder(asked, "it is not a folder");
  const auto [end, ignored] = std::ranges::mismatch(place, fs::current_path());
  if (end == place.end()) refuse_folder(asked, "the current folder is in it, so no other can take its place");
  const bool is_empty = fs::is_empty(place, error);
  require_done(asked, error);
  if (!is_empty && !fs::exists(fs::symlink_status(place / list_name)))
    refuse_folder(asked, "it has files that csgsim did not write");
  check_unedited(asked, place);
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder) : asked_(std::move(folder)) {
  std::error_code error;
  final_ = fs::weakly_canonical(fs::absolute(without_links(asked_)), error);
  require_done(asked_, error);
  if (!final_.has_filename()) final_ = final_.parent_path();
  require_replaceable(asked_, final_);
  make_folder(final_.parent_path());
  const fs::path partial = final_.parent_path() / unused_name();
  if (::mkdir(partial.c_str(), 0777) != 0) fail_to_write(asked_, last_error());
  partial_ = partial;
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove_all(partial_, ignored);
}

void OutputFolder::write(const fs::path& name, std::string_view content) {
  make_folder((partial_ / name).parent_path());
  write_file(partial_ / name, content);
  list_ += fmt::format("{} {}\n", hash_of(content), name.native());
}

void OutputFolder::commit() {
  write_file(partial_ / list_name, list_);
  std::error_code error;
  if (!fs::exists(final_) || fs::is_empty(final_, error)) {
    require_done(asked_, error);
    fs::rename(partial_, final_, error);
    require_done(asked_, error);
    partial_.clear();
  } else {
    exchange();
    take_others_back();
  }
  const Descriptor parent(::open(final_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (parent.is_open()) require_done(asked_, sync(parent));
}

/// Exchanges the folders; a file system that cannot do so has neither in the place for a moment.
void OutputFolder::exchange() {
  struct stat old {};
  if (::stat(final_.c_str(), &old) == 0) static_cast<void>(::chmod(partial_.c_str(), old.st_mode & 0777U));
  if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) fail_to_write(asked_, last_error());
  const fs::path away = final_.parent_path() / unused_name();
  std::error_code error;
  fs::rename(final_, away, error);
  require_done(asked_, error);
  fs::rename(partial_, final_, error);
  std::error_code ignored;
  if (error) fs::rename(away, final_, ignored);
  require_done(asked_, error);
  partial_ = away;
}

void OutputFolder::take_others_back() {
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
    require_done(asked_, error);
  }
  require_done(asked_, error);
}

}  // namespace csgsim
