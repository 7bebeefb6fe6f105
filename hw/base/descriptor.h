#pragma once

#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace csgsim {

/// What errno says now.
std::error_code last_error();

/// An open file of the system, closed at its end.
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

  /// Closes it if it is open, and says what went wrong: a network's disk may tell only then that a write failed.
  std::error_code close();

 private:
  int number_ = -1;
};

/// Writes all the bytes, at the descriptor's place.
std::error_code write_all(const Descriptor& descriptor, std::string_view bytes);

/// Has all that was written on the disk itself, where there is one.
std::error_code sync(const Descriptor& descriptor);

/// Appends at most `most` of the bytes from the descriptor's place to its end; more is not read.
std::error_code read_to_end(const Descriptor& descriptor, std::string& bytes, std::size_t most);

}  // namespace csgsim
