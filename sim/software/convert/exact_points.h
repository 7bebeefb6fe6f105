// Exact intersection points of planes.
// Used by exact_outlines.h.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "sim/software/planes/whole_planes.h"

namespace csgsim::software::convert {

/// Intersection points of planes without duplicates: points that are exactly equal have one number, regardless of the
/// planes that define them.
class ExactPoints {
 public:
  /// Keeps a reference.
  explicit ExactPoints(const WholePlanes& planes) : planes_(planes) {}

  /// The number of the intersection point of these planes.
  std::uint32_t add(const Triple& planes);

  /// Keeps the points, but forgets the planes that define them, which only speeds up repeated queries.
  void forget_planes() { known_.clear(); }

  [[nodiscard]] std::span<const glm::dvec3> positions() const { return places_; }
  [[nodiscard]] const Triple& planes(std::uint32_t point) const { return triples_[point]; }
  [[nodiscard]] Meeting meeting(std::uint32_t point) const {
    const Triple& planes = triples_[point];
    return planes_.meet(planes[0], planes[1], planes[2]);
  }

 private:
  struct TripleHash {
    std::size_t operator()(const Triple& triple) const;
  };

  const WholePlanes& planes_;
  std::vector<Triple> triples_;
  std::vector<glm::dvec3> places_;
  std::unordered_map<Triple, std::uint32_t, TripleHash> known_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> at_;  ///< points by the hash of their position's cell
};

/// Those of `candidates` that lie between two points on the intersection line of two planes, sorted along the line;
/// exact.
std::vector<std::uint32_t> points_between(const WholePlanes& planes, const ExactPoints& points, std::uint32_t from,
                                          std::uint32_t to, std::array<std::uint32_t, 2> line,
                                          std::span<const std::uint32_t> candidates);

/// Relative error of a position, with respect to its largest coordinate.
inline constexpr double error_of_place = 0x1p-49;

}  // namespace csgsim::software::convert
