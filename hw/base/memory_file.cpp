#include "hw/base/memory_file.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <limits>

#include "hw/base/error.h"

namespace csgsim {

namespace {

[[noreturn]] void fail(const std::error_code& error) {
  throw InputError("a file in memory cannot be used: " + error.message());
}

/// Where ulimit -f ends a file without a word when its signal is ignored.
bool reaches_limit(std::size_t bytes) {
  struct rlimit limit {};
  return ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && bytes >= limit.rlim_cur;
}

}  // namespace

MemoryFile::MemoryFile() : descriptor_(::memfd_create("csgsim", MFD_CLOEXEC)) {
  if (!descriptor_.is_open()) fail(last_error());
}

std::string MemoryFile::path() const { return fmt::format("/proc/self/fd/{}", descriptor_.number()); }

std::string MemoryFile::content() const {
  if (::lseek(descriptor_.number(), 0, SEEK_SET) != 0) fail(last_error());
  std::string bytes;
  if (const std::error_code error = read_to_end(descriptor_, bytes, std::numeric_limits<std::size_t>::max()))
    fail(error);
  if (reaches_limit(bytes.size())) fail(std::make_error_code(std::errc::file_too_large));
  return bytes;
}

}  // namespace csgsim
