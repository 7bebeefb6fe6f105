#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host/facet/scene.h"
#include "host/view/camera.h"
#include "hw/isa/program.h"
#include "sim/judges/dyadic.h"

namespace csgsim::judges {

/// A pixel centre: twice its distance from the middle of the picture, in pixels, to the right and down. Integers.
struct Place {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

/// The centre of the pixel in that column and row.
constexpr Place place_of(std::uint32_t column, std::uint32_t row, std::uint32_t width, std::uint32_t height) {
  return {2 * static_cast<std::int32_t>(column) - (static_cast<std::int32_t>(width) - 1),
          2 * static_cast<std::int32_t>(row) - (static_cast<std::int32_t>(height) - 1)};
}

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

/// The canonical planes of a scene as a camera (host/view/camera.h) sees them, in exact numbers.
///
/// The planes' doubles are taken as they are. The camera's direction v = centre - eye, r = v x up and u = r x v are
/// exact too, and not normalised, so that what is perpendicular or parallel to them is so exactly. Only two lengths are
/// irrational, pixel / |r| and pixel / |u|; they are taken to 100 digits.
///
/// Depth is linear over the picture: q = t in an orthographic view and q = -1/t in perspective, where t counts lengths
/// of v along the axis from the eye. Greater q is farther.
///
/// Not to be used by several threads at a time: exact numbers are worked out when first asked for, and kept.
class Sight {
 public:
  Sight(const facet::PlaneTable& planes, const view::Camera& camera, std::uint32_t width, std::uint32_t height,
        const isa::DepthScale& depth);

  [[nodiscard]] const SightPlane& plane(std::uint32_t index) const { return planes_[index]; }

  /// Stands for the near plane of a perspective view, as a plane that faces forward; after all canonical planes.
  [[nodiscard]] std::uint32_t near_plane() const { return static_cast<std::uint32_t>(planes_.size()) - 1; }

  [[nodiscard]] bool perspective() const { return perspective_; }

  /// |centre - eye|, model units.
  [[nodiscard]] double axis_length() const { return unit_; }

  /// Sign of the depth of plane `first` minus that of `second`, exact. Neither may be an edge.
  /// A face in the near plane lies behind it: it is not cut.
  [[nodiscard]] int compare(std::uint32_t first, std::uint32_t second, Place place) const;

  /// Whether the positive half-space of an edge holds the ray, exact. A ray in the plane belongs where it goes when it
  /// is moved right, and down by less, by less than anything.
  [[nodiscard]] bool edge_holds(std::uint32_t index, Place place) const;

  /// Distance from the eye along the axis, model units, of the plane; off by some 2^-48 of it.
  [[nodiscard]] double distance(std::uint32_t index, Place place) const;

 private:
  /// q = (l0 + lx x + ly y) / k; an edge has k = 0.
  struct Exact {
    Dyadic l0, lx, ly, k;

    [[nodiscard]] Dyadic numerator(Place place) const;
  };

  [[nodiscard]] Exact make_exact(std::uint32_t index) const;
  [[nodiscard]] const Exact& exact(std::uint32_t index) const;
  [[nodiscard]] SightPlane make_filter(std::uint32_t index) const;
  [[nodiscard]] double denominator_size(std::uint32_t index) const;

  const facet::PlaneTable& table_;
  bool perspective_;
  double width_;
  double height_;
  Vector from_middle_;  ///< eye - PlaneTable::centre()
  Vector right_;        ///< r
  Vector up_;           ///< u
  Vector forward_;      ///< v
  Dyadic right_step_;   ///< half a pixel in lengths of r
  Dyadic up_step_;      ///< half a pixel in lengths of u
  Dyadic axis_length_;  ///< |v|
  Dyadic near_;
  double unit_ = 0;  ///< |v|
  std::vector<SightPlane> planes_;
  mutable std::unordered_map<std::uint32_t, Exact> kept_;
};

}  // namespace csgsim::judges
