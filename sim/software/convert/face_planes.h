// Planes of faces without duplicates.
// Used by bodies.cpp.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "host/facet/planes.h"

namespace csgsim::software::convert {

/// A bounding ball of a solid, relative to the origin of the planes, and the maximum displacement of its faces when
/// they are merged with others; model units.
struct Footprint {
  glm::dvec3 middle{0};
  double radius = 0;
  double tolerance = 0;
};

/// The planes of faces without duplicates. As in facet::PlaneTable, coincident faces share an entry, but coincidence is
/// decided at the location of the two solids: moving a face to the plane of the other must not move any point of its
/// solid by more than the solid's tolerance. Small solids therefore keep their faces separate next to solids of any
/// size.
class FacePlanes {
 public:
  /// Planes are given in model space and stored relative to `reference` as WholePlanes holds them with that unit;
  /// `diagonal` is the size of the model.
  FacePlanes(const glm::dvec3& reference, double diagonal, double unit)
      : reference_(reference), diagonal_(diagonal), unit_(unit) {}

  /// Starts a solid; the planes added next belong to it.
  void begin(const Footprint& solid) { solids_.push_back(solid); }

  /// Adds the plane of a face of the current solid and returns the face's half-space, which refers to planes().
  /// Opposite faces of one solid share a plane only if there is nothing between them.
  facet::Halfspace add(const facet::Plane& plane);

  [[nodiscard]] const std::vector<facet::Plane>& planes() const { return planes_; }

 private:
  /// The solids that use a plane.
  struct Use {
    std::uint32_t first = 0;  ///< the solid that introduced it
    std::uint32_t last = 0;   ///< the latest solid
    bool positive = false;    ///< side of the plane in that solid
  };

  [[nodiscard]] std::optional<std::uint32_t> find(const facet::Plane& canonical, bool positive) const;
  [[nodiscard]] bool may_share(const facet::Plane& canonical, bool positive, std::uint32_t known) const;
  [[nodiscard]] facet::Key<4> key_of(const facet::Plane& plane) const;

  glm::dvec3 reference_;
  double diagonal_;
  double unit_;
  std::vector<Footprint> solids_;
  std::vector<facet::Plane> planes_;
  std::vector<Use> uses_;                                     ///< one per plane
  std::unordered_multimap<std::uint64_t, std::uint32_t> at_;  ///< planes by the hash of their key's cell
};

}  // namespace csgsim::software::convert
