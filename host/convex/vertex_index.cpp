#include "host/convex/vertex_index.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace csgsim::convex {

namespace {

constexpr std::size_t max_cell_vertices = 16;  ///< maximum number of vertices in an undivided cell
constexpr unsigned max_cell_depth = 64;

}  // namespace

VertexIndex::VertexIndex(const facet::Box& box) {
  cells_.emplace_back();
  cells_.front().whole = box;
}

void VertexIndex::Cell::put(const IndexedVertex& entry) {
  if (count == 0) {
    box = {entry.place, entry.place};
    normal = entry.normal;
    highest = glm::dot(normal, entry.place);
  } else {
    box = facet::hull(box, entry.place);
    highest = std::max(highest, glm::dot(normal, entry.place));
  }
  ++count;
  if (below == 0) held.push_back(entry);
}

bool VertexIndex::Cell::is_surely_below(const facet::Plane& plane, double height) const {
  const glm::dvec3 half = (box.high - box.low) / 2.0;
  const glm::dvec3 middle = box.low + half;
  const glm::dvec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
  const glm::dvec3 ones(1.0);
  const double doubt = 1e-13 * (glm::dot(ones, reach) + std::abs(plane.offset));
  // Along the cell's own normal all vertices are below `highest`. The remaining component of the plane's normal is
  // small if the plane nearly contains a face there.
  const double along = glm::dot(plane.normal, normal);
  if (along > 0.0) {
    const glm::dvec3 rest = plane.normal - along * normal;
    const double most = along * highest + glm::dot(rest, middle) + glm::dot(glm::abs(rest), half) + plane.offset;
    if (most + doubt < height) return true;
  }
  return plane.height(middle) + glm::dot(glm::abs(plane.normal), half) + doubt < height;
}

void VertexIndex::insert(std::uint32_t vertex, const glm::dvec3& position, const glm::dvec3& normal) {
  const IndexedVertex held{vertex, position, normal};
  std::uint32_t cell = 0;
  for (; cells_[cell].below != 0; cell = cells_[cell].half_at(position)) cells_[cell].put(held);
  cells_[cell].put(held);
  if (cells_[cell].count > max_cell_vertices && cells_[cell].depth < max_cell_depth) divide(cell);
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
  for (const IndexedVertex& one : cut.held) cells_[cut.half_at(one.place)].put(one);
  cut.held = {};
}

void VertexIndex::remove(std::uint32_t vertex, const glm::dvec3& position) {
  std::uint32_t cell = 0;
  for (; cells_[cell].below != 0; cell = cells_[cell].half_at(position)) --cells_[cell].count;
  --cells_[cell].count;
  std::vector<IndexedVertex>& held = cells_[cell].held;
  *std::ranges::find(held, vertex, &IndexedVertex::vertex) = held.back();
  held.pop_back();
}

std::uint64_t VertexIndex::find(const facet::Plane& plane, double tolerance, std::vector<std::uint32_t>& found) const {
  std::uint64_t visited = 0;
  std::vector<std::uint32_t> left{0};
  while (!left.empty()) {
    const Cell& cell = cells_[left.back()];
    left.pop_back();
    if (cell.count == 0 || cell.is_surely_below(plane, -tolerance)) continue;
    if (cell.below != 0) {
      left.insert(left.end(), {cell.below, cell.below + 1});
      continue;
    }
    visited += cell.count;
    for (const IndexedVertex& one : cell.held)
      if (!(plane.height(one.place) < -tolerance)) found.push_back(one.vertex);
  }
  return visited;
}

}  // namespace csgsim::convex
