// Table of a model's distinct quadrics.
// Used by curved.h, geometry.h, solid.h, host/view and sim/judges.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "host/facet/coincidence.h"

namespace csgsim::facet {

enum class QuadricKind : std::uint8_t {
  ellipsoid,  ///< about its centre
  cylinder,   ///< about its axis
  cone,       ///< both nappes, about its apex
};

/// The quadric u.x^2 + u.y^2 + signs()[2] u.z^2 + level() <= 0 for u = to_unit (p - origin): the unit ball, the unit
/// cylinder or the unit cone. Written with one symmetric matrix it is (p - origin)^T form (p - origin) + level() <= 0;
/// the matrix is less accurate if the quadric is thin relative to its length.
struct Quadric {
  QuadricKind kind = QuadricKind::ellipsoid;
  /// The centre, the point of the axis nearest to QuadricTable::centre(), or the apex; relative to
  /// QuadricTable::centre().
  glm::dvec3 origin{0};
  /// Unit axis of a cylinder or cone (for a cone, the principal axis of its matrix); the first nonzero component is
  /// positive.
  glm::dvec3 axis{0, 0, 1};
  /// xx, yy, zz, xy, xz, yz of the symmetric matrix; for a cone scaled so that the largest magnitude is 1.
  std::array<double, 6> form{};
  std::array<glm::dvec3, 3> to_unit{};  ///< rows of a matrix; the last row is 0 for a cylinder

  [[nodiscard]] double level() const { return kind == QuadricKind::cone ? 0.0 : -1.0; }
  [[nodiscard]] std::array<double, 3> signs() const {
    if (kind == QuadricKind::cone) return {1, 1, -1};
    return {1, 1, kind == QuadricKind::cylinder ? 0.0 : 1.0};
  }
};

/// A canonical quadric that bounds a solid. The solid is inside the quadric and between the planes of its half-spaces.
struct QuadricSide {
  std::uint32_t quadric = 0;  ///< index into QuadricTable::quadrics()
  bool along_axis = true;     ///< cones: the solid is on the nappe into which the axis points; otherwise true

  bool operator==(const QuadricSide&) const = default;
};

/// The quadrics of a model without duplicates. Quadrics that coincide share an entry, regardless of their primitives,
/// so values computed from them are exactly equal. The first of several coincident quadrics represents all of them.
/// Quadrics coincide if their surfaces are closer than `coincidence_tolerance` (coincidence.h) times the model's
/// diagonal.
class QuadricTable {
 public:
  QuadricTable() = default;
  /// `centre` and `diagonal` are those of the PlaneTable.
  QuadricTable(const glm::dvec3& centre, double diagonal);

  /// Adds a quadric given by its kind, `to_unit`, and origin in model space. For a cylinder, the origin may be any
  /// point of the axis. For a cone, `inward` is a direction in model space from the apex into the nappe of the solid.
  /// Returns the canonical quadric.
  QuadricSide add(const Quadric& quadric, const glm::dvec3& inward);

  /// Canonical quadrics; their origins are relative to `centre()`.
  [[nodiscard]] const std::vector<Quadric>& quadrics() const { return quadrics_; }
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }

 private:
  using Known = Key<13>;

  [[nodiscard]] Known make_key(const Quadric& canonical) const;
  [[nodiscard]] std::optional<std::uint32_t> find(const Known& key, QuadricKind kind) const;

  glm::dvec3 centre_{0};
  double diagonal_ = 1;
  std::vector<Quadric> quadrics_;
  std::vector<Known> keys_;                                           ///< key of each quadric
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> at_;  ///< quadrics by the hash of their keys' cells
};

}  // namespace csgsim::facet
