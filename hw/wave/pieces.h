// Buffers a long text.
// Used by VcdWriter and sim/waves.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace csgsim::wave {

/// Buffers a long text and writes it in pieces of about 64 KiB.
class Pieces {
 public:
  explicit Pieces(std::function<void(std::string_view)> write) : write_(std::move(write)) {}

  /// Text not written yet; callers append to it.
  std::string text;

  /// Writes and clears the text if it has at least 64 KiB.
  void write_if_long() {
    if (text.size() >= piece_bytes) write_all();
  }
  /// Writes and clears the text.
  void write_all() { write_(std::exchange(text, {})); }

 private:
  static constexpr std::size_t piece_bytes = std::size_t{1} << 16U;

  std::function<void(std::string_view)> write_;
};

}  // namespace csgsim::wave
