#include "host/effects/shadow_volumes.h"

#include <fmt/format.h>

#include <utility>

#include "host/convex/clip.h"
#include "host/convex/pieces.h"
#include "host/convex/shadow_volume.h"
#include "host/csg/locate.h"
#include "host/view/camera.h"
#include "hw/base/error.h"

namespace csgsim::effects {

namespace {

convex::Light in_model(const lighting::CameraSpaceLight& light, const view::Camera& camera) {
  const view::Basis axes = view::basis(camera);
  const glm::dvec3 turned = axes.right * light.where.x + axes.up * light.where.y + axes.forward * light.where.z;
  return light.is_point ? convex::Light{{camera.eye + turned, 1}} : convex::Light{{turned, 0}};
}

/// Collects half-spaces until one of them contains no point of the picture.
class Volume {
 public:
  Volume(const emit::Drawing& drawing, std::uint32_t primitive)
      : drawing_(drawing),
        picture_{{0, 0, static_cast<std::int32_t>(drawing.view.sampling.width) - 1,
                  static_cast<std::int32_t>(drawing.view.sampling.height) - 1},
                 0,
                 (std::int64_t{1} << drawing.view.sampling.z_bits) - 1} {
    volume_.primitive = primitive;
  }

  void add(const view::ScreenPlane& plane, bool positive, bool faces_light) {
    if (!plane.representable && !decides(plane, positive)) return;
    const view::Side side = view::side_of(plane, positive);
    volume_.planes.push_back({side, faces_light && side == view::Side::front, plane.linear});
  }

  /// The volume; empty if it contains no point of the picture.
  [[nodiscard]] std::optional<ShadowVolumeInView> take() {
    return is_empty_ ? std::nullopt : std::optional(std::move(volume_));
  }

 private:
  /// Whether the result depends on the plane. If it does and the plane's coefficients do not fit, throws InputError.
  bool decides(const view::ScreenPlane& plane, bool positive) {
    const csg::Containment known = csg::locate(drawing_.view, plane, positive, picture_);
    if (known == csg::Containment::depends) {
      throw InputError(fmt::format(
          "{}: a plane of this primitive's shadow is too large for the picture: its coefficients do not fit {} "
          "bits; move the camera back, lower --z-bits or --fraction-bits, or turn the light a little",
          model::location_text(*drawing_.tree, volume_.primitive), isa::max_linear_width));
    }
    is_empty_ = is_empty_ || known == csg::Containment::out;
    return false;
  }

  const emit::Drawing& drawing_;
  csg::Block picture_;
  ShadowVolumeInView volume_;
  bool is_empty_ = false;
};

std::optional<ShadowVolumeInView> seen_volume(const emit::Drawing& drawing, const convex::ShadowVolume& volume,
                                              std::uint32_t primitive) {
  const view::View& view = drawing.view;
  Volume result(drawing, primitive);
  for (const facet::Plane& plane : volume.silhouette)
    result.add(view::screen_plane(view, plane, drawing.geometry->planes.centre()), true, false);
  for (const facet::Halfspace& one : volume.edge_on) result.add(view.planes[one.plane], one.positive, false);
  for (const facet::Halfspace& one : volume.facing) result.add(view.planes[one.plane], one.positive, true);
  return result.take();
}

bool is_caster(const model::Primitive& primitive, const Casters& casters) {
  const std::uint32_t line = primitive.location.line;
  return !casters.from_line || (line >= *casters.from_line && line <= casters.to_line.value_or(*casters.from_line));
}

}  // namespace

std::vector<CastLight> cast_volumes(const std::vector<std::size_t>& lights, const emit::Drawing& drawing,
                                    const Casters& casters, const Work& work) {
  const std::vector<convex::Piece> pieces =
      convex::pieces(*drawing.geometry, drawing.plan.positive, convex::max_pieces, work);
  std::vector<CastLight> result;
  for (const std::size_t light : lights) {
    CastLight one{light, {}};
    const convex::Light from = in_model(drawing.look.lighting.lights[light], drawing.view.camera);
    for (const convex::Piece& piece : pieces) {
      if (!is_caster(drawing.tree->primitives[piece.primitive], casters)) continue;
      work.charge(convex::clip_steps(piece.polytope), "finding what is in shadow");
      one.volumes.push_back({convex::shadow_volume(piece.polytope, from, drawing.geometry->planes), piece.primitive});
    }
    result.push_back(std::move(one));
  }
  return result;
}

std::vector<ShadowLight> volumes_in_view(const emit::Drawing& drawing, const std::vector<CastLight>& lights) {
  std::vector<ShadowLight> result;
  for (const CastLight& light : lights) {
    ShadowLight one{light.light, {}};
    for (const CastVolume& cast_lights : light.volumes) {
      if (auto found = seen_volume(drawing, cast_lights.volume, cast_lights.primitive))
        one.volumes.push_back(*std::move(found));
    }
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace csgsim::effects
