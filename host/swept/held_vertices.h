// Vertices held by the integrity filter.
// Used by filter.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/swept/output.h"

namespace csgsim::swept {

inline constexpr std::uint32_t nothing = 0xffffffffU;

/// The vertices held by the integrity filter, addressed by reusable handles. A vertex is held while a border edge or an
/// element uses it, or while its final position is unknown.
class HeldVertices {
 public:
  HeldVertices(Output& output, RepairCounts& counts) : output_(output), counts_(counts) {}

  /// Adds a vertex of this patch, which may still be placed on a line.
  std::uint32_t add(const glm::dvec3& point);
  /// Adds a vertex of a wire frame, which has already been sent to the output.
  std::uint32_t add_known(std::uint32_t number, const glm::dvec3& point);

  /// Places a vertex on the line between two others, at a fraction from 0 (`from`) to 1 (`to`).
  void place_on_line(std::uint32_t vertex, std::uint32_t from, std::uint32_t to, double fraction);

  void hold_by_edge(std::uint32_t vertex) { ++slots_[vertex].edges; }
  /// Releases the vertex for one edge. A vertex that no border edge holds is never placed on a line again.
  void release_by_edge(std::uint32_t vertex);
  void hold_by_element(std::uint32_t vertex) { ++slots_[vertex].elements; }
  void release_by_element(std::uint32_t vertex);

  /// Number of the vertex in the output.
  [[nodiscard]] std::uint32_t number(std::uint32_t vertex) const { return slots_[vertex].number; }
  [[nodiscard]] std::uint64_t held() const { return held_; }

 private:
  /// A vertex whose line ends at this one.
  struct Waiting {
    std::uint32_t vertex;
    std::uint32_t end;  ///< 0 or 1
  };
  struct Slot {
    std::uint32_t number = 0;
    glm::dvec3 point{0};
    std::uint32_t edges = 0;
    std::uint32_t elements = 0;
    bool is_settled = false;
    bool is_on_line = false;
    std::uint32_t missing = 0;  ///< number of ends of its line that have no final position yet
    std::array<glm::dvec3, 2> ends{};
    double part = 0;
    std::vector<Waiting> waiting;
  };

  std::uint32_t take_slot();
  void settle(std::uint32_t vertex);
  void settle_on_line(std::uint32_t vertex);
  void free_if_unused(std::uint32_t vertex);

  Output& output_;
  RepairCounts& counts_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::uint64_t held_ = 0;
};

}  // namespace csgsim::swept
