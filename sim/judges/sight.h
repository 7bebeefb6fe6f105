#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host/facet/geometry.h"
#include "host/view/camera.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/program.h"
#include "sim/judges/exact_camera.h"
#include "sim/judges/quadric_sight.h"

namespace csgsim::judges {

/// What the positive half-space of a plane is along the rays of the picture.
enum class Role : std::uint8_t {
  front,  ///< all that lies behind the plane
  back,   ///< all that lies before it
  edge,   ///< whole rays: the plane is seen edge-on exactly
};

/// A plane's depth along the rays, approximately: c + a x + b y, off by `error` at most at any place of the picture.
/// For an edge it is a multiple of the value of the plane's equation instead, which is negative in the positive
/// half-space.
struct SightPlane {
  double c = 0;
  double a = 0;
  double b = 0;
  double error = 0;
  /// How often the rounding of doubles is magnified in these coefficients if they are worked out in doubles: the sizes
  /// of the terms of their common denominator over the denominator.
  double condition = 1;
  Role role = Role::edge;

  [[nodiscard]] double at(Place place) const { return c + a * place.x + b * place.y; }
};

/// The canonical planes and quadrics of a model as a camera (host/view/camera.h) sees them, in exact numbers
/// (exact_camera.h). The planes' doubles are taken as they are.
///
/// The depth of planes is linear over the picture: q = t in an orthographic view and q = -1/t in perspective, where t
/// counts lengths of v along the axis from the eye. Greater q is farther.
///
/// Not to be used by several threads at a time: exact numbers are worked out when first asked for, and kept.
class Sight {
 public:
  Sight(const facet::Geometry& geometry, const view::Camera& camera, std::uint32_t width, std::uint32_t height,
        const isa::DepthScale& depth);
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  [[nodiscard]] const SightPlane& plane(std::uint32_t index) const { return planes_[index]; }

  /// Stands for the near plane of a perspective view, as a plane that faces forward; after all canonical planes.
  [[nodiscard]] std::uint32_t near_plane() const { return static_cast<std::uint32_t>(planes_.size()) - 2; }

  /// Stands for what is infinitely far in a perspective view, as a plane that faces away. Behind it lies, turned round,
  /// what is behind the eye: bounded solids without planes need it.
  [[nodiscard]] std::uint32_t horizon() const { return near_plane() + 1; }

  [[nodiscard]] const QuadricSight& quadrics() const { return quadrics_; }

  /// The index that it has in a Truth.
  [[nodiscard]] std::uint32_t surface(Sheet sheet) const {
    if (sheet.root == Root::only) return sheet.index;
    return near_plane() + 1 + 2 * sheet.index + (sheet.root == Root::farther ? 1 : 0);
  }

  /// The quadric's sheet of that index, which is above the near plane's.
  [[nodiscard]] Sheet quadric_sheet(std::uint32_t surface) const {
    const std::uint32_t after = surface - near_plane() - 1;
    return {after / 2, after % 2 == 0 ? Root::nearer : Root::farther};
  }

  [[nodiscard]] const ExactCamera& camera() const { return camera_; }

  [[nodiscard]] bool perspective() const { return camera_.perspective; }

  /// |centre - eye|, model units.
  [[nodiscard]] double axis_length() const { return unit_; }

  /// Sign of the depth of plane `first` minus that of `second`, exact. Neither may be an edge.
  /// A face in the near plane lies behind it: it is not cut.
  [[nodiscard]] int compare(std::uint32_t first, std::uint32_t second, Place place) const {
    if (first == second) return 0;
    const SightPlane& a = planes_[first];
    const SightPlane& b = planes_[second];
    const double difference = a.at(place) - b.at(place);
    if (std::abs(difference) > 2.0 * (a.error + b.error)) return difference > 0.0 ? 1 : -1;
    return compare_exactly(first, second, place);
  }

  /// The same of any two sheets; the quadrics have to have those depths there.
  [[nodiscard]] int compare(Sheet first, Sheet second, Place place) const {
    if (first.root == Root::only && second.root == Root::only) return compare(first.index, second.index, place);
    return compare_with_roots(first, second, place);
  }

  /// Whether the positive half-space of an edge holds the ray, exact. A ray in the plane belongs where it goes when it
  /// is moved right, and down by less, by less than anything.
  [[nodiscard]] bool edge_holds(std::uint32_t index, Place place) const;

  /// Distance from the eye along the axis, model units, of the sheet; off by some 2^-45 of it.
  [[nodiscard]] double distance(Sheet sheet, Place place) const;

 private:
  /// q = l / k; an edge has k = 0.
  struct Exact {
    ExactLinear l;
    Dyadic k;
  };

  [[nodiscard]] Exact make_exact(std::uint32_t index) const;
  [[nodiscard]] const Exact& exact(std::uint32_t index) const;
  [[nodiscard]] SightPlane make_filter(std::uint32_t index) const;
  [[nodiscard]] double denominator_size(std::uint32_t index) const;

  [[nodiscard]] int compare_exactly(std::uint32_t first, std::uint32_t second, Place place) const;
  [[nodiscard]] int compare_with_roots(Sheet first, Sheet second, Place place) const;
  [[nodiscard]] Estimate estimate(Sheet sheet, Place place) const;
  [[nodiscard]] Surd exactly_at(Sheet sheet, Place place) const;

  const facet::PlaneTable& table_;
  ExactCamera camera_;
  Vector from_middle_;  ///< eye - PlaneTable::centre()
  QuadricSight quadrics_;
  double unit_ = 0;  ///< |v|
  std::vector<SightPlane> planes_;
  mutable std::unordered_map<std::uint32_t, Exact> kept_;
};

}  // namespace csgsim::judges
