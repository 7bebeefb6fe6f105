#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/swept/output.h"

namespace csgsim::swept {

inline constexpr std::uint32_t nothing = 0xffffffffU;

/// The vertices that the filter holds, by handles, which are used again. One is held while an edge of the border or an
/// element has it, or while it waits for where it is.
class HeldVertices {
 public:
  HeldVertices(Output& output, RepairCounts& counts) : output_(output), counts_(counts) {}

  /// One of this patch, which may yet be put on a line.
  std::uint32_t add(const glm::dvec3& point);
  /// One of a wire frame, which the output has.
  std::uint32_t add_known(std::uint32_t number, const glm::dvec3& point);

  /// On the line between two others, at that part of the way.
  void put_on_line(std::uint32_t vertex, std::uint32_t from, std::uint32_t to, double part);

  void hold_by_edge(std::uint32_t vertex) { ++slots_[vertex].edges; }
  /// Without an edge of the border nothing puts it on a line any more.
  void drop_by_edge(std::uint32_t vertex);
  void hold_by_element(std::uint32_t vertex) { ++slots_[vertex].elements; }
  void drop_by_element(std::uint32_t vertex);

  [[nodiscard]] std::uint32_t number(std::uint32_t vertex) const { return slots_[vertex].number; }
  [[nodiscard]] std::uint64_t held() const { return held_; }

 private:
  /// Another one that this one is an end of the line of.
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
    std::uint32_t missing = 0;  ///< ends of its line that are not settled
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
