// Parts of C++20 that libc++ for WASI lacks.
// Included before all other headers by sim/web/build.py.
#pragma once

// Included first when csgsim is compiled for the web: parts of C++20 that libc++ 19 for WASI lacks because it has no
// threads, and removed parts that nlohmann-json 3.11 uses.

#include <cfenv>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ios>
#include <string>
#include <utility>

// WebAssembly only rounds to nearest, but CGAL names the other modes.
#ifndef FE_UPWARD
#define FE_UPWARD 1
#define FE_DOWNWARD 2
#define FE_TOWARDZERO 3
#endif

// NOLINTBEGIN(cert-dcl58-cpp): replacements of standard names
namespace std {

class mutex {
 public:
  constexpr mutex() noexcept = default;
  mutex(const mutex&) = delete;
  mutex& operator=(const mutex&) = delete;
  void lock() {}
  bool try_lock() { return true; }
  void unlock() {}
};

/// Owns one mutex from its construction.
template <class Mutex>
class unique_lock {
 public:
  explicit unique_lock(Mutex& mutex) : mutex_(&mutex) { lock(); }
  ~unique_lock() {
    if (owns_) unlock();
  }
  unique_lock(const unique_lock&) = delete;
  unique_lock& operator=(const unique_lock&) = delete;
  void lock() {
    mutex_->lock();
    owns_ = true;
  }
  void unlock() {
    mutex_->unlock();
    owns_ = false;
  }

 private:
  Mutex* mutex_;
  bool owns_ = false;
};

class stop_token {
 public:
  [[nodiscard]] bool stop_requested() const noexcept { return false; }
};

/// Stop requests come from other threads, and there are none.
class stop_source {
 public:
  [[nodiscard]] stop_token get_token() const noexcept { return {}; }
  bool request_stop() noexcept { return true; }
};

/// No thread can be started.
class jthread {
 public:
  jthread() noexcept = default;
  template <class Work>
  explicit jthread(Work&& /*work*/) {
    abort();
  }
  bool request_stop() noexcept { return true; }
};

template <>
struct char_traits<unsigned char> {
  using char_type = unsigned char;
  using int_type = int;
  using off_type = streamoff;
  using pos_type = fpos<mbstate_t>;
  using state_type = mbstate_t;

  static constexpr void assign(char_type& a, const char_type& b) noexcept { a = b; }
  static constexpr bool eq(char_type a, char_type b) noexcept { return a == b; }
  static constexpr bool lt(char_type a, char_type b) noexcept { return a < b; }
  static int compare(const char_type* a, const char_type* b, size_t n) { return memcmp(a, b, n); }
  static size_t length(const char_type* text) { return strlen(reinterpret_cast<const char*>(text)); }
  static const char_type* find(const char_type* text, size_t n, const char_type& c) {
    return static_cast<const char_type*>(memchr(text, c, n));
  }
  static char_type* move(char_type* to, const char_type* from, size_t n) {
    return static_cast<char_type*>(memmove(to, from, n));
  }
  static char_type* copy(char_type* to, const char_type* from, size_t n) {
    return static_cast<char_type*>(memcpy(to, from, n));
  }
  static char_type* assign(char_type* to, size_t n, char_type c) { return static_cast<char_type*>(memset(to, c, n)); }
  static constexpr int_type not_eof(int_type c) noexcept { return c == eof() ? 0 : c; }
  static constexpr char_type to_char_type(int_type c) noexcept { return static_cast<char_type>(c); }
  static constexpr int_type to_int_type(char_type c) noexcept { return c; }
  static constexpr bool eq_int_type(int_type a, int_type b) noexcept { return a == b; }
  static constexpr int_type eof() noexcept { return -1; }
};

from_chars_result from_chars(const char* first, const char* last, double& value, chars_format = chars_format::general);
from_chars_result from_chars(const char* first, const char* last, float& value, chars_format = chars_format::general);

}  // namespace std
// NOLINTEND(cert-dcl58-cpp)
