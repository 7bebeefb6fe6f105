// Activities of a machine's units, merged for display.
// Used by drawings.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace csgsim::viewer {

/// Activities of the machine's units by clock, as lanes that the page can zoom.
class Lanes {
 public:
  /// Reads trace events as waves::TraceEvents writes them.
  explicit Lanes(std::string_view trace_events);

  /// The first recorded clock, and the clock after the last recorded one.
  [[nodiscard]] std::uint64_t begin() const { return begin_; }
  [[nodiscard]] std::uint64_t end() const { return end_; }

  /// The lanes between two clocks, as an array of `part`, `name` and `stretches`, each [first clock, clocks, text].
  /// Stretches too short to be distinguished are merged: [first clock, clocks, most frequent text, number of stretches,
  /// clocks with activity].
  [[nodiscard]] nlohmann::ordered_json between(std::uint64_t begin_clock, std::uint64_t end_clock) const;

 private:
  struct Stretch {
    std::uint64_t begin = 0;
    std::uint64_t clocks = 0;
    std::uint32_t text = 0;  ///< index into texts_

    [[nodiscard]] std::uint64_t end() const { return begin + clocks; }
  };
  struct Lane {
    std::string part;
    std::string name;
    std::vector<Stretch> stretches;  ///< ordered by time
  };
  class Shortened;

  void take(const nlohmann::json& event);
  std::uint32_t text_index(const std::string& text);

  std::vector<std::string> texts_;
  std::unordered_map<std::string, std::uint32_t> indices_;  ///< index of each text
  std::unordered_map<unsigned, std::string> parts_;         ///< unit names by their numbers in the file
  std::unordered_map<unsigned, std::size_t> lane_of_;       ///< index into lanes_, by number in the file
  std::vector<Lane> lanes_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace csgsim::viewer
