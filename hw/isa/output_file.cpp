#include "hw/isa/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "hw/isa/error.h"

namespace csgsim {

namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw InputError(fmt::format("{}: cannot write it: {}; check the path and its permissions", path.string(),
                               error ? error.message() : "input/output error"));
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// What the path's symbolic links lead to, there or not.
fs::path followed(const fs::path& path) {
  fs::path place = path;
  std::error_code error;
  for (int link = 0; link < most_links; ++link) {
    if (!fs::is_symlink(fs::symlink_status(place, error))) return place;
    const fs::path target = fs::read_symlink(place, error);
    if (error) fail(path, error);
    place = place.parent_path() / target;
  }
  fail(path, std::make_error_code(std::errc::too_many_symbolic_link_levels));
}

/// Is it something to write to that is not a file of its own: a device, a pipe, a descriptor of this process?
bool is_stream(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail(path, std::make_error_code(std::errc::is_a_directory));
  if (!fs::exists(status)) return false;
  const fs::path folder = fs::canonical(fs::absolute(path).parent_path(), error);
  return !fs::is_regular_file(status) || folder == "/dev" || folder.string().starts_with("/proc/");
}

/// A name that no other file of this process or another has, with the extension.
fs::path partial_name(const fs::path& extension) {
  static std::atomic<unsigned> number = 0;
  return fmt::format(".csgsim-{}-{}{}", ::getpid(), ++number, extension.string());
}

/// Closes a descriptor at its end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// A stream that standard output or error is connected to is written to through these, at their place in it.
int open_stream(const fs::path& path) {
  struct stat wanted {};
  if (::stat(path.c_str(), &wanted) != 0) return -1;
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat open {};
    if (::fstat(number, &open) == 0 && open.st_dev == wanted.st_dev && open.st_ino == wanted.st_ino)
      return ::dup(number);
  }
  return ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : asked_(std::move(path)), final_(asked_), is_stream_(is_stream(asked_)) {
  if (!is_stream_) final_ = followed(asked_);
  std::error_code error;
  const fs::path folder = is_stream_ ? fs::temp_directory_path(error) : final_.parent_path();
  if (error) fail(asked_, error);
  partial_ = folder / partial_name(asked_.extension());
  registered_.emplace(partial_);
  const Descriptor created(::open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (created.number() < 0) fail(asked_, last_error());
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove(partial_, ignored);
}

void OutputFile::write(std::string_view content) const {
  errno = 0;
  std::ofstream file(partial_, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) fail(asked_, last_error());
}

void OutputFile::commit() {
  if (is_stream_) return copy_to_stream();
  std::error_code error;
  fs::rename(partial_, final_, error);
  if (error) fail(asked_, error);
  registered_.reset();
  partial_.clear();
}

void OutputFile::copy_to_stream() const {
  std::fflush(stdout);
  const Descriptor stream(open_stream(final_));
  if (stream.number() < 0) fail(asked_, last_error());
  std::ifstream file(partial_, std::ios::binary);
  std::string block(std::size_t{1} << 16U, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    if (!write_all(stream.number(), {block.data(), static_cast<std::size_t>(file.gcount())}))
      fail(asked_, last_error());
  }
}

void write_file(const fs::path& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace csgsim
