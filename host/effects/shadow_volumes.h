#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/convex/shadow_volume.h"
#include "host/emit/drawing.h"
#include "host/view/projection.h"
#include "hw/base/work.h"

namespace csgsim::effects {

/// A half-space of a shadow volume as a view has it, compared with the depth of what is seen.
///
/// Planes of faces that face the light are strict: a point at the plane's own depth, as every point of the face is, is
/// out, so that no face throws a shadow on itself. Planes through edges and the light, and those of faces that light
/// runs along, are half-open, as a solid's own are: of volumes on either side of one each point is in just one.
struct ShadowPlane {
  view::Side side = view::Side::front;
  bool is_strict = false;  ///< of a front: in is z > F. Backs and edges are as view::Side says
  view::FixedLinear linear;

  bool operator==(const ShadowPlane& other) const {
    return side == other.side && is_strict == other.is_strict && linear.a == other.linear.a &&
           linear.b == other.linear.b && linear.c == other.linear.c;
  }
};

/// Where a convex piece of the model takes a light away: the intersection of the half-spaces, everything if there are
/// none.
struct SeenVolume {
  std::vector<ShadowPlane> planes;
  std::uint32_t primitive = 0;  ///< that the piece is of
};

/// A light that throws shadows.
struct ShadowLight {
  std::size_t light = 0;  ///< index into Lighting::lights
  std::vector<SeenVolume> volumes;
};

/// Primitives, by the lines of the model's file; all, if no line is said.
struct Casters {
  std::optional<std::uint32_t> from_line;
  std::optional<std::uint32_t> to_line;  ///< inclusive
};

/// Where a convex piece of the model takes a light away, in model space.
struct ThrownVolume {
  convex::ShadowVolume volume;
  std::uint32_t primitive = 0;  ///< that the piece is of
};

/// The volumes of a light, however pixels are sampled.
struct ThrownLight {
  std::size_t light = 0;  ///< index into Lighting::lights
  std::vector<ThrownVolume> volumes;
};

/// The volumes of the lights with those numbers, of the pieces that are of the casters. Throws WorkError past the limit
/// on work.
std::vector<ThrownLight> thrown_by(const std::vector<std::size_t>& lights, const emit::Drawing& drawing,
                                   const Casters& casters, const Work& work);

/// The same as the drawing has them. Throws InputError, naming the primitive, where a plane's coefficients do not fit
/// the machine.
std::vector<ShadowLight> seen_in(const emit::Drawing& drawing, const std::vector<ThrownLight>& lights);

}  // namespace csgsim::effects
