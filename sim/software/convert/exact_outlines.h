#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "sim/software/convert/bodies.h"
#include "sim/software/convert/exact_points.h"
#include "sim/software/convert/fragments.h"
#include "sim/software/convert/near_points.h"
#include "sim/software/convert/side.h"

namespace csgsim::software::convert {

/// What outlines of a plane are there for.
enum class Facing : std::uint8_t {
  back,   ///< the solid is before the plane
  front,  ///< the solid is behind it
  sum,    ///< of fronts, and of backs the other way: what stays is on one side only
};

/// The outlines of fragments, on exact points, and of whole bodies, on the vertices of each body. Everything is decided
/// exactly, so that they are closed.
class ExactOutlines {
 public:
  struct Plane {
    std::uint32_t plane = 0;
    Facing facing = Facing::front;
    std::vector<Side> sides;
  };

  /// Keeps a reference.
  explicit ExactOutlines(const Bodies& bodies)
      : bodies_(&bodies), points_(bodies.planes), numbers_(bodies.faces.size() + std::size_t{3} * WholePlanes::walls) {}

  /// Those of one body.
  void add(std::span<const Fragment> fragments);

  /// Called after the last fragment. Cancels sides, and ends them at the points of their outline that are on them; then
  /// those that do not run as often one way as the other, at the ends of such sides of all outlines.
  void close();

  /// Called after close(). Adds the polygons of bodies that are `whole` (side_by_side.h), each body closed in itself.
  /// In planes with faces on both sides the sum of the sides stays: where one face is against another they cancel.
  void add_whole(const std::vector<bool>& whole);

  [[nodiscard]] const std::vector<Plane>& outlines() const { return outlines_; }
  [[nodiscard]] std::size_t points() const { return vertices_.size(); }

  /// Model space; a vertex of a body where the point stands for one.
  [[nodiscard]] glm::dvec3 place(std::uint32_t point) const;
  [[nodiscard]] bool is_vertex(std::uint32_t point) const { return vertices_[point] != nullptr; }

 private:
  static constexpr std::size_t facings = 3;

  /// A side, and another plane than the outline's that it is on.
  struct PlaneSide {
    Side side{};
    std::uint32_t along = 0;
  };

  /// The line of two planes between two points, and points that may be on it.
  struct OnLine {
    Side line{};
    std::array<std::uint32_t, 2> planes{};
    std::vector<std::uint32_t> points;
  };
  using OnLines = std::unordered_map<std::uint64_t, OnLine>;  ///< by the keys of sides

  void add(const Fragment& fragment);
  [[nodiscard]] std::size_t outline_of(std::uint32_t plane, Facing facing);
  static void cancel_plane_sides(std::vector<PlaneSide>& sides);
  void end_at_points(OnLines& found);
  void find_within(std::size_t outline, OnLines& found) const;
  void find_on_open(const std::vector<Side>& open, OnLines& found) const;
  void find_beside(std::size_t outline, const PlaneSide& one, const NearPoints& near, OnLines& found) const;

  const Bodies* bodies_;
  ExactPoints points_;
  std::vector<const glm::dvec3*> vertices_;                  ///< of points that stand for one
  std::vector<std::array<std::uint32_t, facings>> numbers_;  ///< of outlines by plane and facing, from 1
  std::vector<Plane> outlines_;
  std::vector<std::vector<PlaneSide>> plane_sides_;  ///< of each outline, of fragments, until these are closed
  std::vector<std::uint32_t> fragments_;             ///< how many each outline has
  std::vector<std::uint32_t> round_;
};

}  // namespace csgsim::software::convert
