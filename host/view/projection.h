#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/eye_space.h"
#include "host/view/fixed_point.h"
#include "host/view/screen_quadric.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/program.h"

namespace csgsim::view {

inline constexpr unsigned fewest_z_bits = 4;
inline constexpr unsigned most_z_bits = 30;
inline constexpr unsigned most_fraction_bits = 20;

/// How the picture is sampled.
struct Sampling {
  std::uint32_t width = 512;            ///< pixels
  std::uint32_t height = 512;           ///< pixels
  unsigned z_bits = 20;                 ///< of the depth field
  unsigned fraction_bits = 12;          ///< of the coefficients of surfaces, below one depth step
  double edge_on_fraction = 1.0 / 256;  ///< of a pixel: steeper planes become edge tests
  std::optional<double> near;           ///< distance of the near plane in a perspective view, model units
  glm::dvec2 offset{0};                 ///< columns and rows from a pixel's centre to where it is sampled

  bool operator==(const Sampling&) const = default;
};

/// A linear function of the picture's columns and rows, as the pixels sample it.
RealLinear as_sampled(const RealLinear& linear, const Sampling& sampling);

/// Fraction bits of an edge test, whose unit is about one pixel: finer than those of surfaces, since no slope magnifies
/// it.
constexpr unsigned edge_fraction_bits(const Sampling& sampling) { return sampling.fraction_bits + 8; }

/// What a canonical plane is in the picture.
enum class PlaneKind : std::uint8_t {
  surface,  ///< z = (Ax + By + C) >> fraction_bits, floor
  edge,     ///< edge-on: Ax + By + C >= 0 is one side of it
};

/// A canonical plane in the picture: the same integers for every half-space that lies on it.
struct ScreenPlane {
  PlaneKind kind = PlaneKind::surface;
  FixedLinear linear;
  /// Surface: the positive half-space (normal . p + offset <= 0) is the side away from the eye, that is, faces forward.
  /// Edge: the positive half-space is where Ax + By + C >= 0; else where it is < 0.
  bool positive = true;
  bool representable = true;  ///< the coefficients fit; if not, the plane may only be used where it decides nothing
  RealLinear real;            ///< the plane before rounding, to decide it where it is not representable
};

enum class Side : std::uint8_t {
  front,          ///< in is z >= F
  back,           ///< in is z < F
  edge_positive,  ///< in is Ax + By + C >= 0
  edge_negative,  ///< in is Ax + By + C < 0
};

Side side_of(const ScreenPlane& plane, bool positive);
Side side_of(const ScreenPlane& plane, facet::Halfspace halfspace);

/// What a primitive can touch, rounding of its planes included. By rule a primitive is nowhere outside its rectangle of
/// pixels, whatever its rounded planes say there; the depths and the box follow from the planes and the rectangle.
struct Extent {
  PixelRect pixels;
  std::int64_t z_low = 0;   ///< depth steps of its surface; at least 0
  std::int64_t z_high = 0;  ///< at most 2^n - 1
  facet::Box box;           ///< model space; infinite where no bound is known

  bool cut_by_near = false;  ///< the near plane cuts the solid open

  /// Corners of a solid that holds it: columns, rows, depth steps. Empty where no bound is known.
  std::vector<glm::dvec3> corners;

  [[nodiscard]] bool empty() const { return pixels.empty() || z_low > z_high; }
};

/// A model as one camera sees it.
struct View {
  Camera camera;
  Sampling sampling;
  isa::DepthScale depth;
  std::vector<ScreenPlane> planes;        ///< one a canonical plane
  std::vector<Extent> extents;            ///< one a primitive
  double depth_step = 0;                  ///< model units of a depth step where it is coarsest
  std::vector<ScreenQuadric> quadrics{};  ///< one a canonical quadric
};

/// Model space, eye space and picture of a camera, the picture's columns and rows counted from where the first pixel is
/// sampled. Throws InputError for a camera that cannot be.
EyeSpace eye_space(const Camera& camera, const Sampling& sampling);

/// A plane of model space in a view, as canonical planes are in `View::planes`; its offset is relative to
/// PlaneTable::centre(). Of a half-space normal . p + offset <= 0 it is the positive side.
ScreenPlane screen_plane(const View& view, const facet::Plane& plane, const glm::dvec3& centre);

/// Transforms planes and extents. Throws InputError for a camera or sampling that cannot be.
///
/// Perspective: near is at the nearest point of the model, but no nearer than far / 256 unless `sampling.near` says so;
/// solids that reach nearer are capped there. Orthographic views show what lies behind the eye too, as OpenSCAD does.
View make_view(const facet::Geometry& geometry, const model::Tree& tree, const Camera& camera,
               const Sampling& sampling);

}  // namespace csgsim::view
