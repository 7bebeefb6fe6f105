#include "hw/base/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <new>
#include <optional>
#include <system_error>

#include "hw/base/descriptor.h"
#include "hw/base/error.h"
#include "hw/base/standard_streams.h"

namespace csgsim {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: cannot be read: {}", path.native(), why));
}

/// `1 MiB`, `64 KiB`: limits are whole numbers of these.
std::string size_text(std::size_t bytes) {
  constexpr std::size_t mib = std::size_t{1} << 20U;
  return bytes >= mib ? fmt::format("{} MiB", bytes / mib) : fmt::format("{} KiB", bytes >> 10U);
}

}  // namespace

void check_length(std::string_view name, std::size_t bytes, const InputKind& kind) {
  if (bytes <= kind.most_bytes) return;
  throw InputError(fmt::format("{}: longer than {}; {}", name, size_text(kind.most_bytes), kind.advice));
}

namespace {

std::string read_open(const Descriptor& file, const std::filesystem::path& path, const InputKind& kind) {
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0)
    fail(path, last_error().message() + "; check the path and its permissions");
  if (S_ISDIR(status.st_mode)) fail(path, fmt::format("it is a folder; name {}", kind.what));
  const auto expected = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  check_length(path.native(), expected, kind);
  std::string bytes;
  try {
    bytes.reserve(expected);
    // One more tells that it is longer, where there can be more.
    const std::size_t most = std::max(kind.most_bytes, kind.most_bytes + 1);
    if (const std::error_code error = read_to_end(file, bytes, most)) fail(path, error.message());
  } catch (const std::bad_alloc&) {
    const std::size_t read = std::max(expected, bytes.size());
    throw InputError(fmt::format("{}: there is not enough memory to read its {} bytes", path.native(), read));
  }
  check_length(path.native(), bytes.size(), kind);
  return bytes;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, const InputKind& kind) {
  if (path.native() != standard_stream)
    return read_open(Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), path, kind);
  static std::optional<std::string> kept;
  if (kept) check_length("standard input", kept->size(), kind);
  if (!kept) kept = read_open(Descriptor(::dup(STDIN_FILENO)), "standard input", kind);
  return *kept;
}

}  // namespace csgsim
