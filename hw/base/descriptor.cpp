#include "hw/base/descriptor.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>

namespace csgsim {

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code Descriptor::close() {
  if (!is_open()) return {};
  const int closed = ::close(std::exchange(number_, -1));
  return closed != 0 && errno != EINTR ? last_error() : std::error_code{};
}

std::error_code write_all(const Descriptor& descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return last_error();
    if (written == 0) return std::make_error_code(std::errc::no_space_on_device);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

std::error_code sync(const Descriptor& descriptor) {
  while (::fsync(descriptor.number()) != 0) {
    if (errno == EINTR) continue;
    const bool has_no_disk = errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
    return has_no_disk ? std::error_code{} : last_error();
  }
  return {};
}

std::error_code read_to_end(const Descriptor& descriptor, std::string& bytes, std::size_t max_bytes) {
  constexpr std::size_t block = std::size_t{1} << 16U;
  std::size_t left = max_bytes;
  while (left > 0) {
    const std::size_t known = bytes.size();
    bytes.resize(known + std::min(block, left));
    const ssize_t count = ::read(descriptor.number(), bytes.data() + known, bytes.size() - known);
    bytes.resize(known + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return last_error();
    if (count == 0) return {};
    left -= static_cast<std::size_t>(count);
  }
  return {};
}

}  // namespace csgsim
