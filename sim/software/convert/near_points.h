#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

namespace csgsim::software::convert {

/// A point beside a line.
struct PointAlong {
  double along = 0;  ///< where it is nearest to: 0 at the line's start, 1 at its end; 0 if these are at one place
  std::uint32_t point = 0;

  bool operator==(const PointAlong&) const = default;
  bool operator<(const PointAlong& other) const {
    return along != other.along ? along < other.along : point < other.point;
  }
};

/// Finds points beside lines, by an R-tree.
class NearPoints {
 public:
  /// Keeps a reference to the points. Only those that are `used` are found.
  NearPoints(std::span<const glm::dvec3> points, std::span<const std::uint32_t> used);
  ~NearPoints();
  NearPoints(const NearPoints&) = delete;
  NearPoints& operator=(const NearPoints&) = delete;

  /// Points other than those two that are no farther than `distance` from the line between them, in its order.
  [[nodiscard]] std::vector<PointAlong> beside(std::uint32_t from, std::uint32_t to, double distance) const;

 private:
  struct Index;

  std::span<const glm::dvec3> points_;
  double size_;  ///< of the box of those that are used
  std::unique_ptr<const Index> index_;
};

}  // namespace csgsim::software::convert
