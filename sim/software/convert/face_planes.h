#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "host/facet/planes.h"

namespace csgsim::software::convert {

/// A ball that holds a solid, relative to the place that planes are relative to, and how far a face of the solid may
/// move there to coincide with another; model units.
struct Footprint {
  glm::dvec3 middle{0};
  double radius = 0;
  double tolerance = 0;
};

/// The planes of faces without repetition. As in facet::PlaneTable, faces that coincide share an entry, but what
/// coincides is decided where the two solids are: moving either face to the plane of the other moves nothing of its
/// solid by more than that solid's tolerance. So small solids keep their faces apart beside solids of any size.
class FacePlanes {
 public:
  /// Planes are given in model space and kept relative to `reference`, as WholePlanes holds them with that unit;
  /// `diagonal` is the size of the model.
  FacePlanes(const glm::dvec3& reference, double diagonal, double unit)
      : reference_(reference), diagonal_(diagonal), unit_(unit) {}

  /// The planes that follow are those of one solid.
  void begin(const Footprint& solid) { solids_.push_back(solid); }

  /// Opposite faces of one solid share a plane only if there is nothing between them.
  facet::Halfspace add(const facet::Plane& plane);

  [[nodiscard]] const std::vector<facet::Plane>& planes() const { return planes_; }

 private:
  /// Which solids a plane was used for.
  struct Use {
    std::uint32_t first = 0;  ///< the solid that it comes from
    std::uint32_t last = 0;   ///< the latest one
    bool positive = false;    ///< its side there
  };

  [[nodiscard]] std::optional<std::uint32_t> find(const facet::Plane& canonical, bool positive) const;
  [[nodiscard]] bool may_share(const facet::Plane& canonical, bool positive, std::uint32_t known) const;
  [[nodiscard]] facet::Key<4> key_of(const facet::Plane& plane) const;

  glm::dvec3 reference_;
  double diagonal_;
  double unit_;
  std::vector<Footprint> solids_;
  std::vector<facet::Plane> planes_;
  std::vector<Use> uses_;                                     ///< of each plane
  std::unordered_multimap<std::uint64_t, std::uint32_t> at_;  ///< planes by the hash of their key's cell
};

}  // namespace csgsim::software::convert
