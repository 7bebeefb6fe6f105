#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/solid.h"

namespace csgsim::convex {

/// Vertices in a tree of cells, each cut in half across its longer side, to find those that a plane leaves in front.
class VertexIndex {
 public:
  /// Vertices outside of the box are found too, though not as fast.
  explicit VertexIndex(const facet::Box& box);

  /// `normal` is that of a face at the vertex, or 0: planes like that face are told apart from it fastest.
  void insert(std::uint32_t vertex, const glm::dvec3& place, const glm::dvec3& normal);
  /// One that is there, at its place.
  void remove(std::uint32_t vertex, const glm::dvec3& place);

  /// Finds those whose height above the plane is not below -near, in no order, and exactly as Plane::height() has it.
  /// Returns how many it looked at.
  std::uint64_t find(const facet::Plane& plane, double near, std::vector<std::uint32_t>& found) const;

 private:
  struct Held {
    std::uint32_t vertex = 0;
    glm::dvec3 place{};
    glm::dvec3 normal{};
  };
  struct Cell {
    facet::Box whole;         ///< what is cut in half
    facet::Box box;           ///< holds all vertices that were put in since it was empty
    glm::dvec3 normal{};      ///< of the first of these
    double highest = 0;       ///< and the most of normal . place of any
    std::uint32_t count = 0;  ///< of vertices
    std::uint32_t below = 0;  ///< the half below the middle, and after it the other one; 0: not cut
    unsigned depth = 0;
    int axis = 0;            ///< that it is cut across
    std::vector<Held> held;  ///< if it is not cut

    [[nodiscard]] double middle() const { return whole.low[axis] + (whole.high[axis] - whole.low[axis]) / 2.0; }
    /// The half that has a place.
    [[nodiscard]] std::uint32_t half_of(const glm::dvec3& place) const {
      return below + (place[axis] < middle() ? 0U : 1U);
    }
    void put(const Held& one);
    /// Whether none is as high above the plane as that, rounding included.
    [[nodiscard]] bool is_surely_below(const facet::Plane& plane, double height) const;
  };

  void divide(std::uint32_t cell);

  std::vector<Cell> cells_;
};

}  // namespace csgsim::convex
