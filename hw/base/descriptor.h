// Owner of a POSIX file descriptor, with read, write and sync functions.
// Used for files in hw/base and host/read, and by sim/system, sim/session, sim/studies and sim/web.
#pragma once

#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace csgsim {

/// The current value of errno as an error code.
std::error_code last_error();

/// An open file descriptor. The destructor closes it.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { static_cast<void>(close()); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

  /// Closes the descriptor if it is open. The error matters: a network file system may report a failed write only here.
  std::error_code close();

 private:
  int number_ = -1;
};

/// Writes all the bytes at the descriptor's current position.
std::error_code write_all(const Descriptor& descriptor, std::string_view bytes);

/// Flushes everything written to the disk. Succeeds on files that have no disk, such as pipes.
std::error_code sync(const Descriptor& descriptor);

/// Appends the rest of the file, but at most `max_bytes` bytes, to `bytes`.
std::error_code read_to_end(const Descriptor& descriptor, std::string& bytes, std::size_t max_bytes);

}  // namespace csgsim
