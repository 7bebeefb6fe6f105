#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::facet {

enum class QuadricKind : std::uint8_t {
  ellipsoid,  ///< about its centre
  cylinder,   ///< about its axis
  cone,       ///< both nappes, about its apex
};

/// The quadric (p - origin)^T form (p - origin) + level() <= 0.
struct Quadric {
  QuadricKind kind = QuadricKind::ellipsoid;
  glm::dvec3 origin{0};          ///< centre; the point of the axis nearest to QuadricTable::centre(); apex. Relative to
                                 ///< QuadricTable::centre()
  glm::dvec3 axis{0, 0, 1};      ///< of cylinders and cones, of length 1; its first component that is not 0 is positive
  std::array<double, 6> form{};  ///< xx, yy, zz, xy, xz, yz of a symmetric matrix; of a cone the greatest has size 1

  [[nodiscard]] double level() const { return kind == QuadricKind::cone ? 0.0 : -1.0; }
};

/// A canonical quadric that bounds a solid, which is in the quadric and between the planes of its half-spaces.
struct QuadricSide {
  std::uint32_t quadric = 0;  ///< index into QuadricTable::quadrics()
  bool along_axis = true;     ///< of a cone: the solid is on the nappe that its axis points into

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

  /// The canonical quadric of one in model space, whose origin is relative to the model's.
  QuadricSide add(Quadric quadric, bool along_axis);

  /// Canonical quadrics, their origins relative to `centre()`.
  [[nodiscard]] const std::vector<Quadric>& quadrics() const { return quadrics_; }
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }

 private:
  glm::dvec3 centre_{0};
  double diagonal_ = 1;
  std::vector<Quadric> quadrics_;
};

}  // namespace csgsim::facet
