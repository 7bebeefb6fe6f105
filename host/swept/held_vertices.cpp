#include "host/swept/held_vertices.h"

#include <glm/common.hpp>
#include <utility>

namespace csgsim::swept {

std::uint32_t HeldVertices::take_slot() {
  ++held_;
  if (free_.empty()) {
    slots_.emplace_back();
    return static_cast<std::uint32_t>(slots_.size() - 1);
  }
  const std::uint32_t vertex = free_.back();
  free_.pop_back();
  slots_[vertex] = {};
  return vertex;
}

std::uint32_t HeldVertices::add(const glm::dvec3& point) {
  const std::uint32_t vertex = take_slot();
  slots_[vertex].number = output_.new_vertex();
  slots_[vertex].point = point;
  ++counts_.vertices;
  return vertex;
}

std::uint32_t HeldVertices::add_known(std::uint32_t number, const glm::dvec3& point) {
  const std::uint32_t vertex = take_slot();
  slots_[vertex].number = number;
  slots_[vertex].point = point;
  slots_[vertex].is_settled = true;
  return vertex;
}

void HeldVertices::place_on_line(std::uint32_t vertex, std::uint32_t from, std::uint32_t to, double fraction) {
  ++counts_.snaps;
  slots_[vertex].is_on_line = true;
  slots_[vertex].part = fraction;
  std::uint32_t missing = 0;
  for (std::uint32_t end = 0; end < 2; ++end) {
    const std::uint32_t other = end == 0 ? from : to;
    if (slots_[other].is_settled) {
      slots_[vertex].ends[end] = slots_[other].point;
    } else {
      slots_[other].waiting.push_back({vertex, end});
      ++missing;
    }
  }
  slots_[vertex].missing = missing;
  if (missing == 0) settle_on_line(vertex);
}

void HeldVertices::settle_on_line(std::uint32_t vertex) {
  Slot& slot = slots_[vertex];
  slot.point = glm::mix(slot.ends[0], slot.ends[1], slot.part);
  settle(vertex);
}

/// Fixes a position and those that depend on it. The recursion depth is the number of lines that end on one another;
/// each belongs to a larger element than the one before.
void HeldVertices::settle(std::uint32_t vertex) {
  slots_[vertex].is_settled = true;
  output_.vertex(slots_[vertex].number, slots_[vertex].point);
  for (const auto& [other, end] : std::exchange(slots_[vertex].waiting, {})) {
    slots_[other].ends[end] = slots_[vertex].point;
    if (--slots_[other].missing == 0) settle_on_line(other);
  }
  free_if_unused(vertex);
}

void HeldVertices::release_by_edge(std::uint32_t vertex) {
  if (--slots_[vertex].edges > 0) return;
  if (!slots_[vertex].is_settled && !slots_[vertex].is_on_line) {
    settle(vertex);
  } else {
    free_if_unused(vertex);
  }
}

void HeldVertices::release_by_element(std::uint32_t vertex) {
  --slots_[vertex].elements;
  free_if_unused(vertex);
}

void HeldVertices::free_if_unused(std::uint32_t vertex) {
  const Slot& slot = slots_[vertex];
  if (slot.edges > 0 || slot.elements > 0 || !slot.is_settled) return;
  free_.push_back(vertex);
  --held_;
}

}  // namespace csgsim::swept
