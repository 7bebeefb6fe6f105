#include "host/convex/vertex_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace csgsim::convex {

namespace {

constexpr std::size_t most_vertices = 32;  ///< of a cell that is not cut
constexpr unsigned most_depth = 64;

/// Whether no point of the box is as high as that, rounding included.
bool is_surely_below(const facet::Box& box, const facet::Plane& plane, double height) {
  const glm::dvec3 half = (box.high - box.low) / 2.0;
  const glm::dvec3 steepness = glm::abs(plane.normal);
  const double highest = plane.height(box.low + half) + glm::dot(steepness, half);
  const double size = glm::dot(steepness, glm::max(glm::abs(box.low), glm::abs(box.high))) + std::abs(plane.offset);
  return highest + 1e-14 * size < height;
}

}  // namespace

VertexIndex::VertexIndex(const facet::Box& box) {
  cells_.emplace_back();
  cells_.front().whole = box;
}

void VertexIndex::Cell::put(const Held& one) {
  box = facet::hull(box, one.place);
  ++count;
  if (below == 0) held.push_back(one);
}

void VertexIndex::insert(std::uint32_t vertex, const glm::dvec3& place) {
  std::uint32_t cell = 0;
  for (; cells_[cell].below != 0; cell = cells_[cell].half_of(place)) cells_[cell].put({vertex, place});
  cells_[cell].put({vertex, place});
  if (cells_[cell].count > most_vertices && cells_[cell].depth < most_depth) divide(cell);
}

void VertexIndex::divide(std::uint32_t cell) {
  const auto below = static_cast<std::uint32_t>(cells_.size());
  cells_.resize(cells_.size() + 2);
  Cell& cut = cells_[cell];
  const glm::dvec3 size = cut.whole.high - cut.whole.low;
  if (size.y > size[cut.axis]) cut.axis = 1;
  if (size.z > size[cut.axis]) cut.axis = 2;
  cut.below = below;
  for (const std::uint32_t half : {below, below + 1}) {
    cells_[half].whole = cut.whole;
    cells_[half].depth = cut.depth + 1;
  }
  cells_[below].whole.high[cut.axis] = cut.middle();
  cells_[below + 1].whole.low[cut.axis] = cut.middle();
  for (const Held& one : cut.held) cells_[cut.half_of(one.place)].put(one);
  cut.held = {};
}

void VertexIndex::remove(std::uint32_t vertex, const glm::dvec3& place) {
  std::uint32_t cell = 0;
  for (; cells_[cell].below != 0; cell = cells_[cell].half_of(place)) --cells_[cell].count;
  --cells_[cell].count;
  std::vector<Held>& held = cells_[cell].held;
  *std::ranges::find(held, vertex, &Held::vertex) = held.back();
  held.pop_back();
}

std::uint64_t VertexIndex::find(const facet::Plane& plane, double near, std::vector<std::uint32_t>& found) const {
  std::uint64_t looked_at = 0;
  std::vector<std::uint32_t> left{0};
  while (!left.empty()) {
    const Cell& cell = cells_[left.back()];
    left.pop_back();
    if (cell.count == 0 || is_surely_below(cell.box, plane, -near)) continue;
    if (cell.below != 0) {
      left.insert(left.end(), {cell.below, cell.below + 1});
      continue;
    }
    looked_at += cell.count;
    for (const Held& one : cell.held)
      if (!(plane.height(one.place) < -near)) found.push_back(one.vertex);
  }
  return looked_at;
}

}  // namespace csgsim::convex
