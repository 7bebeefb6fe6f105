#include "hw/base/pipe_into.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

#include "hw/base/error.h"

namespace csgsim {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::error_code& error) {
  throw InputError(fmt::format("{}: no pipe can be made there: {}; point TMPDIR to a folder on this machine",
                               path.native(), error.message()));
}

}  // namespace

PipeInto::PipeInto(OutputFile& file, std::string_view ending) : file_(file) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) fail(folder, error);
  path_ = folder / unused_name(ending);
  registered_.emplace(path_);
  if (::mkfifo(path_.c_str(), 0600) != 0) fail(folder, last_error());
  source_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  keeper_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
  if (!source_.is_open() || !keeper_.is_open() || ::fcntl(source_.number(), F_SETFL, 0) != 0) {
    error = last_error();
    ::unlink(path_.c_str());
    fail(folder, error);
  }
  thread_ = std::thread([this] { take(); });
}

PipeInto::~PipeInto() { join(); }

void PipeInto::take() {
  constexpr std::size_t block = std::size_t{1} << 16U;
  std::string bytes;
  do {
    bytes.clear();
    try {
      if (const std::error_code error = read_to_end(source_, bytes, block)) fail(path_, error);
      if (!failure_) file_.write(bytes);
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
  } while (!bytes.empty());
}

void PipeInto::join() {
  if (!thread_.joinable()) return;
  static_cast<void>(keeper_.close());
  thread_.join();
  ::unlink(path_.c_str());
  registered_.reset();
}

void PipeInto::finish() {
  join();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace csgsim
