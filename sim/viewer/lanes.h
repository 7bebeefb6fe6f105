#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace csgsim::viewer {

/// What the parts of a machine are at, clock for clock, as lanes that can be looked at from near and from far.
class Lanes {
 public:
  /// Of a file of trace events as waves::TraceEvents writes it.
  explicit Lanes(std::string_view trace_events);

  /// The first clock of which something is known, and the one after the last.
  [[nodiscard]] std::uint64_t begin() const { return begin_; }
  [[nodiscard]] std::uint64_t end() const { return end_; }

  /// Of these clocks an array of lanes: `part`, `name` and `stretches`, each [first clock, clocks, what is shown].
  /// Those that are too short to be told apart are put together: [first clock, clocks, what the most of them show, how
  /// many, clocks in which something is shown].
  [[nodiscard]] nlohmann::ordered_json between(std::uint64_t begin, std::uint64_t end) const;

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
    std::vector<Stretch> stretches;  ///< in order
  };
  class Shortened;

  void take(const nlohmann::json& event);
  std::uint32_t index_of(const std::string& text);

  std::vector<std::string> texts_;
  std::unordered_map<std::string, std::uint32_t> indices_;  ///< of the texts
  std::unordered_map<unsigned, std::string> parts_;         ///< by their numbers in the file
  std::unordered_map<unsigned, std::size_t> lane_of_;       ///< the same
  std::vector<Lane> lanes_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace csgsim::viewer
