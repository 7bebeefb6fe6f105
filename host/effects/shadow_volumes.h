// Shadow volumes of the model's convex pieces.
// Used by the shadow effect.
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

/// A half-space of a shadow volume in a view, to be compared with the depth of the visible surface.
///
/// Planes of faces that face the light are strict: a point at the plane's own depth, such as every point of the face,
/// is outside, so that no face casts a shadow on itself. Planes through edges and the light, and those of faces
/// parallel to the light, are half-open, like those of a solid: each point is in exactly one of two adjacent volumes.
struct ShadowPlane {
  view::Side side = view::Side::front;
  bool is_strict = false;  ///< for a front: inside is z > F instead of z >= F; backs and edges are as in view::Side
  view::FixedLinear linear;

  bool operator==(const ShadowPlane& other) const {
    return side == other.side && is_strict == other.is_strict && linear.a == other.linear.a &&
           linear.b == other.linear.b && linear.c == other.linear.c;
  }
};

/// The region in which a convex piece of the model blocks a light, in a view: the intersection of the half-spaces; if
/// there are none, the whole space.
struct ShadowVolumeInView {
  std::vector<ShadowPlane> planes;
  std::uint32_t primitive = 0;  ///< primitive of the piece
};

/// A light that casts shadows.
struct ShadowLight {
  std::size_t light = 0;  ///< index into Lighting::lights
  std::vector<ShadowVolumeInView> volumes;
};

/// The primitives that cast shadows, as a range of lines of the model's file; all primitives if from_line is empty.
struct Casters {
  std::optional<std::uint32_t> from_line;
  std::optional<std::uint32_t> to_line;  ///< the last line of the range
};

/// The region in which a convex piece of the model blocks a light, in model space.
struct CastVolume {
  convex::ShadowVolume volume;
  std::uint32_t primitive = 0;  ///< primitive of the piece
};

/// The shadow volumes of a light, independent of the sample positions.
struct CastLight {
  std::size_t light = 0;  ///< index into Lighting::lights
  std::vector<CastVolume> volumes;
};

/// The volumes of the given lights, for the pieces of the casters. Throws WorkError if the work limit is exceeded.
std::vector<CastLight> cast_volumes(const std::vector<std::size_t>& lights, const emit::Drawing& drawing,
                                    const Casters& casters, const Work& work);

/// The shadow volumes in the drawing's view. Throws InputError, naming the primitive, if a plane's coefficients do not
/// fit the machine.
std::vector<ShadowLight> volumes_in_view(const emit::Drawing& drawing, const std::vector<CastLight>& lights);

}  // namespace csgsim::effects
