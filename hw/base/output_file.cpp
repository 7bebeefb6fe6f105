#include "hw/base/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/inputs_kept.h"
#include "hw/base/standard_streams.h"

namespace csgsim {

namespace {

namespace fs = std::filesystem;

constexpr int max_links = 40;

void require_success(const fs::path& path, const std::error_code& error) {
  if (error) fail_to_write(path, error);
}

/// Throws if the path is an existing file without write permission, even if its folder would permit a replacement, or
/// if no file can have that name.
void require_writable(const fs::path& requested, const fs::path& place) {
  const bool is_there = ::faccessat(AT_FDCWD, place.c_str(), F_OK, AT_EACCESS) == 0;
  if (!is_there && errno != ENOENT) fail_to_write(requested, last_error());
  if (is_there && ::faccessat(AT_FDCWD, place.c_str(), W_OK, AT_EACCESS) != 0) fail_to_write(requested, last_error());
}

/// Throws if this process has read the file that would be replaced.
void refuse_kept_input(const fs::path& requested, const fs::path& place) {
  const std::optional<fs::path> input = recorded_input(place);
  if (!input) return;
  throw InputError(
      fmt::format("{}: it is the same file as the input {}; name another output", requested.native(), input->native()));
}

fs::path parent_folder(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Duplicates standard output or standard error if the path names the same stream, so that its position is kept;
/// otherwise opens the path.
Descriptor open_stream(const fs::path& path) {
  struct stat wanted {};
  if (::stat(path.c_str(), &wanted) != 0) return {};
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat open {};
    if (::fstat(number, &open) == 0 && open.st_dev == wanted.st_dev && open.st_ino == wanted.st_ino)
      return Descriptor(::dup(number));
  }
  return Descriptor(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
}

[[noreturn]] void fail_on_terminal(const fs::path& path) {
  throw InputError(path.native() +
                   ": a terminal cannot show binary data; name a file, or pipe the output to a program");
}

/// Makes the file's name durable: the entry in its folder must also reach the disk.
std::error_code sync_folder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // A user may have permission to write to a folder but not to read it.
  return descriptor.is_open() ? sync(descriptor) : std::error_code{};
}

}  // namespace

void fail_to_write(const fs::path& path, const std::error_code& error) {
  const fs::path folder = parent_folder(path);
  std::error_code ignored;
  if (error == std::errc::is_a_directory)
    throw InputError(fmt::format("{}: cannot be written: it is a folder; name a file", path.native()));
  if (error == std::errc::no_such_file_or_directory && !fs::exists(folder, ignored) && !ignored)
    throw InputError(fmt::format("{}: cannot be written: the folder {} does not exist; create it first", path.native(),
                                 folder.native()));
  throw InputError(fmt::format("{}: cannot be written: {}; check the path, its permissions and the free disk space",
                               path.native(), error.message()));
}

bool is_stream(const fs::path& path) {
  if (is_standard_output(path)) return true;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail_to_write(path, std::make_error_code(std::errc::is_a_directory));
  if (!fs::exists(status)) return false;
  const fs::path folder = fs::canonical(fs::absolute(path).parent_path(), error);
  return !fs::is_regular_file(status) || folder == "/dev" || folder.native().starts_with("/proc/");
}

fs::path resolve_links(const fs::path& path) {
  fs::path place = path;
  std::error_code error;
  for (int link = 0; link < max_links; ++link) {
    if (!fs::is_symlink(fs::symlink_status(place, error))) return place;
    const fs::path target = fs::read_symlink(place, error);
    require_success(path, error);
    place = place.parent_path() / target;
  }
  fail_to_write(path, std::make_error_code(std::errc::too_many_symbolic_link_levels));
}

OutputFile::OutputFile(fs::path path) : requested_(std::move(path)), final_(requested_) {
  if (requested_.empty()) throw InputError("an output has an empty name; name the file");
  if (requested_.native().find('\0') != std::string::npos)
    throw InputError(requested_.native() + ": the name of an output contains a zero byte; remove it");
  is_stream_ = is_stream(requested_);
  if (is_standard_output(requested_)) standard_output_ = reserve_standard_output();
  std::error_code error;
  if (!is_stream_) {
    final_ = resolve_links(requested_);
    require_writable(requested_, final_);
    refuse_kept_input(requested_, final_);
  }
  const fs::path folder = is_stream_ ? fs::temp_directory_path(error) : parent_folder(final_);
  require_success(requested_, error);
  create(folder);
}

/// The new file gets the permissions of the file that it replaces.
void OutputFile::create(const fs::path& folder) {
  partial_ = folder / unique_file_name();
  registered_.emplace(partial_);
  file_ = Descriptor(::open(partial_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file_.is_open()) {
    partial_.clear();
    fail_to_write(requested_, last_error());
  }
  struct stat replaced {};
  if (!is_stream_ && ::stat(final_.c_str(), &replaced) == 0)
    static_cast<void>(::fchmod(file_.number(), replaced.st_mode & 0777U));
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove(partial_, ignored);
}

void OutputFile::write(std::string_view content) { require_success(requested_, write_all(file_, content)); }

void OutputFile::finish() {
  if (std::exchange(is_finished_, true) || is_stream_) return;
  refuse_kept_input(requested_, final_);  // the file may have been read since the constructor's check
  require_success(requested_, sync(file_));
  require_success(requested_, file_.close());
}

void OutputFile::commit() {
  finish();
  if (is_stream_) return copy_to_stream();
  std::error_code error;
  fs::rename(partial_, final_, error);
  require_success(requested_, error);
  registered_.reset();
  partial_.clear();
  require_success(requested_, sync_folder(parent_folder(final_)));
}

void OutputFile::copy_to_stream() {
  std::fflush(stdout);
  const bool is_ours = is_standard_output(requested_);
  const Descriptor stream = is_ours ? std::move(standard_output_) : open_stream(final_);
  if (!stream.is_open() || ::lseek(file_.number(), 0, SEEK_SET) != 0) fail_to_write(requested_, last_error());
  const bool is_seen = ::isatty(stream.number()) != 0;
  constexpr std::size_t block = std::size_t{1} << 16U;
  std::string bytes;
  do {
    bytes.clear();
    require_success(requested_, read_to_end(file_, bytes, block));
    if (is_seen && bytes.find('\0') != std::string::npos) fail_on_terminal(requested_);
    require_success(requested_, write_all(stream, bytes));
  } while (!bytes.empty());
}

void commit_all(std::span<OutputFile* const> files) {
  for (OutputFile* const file : files) {
    if (file != nullptr) file->finish();
  }
  for (OutputFile* const file : files) {
    if (file != nullptr) file->commit();
  }
}

void write_file(const fs::path& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace csgsim
