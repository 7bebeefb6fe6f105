// The planes and quadrics of a model along a camera's rays, with exact comparisons.
// Used by the judges and sim/studies/accuracy.
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

/// The relation of a plane's positive half-space to the rays of the picture.
enum class Role : std::uint8_t {
  front,  ///< everything behind the plane
  back,   ///< everything in front of the plane
  edge,   ///< whole rays: the plane is seen exactly edge-on
};

/// A plane's approximate depth along the rays: c + a x + b y, with an error of at most `error` at any place of the
/// picture. For an edge, c + a x + b y is instead a positive multiple of normal . p + offset, so it is at most 0 in the
/// positive half-space.
struct SightPlane {
  double c = 0;
  double a = 0;
  double b = 0;
  double error = 0;
  /// Amplification of the rounding of doubles in these coefficients, if they are computed in doubles: the magnitudes of
  /// the terms of their common denominator divided by the denominator.
  double condition = 1;
  Role role = Role::edge;

  [[nodiscard]] double at(Place place) const { return c + a * place.x + b * place.y; }
};

/// The canonical planes and quadrics of a model as a camera (host/view/camera.h) sees them, in exact numbers
/// (exact_camera.h). The planes' doubles are taken as exact.
///
/// The depth of planes is linear over the picture: q = t in an orthographic view and q = -1/t in perspective, where t
/// counts lengths of v along the axis from the eye. Greater q is farther.
///
/// Not thread-safe: exact numbers are computed on first use and cached.
class Sight {
 public:
  Sight(const facet::Geometry& geometry, const view::Camera& camera, std::uint32_t width, std::uint32_t height,
        const isa::DepthScale& depth);
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  [[nodiscard]] const SightPlane& plane(std::uint32_t index) const { return planes_[index]; }

  /// Index of the near plane of a perspective view, as a plane that faces forward; after all canonical planes.
  [[nodiscard]] std::uint32_t near_plane() const { return static_cast<std::uint32_t>(planes_.size()) - 2; }

  /// Index of the plane at infinity in a perspective view, which faces away. Points behind the eye count as behind this
  /// plane; it bounds solids that have no planes.
  [[nodiscard]] std::uint32_t horizon() const { return near_plane() + 1; }

  [[nodiscard]] const QuadricSight& quadrics() const { return quadrics_; }

  /// The sheet's index in a Truth.
  [[nodiscard]] std::uint32_t surface(Sheet sheet) const {
    if (sheet.root == Root::only) return sheet.index;
    return near_plane() + 1 + 2 * sheet.index + (sheet.root == Root::farther ? 1 : 0);
  }

  /// The sheet of the quadric with that index, which is above the near plane's.
  [[nodiscard]] Sheet quadric_sheet(std::uint32_t surface) const {
    const std::uint32_t after = surface - near_plane() - 1;
    return {after / 2, after % 2 == 0 ? Root::nearer : Root::farther};
  }

  [[nodiscard]] const ExactCamera& camera() const { return camera_; }

  [[nodiscard]] bool is_perspective() const { return camera_.is_perspective; }

  /// |centre - eye|, model units.
  [[nodiscard]] double axis_length() const { return unit_; }

  /// Exact sign of the depth of plane `first` minus that of `second`. Neither may be an edge. A face that lies in the
  /// near plane counts as behind the near plane, so that it is not cut.
  [[nodiscard]] int compare(std::uint32_t first, std::uint32_t second, Place place) const {
    if (first == second) return 0;
    const SightPlane& a = planes_[first];
    const SightPlane& b = planes_[second];
    const double difference = a.at(place) - b.at(place);
    if (std::abs(difference) > 2.0 * (a.error + b.error)) return difference > 0.0 ? 1 : -1;
    return compare_exactly(first, second, place);
  }

  /// Exact sign of the depth of sheet `first` minus that of `second`. Quadrics must have these depths at the place.
  [[nodiscard]] int compare(Sheet first, Sheet second, Place place) const {
    if (first.root == Root::only && second.root == Root::only) return compare(first.index, second.index, place);
    return compare_with_roots(first, second, place);
  }

  /// Whether the positive half-space of an edge contains the ray, exact. A ray in the plane belongs to the side that it
  /// reaches when moved infinitesimally to the right, and infinitesimally less downwards.
  [[nodiscard]] bool edge_contains_ray(std::uint32_t index, Place place) const;

  /// Distance of the sheet from the eye along the axis, model units; relative error about 2^-45.
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
  [[nodiscard]] Estimate estimate_depth(Sheet sheet, Place place) const;
  [[nodiscard]] Surd exact_depth(Sheet sheet, Place place) const;

  const facet::PlaneTable& table_;
  ExactCamera camera_;
  Vector from_middle_;  ///< eye - PlaneTable::centre()
  QuadricSight quadrics_;
  double unit_ = 0;  ///< |v|
  std::vector<SightPlane> planes_;
  mutable std::unordered_map<std::uint32_t, Exact> kept_;
};

}  // namespace csgsim::judges
