#include "hw/base/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <optional>
#include <system_error>

#include "hw/base/descriptor.h"
#include "hw/base/error.h"
#include "hw/base/inputs_kept.h"
#include "hw/base/nearest.h"
#include "hw/base/standard_streams.h"

namespace csgsim {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: cannot be read: {}", path.native(), why));
}

/// Whether `path` is probably a misspelling of `other`: the name without its extension, or with one or two different
/// letters.
bool is_misspelling_of(const std::filesystem::path& other, const std::filesystem::path& path) {
  constexpr std::size_t shortest = 4;
  constexpr std::size_t long_name = 8;
  const std::string name = path.filename().native();
  if (other.filename() == name) return false;  // a broken link
  if (other.stem() == name) return true;
  return name.size() >= shortest &&
         edit_distance(name, other.filename().native()) <= (name.size() >= long_name ? 2U : 1U);
}

/// A file of the same folder with a similar name; empty if there is none.
std::filesystem::path similar_file(const std::filesystem::path& path) {
  constexpr int max_entries = 10'000;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::filesystem::path found;
  std::error_code error;
  auto entry = std::filesystem::directory_iterator(folder, error);
  for (int i = 0; i < max_entries && !error && entry != std::filesystem::directory_iterator(); ++i) {
    const std::filesystem::path& other = entry->path();
    // A folder lists its entries in arbitrary order, so the alphabetically first name is chosen.
    if (is_misspelling_of(other, path) && (found.empty() || other < found)) found = other;
    entry.increment(error);
  }
  return found.empty() || path.has_parent_path() ? found : found.filename();
}

/// Advice for a file that does not exist: a similar name, or what to check.
std::string advice_for_missing(const std::filesystem::path& path, std::string_view what_to_check) {
  const std::filesystem::path similar = similar_file(path);
  return similar.empty() ? std::string(what_to_check) : fmt::format("did you mean {}?", similar.native());
}

[[noreturn]] void fail_to_open(const std::filesystem::path& path) {
  if (path.empty()) throw InputError("the name of a file is empty; name the file");
  constexpr std::string_view check = "check the path and its permissions";
  const std::error_code error = last_error();
  const bool is_missing = error == std::errc::no_such_file_or_directory;
  fail(path, fmt::format("{}; {}", error.message(), is_missing ? advice_for_missing(path, check) : std::string(check)));
}

/// System calls would end the name at the zero byte.
void refuse_zero_byte(const std::filesystem::path& path) {
  if (path.native().find('\0') != std::string::npos) fail(path, "its name contains a zero byte; remove it");
}

std::string read_all(const Descriptor& file, const std::filesystem::path& path, const InputKind& kind) {
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0) fail_to_open(path);
  if (S_ISDIR(status.st_mode)) fail(path, fmt::format("it is a folder; name {}", kind.what));
  const auto expected = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  check_length(path.native(), expected, kind);
  std::string bytes;
  try {
    bytes.reserve(expected);
    // One byte more than the limit shows that the file is too long; max() guards against overflow.
    const std::size_t most = std::max(kind.max_bytes, kind.max_bytes + 1);
    if (const std::error_code error = read_to_end(file, bytes, most)) fail(path, error.message());
  } catch (const std::bad_alloc&) {
    const std::size_t read = std::max(expected, bytes.size());
    throw InputError(
        fmt::format("{}: there is not enough memory to read its {} bytes; use a smaller file", path.native(), read));
  }
  check_length(path.native(), bytes.size(), kind);
  return bytes;
}

}  // namespace

std::string read_file(const Descriptor& file, const std::filesystem::path& path, const InputKind& kind) {
  std::string bytes = read_all(file, path, kind);
  if (!kind.is_continued) record_input(path);
  return bytes;
}

std::string read_file(const std::filesystem::path& path, const InputKind& kind) {
  refuse_zero_byte(path);
  if (path.native() != standard_stream)
    return read_file(Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), path, kind);
  static std::optional<std::string> kept;
  if (kept) check_length("standard input", kept->size(), kind);
  if (!kept) {
    kept = read_all(Descriptor(::dup(STDIN_FILENO)), "standard input", kind);
    record_input(standard_input_file);
  }
  return *kept;
}

namespace {

void require_regular(const Descriptor& file, const std::filesystem::path& path, const InputKind& kind) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(path, last_error().message());
  if (S_ISDIR(status.st_mode)) fail(path, fmt::format("it is a folder; name {}", kind.what));
  if (!S_ISREG(status.st_mode)) fail(path, fmt::format("it is a pipe or a device; name {}", kind.what));
}

}  // namespace

Descriptor open_regular_file(const std::filesystem::path& path, const InputKind& kind) {
  refuse_zero_byte(path);
  // The file is examined before it is opened: opening a device may have side effects.
  const Descriptor seen(::open(path.c_str(), O_PATH | O_CLOEXEC));
  if (!seen.is_open()) {
    if (errno == ENOENT || errno == ENOTDIR) return {};
    fail(path, last_error().message() + "; check the path and its permissions");
  }
  require_regular(seen, path, kind);
  Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file.is_open()) fail(path, last_error().message() + "; check the path and its permissions");
  require_regular(file, path, kind);
  return file;
}

std::string read_regular_file(const std::filesystem::path& path, const InputKind& kind) {
  const Descriptor file = open_regular_file(path, kind);
  if (!file.is_open()) fail(path, "there is no such file; " + advice_for_missing(path, "check the path"));
  return read_file(file, path, kind);
}

}  // namespace csgsim
