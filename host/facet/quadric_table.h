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

/// The quadric u.x^2 + u.y^2 + signs()[2] u.z^2 + level() <= 0 of u = to_unit (p - origin): the unit ball, the unit
/// cylinder or the unit cone. As one symmetric matrix it is (p - origin)^T form (p - origin) + level() <= 0; the matrix
/// is less exact where a quadric is thin against its length.
struct Quadric {
  QuadricKind kind = QuadricKind::ellipsoid;
  glm::dvec3 origin{0};      ///< centre; the point of the axis nearest to QuadricTable::centre(); apex. Relative to
                             ///< QuadricTable::centre()
  glm::dvec3 axis{0, 0, 1};  ///< of cylinders and cones, of length 1; its first component that is not 0 is positive.
                             ///< In a cone it is the principal axis, whatever the cone was made from
  std::array<double, 6> form{};  ///< xx, yy, zz, xy, xz, yz of a symmetric matrix; of a cone the greatest has size 1
  std::array<glm::dvec3, 3> to_unit{};  ///< rows of a matrix; the last is 0 of a cylinder

  [[nodiscard]] double level() const { return kind == QuadricKind::cone ? 0.0 : -1.0; }
  [[nodiscard]] std::array<double, 3> signs() const {
    if (kind == QuadricKind::cone) return {1, 1, -1};
    return {1, 1, kind == QuadricKind::cylinder ? 0.0 : 1.0};
  }
};

/// A canonical quadric that bounds a solid, which is in the quadric and between the planes of its half-spaces.
struct QuadricSide {
  std::uint32_t quadric = 0;  ///< index into QuadricTable::quadrics()
  bool along_axis = true;     ///< of a cone: the solid is on the nappe that its axis points into; else true

  bool operator==(const QuadricSide&) const = default;
};

/// The quadrics of a model without repetition: those that coincide share an entry, whichever primitive they come from,
/// so that whatever is computed from them is equal exactly. The first seen of a kind stands for all. Quadrics coincide
/// if their surfaces are closer than `coincidence_tolerance` (planes.h) of the model's diagonal.
class QuadricTable {
 public:
  QuadricTable() = default;
  /// `centre` and `diagonal` as those of the PlaneTable.
  QuadricTable(const glm::dvec3& centre, double diagonal);

  /// The canonical quadric of one whose kind, `to_unit` and origin, relative to the model's, are given: of a cylinder
  /// any point of the axis. `inward`: of a cone, a direction in model space from the apex into the nappe that is meant.
  QuadricSide add(const Quadric& quadric, const glm::dvec3& inward);

  /// Canonical quadrics, their origins relative to `centre()`.
  [[nodiscard]] const std::vector<Quadric>& quadrics() const { return quadrics_; }
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }

 private:
  using Known = Key<13>;

  [[nodiscard]] Known key_of(const Quadric& canonical) const;
  [[nodiscard]] std::optional<std::uint32_t> find(const Known& key, QuadricKind kind) const;

  glm::dvec3 centre_{0};
  double diagonal_ = 1;
  std::vector<Quadric> quadrics_;
  std::vector<Known> keys_;                                           ///< one a quadric
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> at_;  ///< quadrics by the hash of their keys' cells
};

}  // namespace csgsim::facet
