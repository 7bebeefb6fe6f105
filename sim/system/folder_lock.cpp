#include "sim/system/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "hw/base/error.h"

namespace csgsim::system {

namespace {

constexpr std::size_t max_holder_bytes = 200;

[[noreturn]] void fail(const std::filesystem::path& folder, const std::error_code& error) {
  throw InputError(fmt::format("{}: cannot be locked: {}; check the path, its permissions and the free disk space",
                               folder.native(), error.message()));
}

[[noreturn]] void fail_held(const std::filesystem::path& folder, const Descriptor& file) {
  std::string holder;
  static_cast<void>(read_to_end(file, holder, max_holder_bytes));
  throw InputError(fmt::format("{}: another csgsim is writing there ({}); wait until it ends, or choose another -o",
                               folder.native(), holder.empty() ? "just started" : holder));
}

[[noreturn]] void fail_foreign(const std::filesystem::path& path) {
  throw InputError(
      path.native() +
      ": not a lock file of csgsim, but a link, a file with several names or a special file; delete it, or choose "
      "another -o");
}

/// Opens or creates the lock file without following links, since its content is replaced.
Descriptor open_lock(const std::filesystem::path& folder, const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666));
  if (!file.is_open() && errno == ELOOP) fail_foreign(path);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0) fail(folder, last_error());
  if (!S_ISREG(status.st_mode) || status.st_nlink > 1) fail_foreign(path);
  return file;
}

/// A lock is valid only if its file still has the name: the previous holder may have deleted it meanwhile.
bool has_name(const Descriptor& file, const std::filesystem::path& path) {
  struct stat open {};
  struct stat named {};
  return ::fstat(file.number(), &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, std::string_view purpose) : path_(folder / ".csgsim-lock") {
  do {
    file_ = open_lock(folder, path_);
    if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) fail_held(folder, file_);
      fail(folder, last_error());
    }
  } while (!has_name(file_, path_));
  registered_.emplace(path_);
  // The holder's name is informative only; write errors do not matter.
  static_cast<void>(::ftruncate(file_.number(), 0));
  static_cast<void>(write_all(file_, fmt::format("process {}, {}", ::getpid(), purpose)));
}

FolderLock::~FolderLock() { ::unlink(path_.c_str()); }

}  // namespace csgsim::system
