// Exact outlines of the boundary.
// Used by boundary.cpp and outlines.h.
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

/// Side of a plane on which the solid lies.
enum class Facing : std::uint8_t {
  back,   ///< the solid is in front of the plane
  front,  ///< the solid is behind the plane
  /// Both: sides of touching front and back faces are opposite and cancel. The remaining sides are the outline of the
  /// faces with the solid on one side only.
  sum,
};

/// The outlines of fragments on exact points, and of whole bodies on their vertices. All decisions are exact, so the
/// outlines are closed.
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

  /// Adds the fragments of one body.
  void add(std::span<const Fragment> fragments);

  /// Must be called after the last fragment. Cancels opposite sides and splits sides at points of their outline that
  /// lie on them; then splits sides without a matching opposite at the ends of such sides of all outlines.
  void close();

  /// Must be called after close(). Adds the polygons of bodies that are `whole` (side_by_side.h); each is
  /// closed. In planes with faces on both sides the sum of the sides remains: touching faces cancel.
  void add_whole(const std::vector<bool>& whole);

  [[nodiscard]] const std::vector<Plane>& outlines() const { return outlines_; }
  [[nodiscard]] std::size_t point_count() const { return vertices_.size(); }

  /// Position in model space; the vertex of a body if the point represents one.
  [[nodiscard]] glm::dvec3 place(std::uint32_t point) const;
  [[nodiscard]] bool is_vertex(std::uint32_t point) const { return vertices_[point] != nullptr; }

 private:
  static constexpr std::size_t facings = 3;

  /// A side, and a second plane that contains it.
  struct PlaneSide {
    Side side{};
    std::uint32_t along = 0;
  };

  /// The intersection line of two planes between two points, and points that may lie on it.
  struct OnLine {
    Side line{};
    std::array<std::uint32_t, 2> planes{};
    std::vector<std::uint32_t> points;
  };
  using OnLines = std::unordered_map<std::uint64_t, OnLine>;  ///< by the keys of sides

  void add(const Fragment& fragment);
  [[nodiscard]] std::size_t find_or_add_outline(std::uint32_t plane, Facing facing);
  static void cancel_plane_sides(std::vector<PlaneSide>& sides);
  void split_at_points(OnLines& found);
  void find_within(std::size_t outline, OnLines& found) const;
  void find_on_open(const std::vector<Side>& open, OnLines& found) const;
  void find_beside(std::size_t outline, const PlaneSide& one, const NearPoints& near, OnLines& found) const;

  const Bodies* bodies_;
  ExactPoints points_;
  std::vector<const glm::dvec3*> vertices_;                  ///< per point, the vertex that it represents, or nullptr
  std::vector<std::array<std::uint32_t, facings>> numbers_;  ///< indices of outlines + 1, by plane and facing
  std::vector<Plane> outlines_;
  std::vector<std::vector<PlaneSide>> plane_sides_;  ///< per outline, the sides of fragments until close()
  std::vector<std::uint32_t> fragments_;             ///< number of fragments per outline
  std::vector<std::uint32_t> round_;
};

}  // namespace csgsim::software::convert
