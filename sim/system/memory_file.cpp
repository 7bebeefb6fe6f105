#include "sim/system/memory_file.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <limits>
#include <utility>

#include "hw/base/error.h"

namespace csgsim::system {

namespace {

/// Number of writes of this process refused by a file size limit (ulimit -f).
std::atomic<unsigned> refused_writes = 0;
static_assert(std::atomic<unsigned>::is_always_lock_free);

extern "C" void count_refused_write(int) { ++refused_writes; }

/// The kernel signals each such write. If the signal is ignored, the writing library may hide the error, so the refused
/// writes are counted. Child programs get the default action, which ends them.
void watch_refused_writes() {
  struct sigaction action {};
  if (::sigaction(SIGXFSZ, nullptr, &action) != 0 || action.sa_handler != SIG_IGN) return;
  action.sa_handler = count_refused_write;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGXFSZ, &action, nullptr);
}

}  // namespace

MemoryFile::MemoryFile(std::filesystem::path purpose)
    : purpose_(std::move(purpose)), descriptor_(::memfd_create("csgsim", MFD_CLOEXEC)) {
  if (!descriptor_.is_open()) fail(last_error());
  watch_refused_writes();
  refused_before_ = refused_writes;
}

void MemoryFile::fail(const std::error_code& error) const {
  throw InputError(fmt::format("{}: cannot create a file in memory: {}; check the limits of this process (ulimit -a)",
                               purpose_.native(), error.message()));
}

std::string MemoryFile::path() const { return fmt::format("/proc/self/fd/{}", descriptor_.number()); }

void MemoryFile::write(std::string_view bytes) {
  append(bytes);
  rewind();
}

void MemoryFile::append(std::string_view bytes) {
  if (const std::error_code error = write_all(descriptor_, bytes)) fail(error);
}

void MemoryFile::rewind() const {
  if (::lseek(descriptor_.number(), 0, SEEK_SET) != 0) fail(last_error());
}

std::string MemoryFile::content() const {
  if (refused_writes != refused_before_) fail(std::make_error_code(std::errc::file_too_large));
  rewind();
  std::string bytes;
  if (const std::error_code error = read_to_end(descriptor_, bytes, std::numeric_limits<std::size_t>::max()))
    fail(error);
  return bytes;
}

}  // namespace csgsim::system
