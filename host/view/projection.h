// The view of a model: planes, quadrics and extents as one camera sees them.
// Used by host/csg, host/effects, host/emit, host/setup and sim.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
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

inline constexpr unsigned min_z_bits = 4;
inline constexpr unsigned max_z_bits = 30;
inline constexpr unsigned max_fraction_bits = 20;

/// How the picture is sampled.
struct Sampling {
  std::uint32_t width = 512;    ///< pixels
  std::uint32_t height = 512;   ///< pixels
  unsigned z_bits = 20;         ///< bits of the depth field
  unsigned fraction_bits = 12;  ///< fraction bits of the coefficients of surfaces, below one depth step
  /// In pixels: a plane that moves sideways by less than this over the depth range becomes an edge test.
  double edge_on_fraction = 1.0 / 256;
  std::optional<double> near;  ///< distance of the near plane in a perspective view, model units
  glm::dvec2 offset{0};        ///< columns and rows from a pixel's centre to its sample

  bool operator==(const Sampling&) const = default;
};

/// Converts a linear function of columns and rows to a function of sample positions.
RealLinear as_sampled(const RealLinear& linear, const Sampling& sampling);

/// Fraction bits of an edge test, whose unit is about one pixel. Edge tests have more fraction bits than surfaces,
/// because an error in them moves the edge directly.
constexpr unsigned edge_fraction_bits(const Sampling& sampling) { return sampling.fraction_bits + 8; }

/// The kind of a canonical plane in the picture.
enum class PlaneKind : std::uint8_t {
  surface,  ///< z = (Ax + By + C) >> fraction_bits, floor
  edge,     ///< edge-on plane: Ax + By + C >= 0 is one side of it
};

/// A canonical plane in the picture: all half-spaces on it have the same integers.
struct ScreenPlane {
  PlaneKind kind = PlaneKind::surface;
  FixedLinear linear;
  /// For a surface: whether the positive half-space (normal . p + offset <= 0) is the side away from the eye. For an
  /// edge: whether the positive half-space is where Ax + By + C >= 0; otherwise it is where this is < 0.
  bool positive = true;
  /// Whether the coefficients fit; if not, the plane may be used only where it decides nothing.
  bool representable = true;
  /// The plane before rounding, to find whether it decides anything where it is not representable.
  RealLinear real;
};

enum class Side : std::uint8_t {
  front,          ///< inside is z >= F
  back,           ///< inside is z < F
  edge_positive,  ///< inside is Ax + By + C >= 0
  edge_negative,  ///< inside is Ax + By + C < 0
};

Side side_of(const ScreenPlane& plane, bool positive);
Side side_of(const ScreenPlane& plane, facet::Halfspace halfspace);

/// The pixels and depths that a primitive can touch, including the rounding of its planes. By definition a primitive is
/// absent outside its rectangle of pixels, regardless of its rounded planes there; depths and box follow from the
/// planes and the rectangle.
struct Extent {
  PixelRect pixels;
  std::int64_t z_low = 0;   ///< minimum depth step of its surface; at least 0
  std::int64_t z_high = 0;  ///< maximum depth step; at most 2^n - 1
  facet::Box box;           ///< model space; infinite if no bound is known

  bool cut_by_near = false;  ///< whether the near plane cuts the solid open

  /// Rounding moves the surface towards a plane by less than this part of the farthest distance of a corner from the
  /// plane. Infinite if no bound is known.
  double looseness = std::numeric_limits<double>::infinity();

  /// Corners of a solid that contains the primitive: columns, rows, depth steps. Empty if no bound is known.
  std::vector<glm::dvec3> corners;

  [[nodiscard]] bool empty() const { return pixels.empty() || z_low > z_high; }
};

/// A model as one camera sees it.
struct View {
  Camera camera;
  Sampling sampling;
  isa::DepthScale depth;
  std::vector<ScreenPlane> planes;        ///< one per canonical plane
  std::vector<Extent> extents;            ///< one per primitive
  double depth_step = 0;                  ///< largest distance of one depth step, in model units
  std::vector<ScreenQuadric> quadrics{};  ///< one per canonical quadric
};

/// The mapping between model space, eye space and picture for a camera; columns and rows count from the sample of the
/// first pixel. Throws InputError for an invalid camera.
EyeSpace eye_space(const Camera& camera, const Sampling& sampling);

/// A plane of model space in a view, in the form of `View::planes`. Its positive half-space is normal . p + offset <=
/// 0, where the offset is relative to PlaneTable::centre(), here `centre`.
ScreenPlane screen_plane(const View& view, const facet::Plane& plane, const glm::dvec3& centre);

/// Transforms planes and extents into the view. Throws InputError for an invalid camera or sampling.
///
/// In perspective, the near plane is at the nearest point of the model, but not nearer than far / 256 unless
/// `sampling.near` is set; solids that reach nearer are capped there. Orthographic views also show what is behind the
/// eye, as OpenSCAD does.
View make_view(const facet::Geometry& geometry, const model::Tree& tree, const Camera& camera,
               const Sampling& sampling);

}  // namespace csgsim::view
