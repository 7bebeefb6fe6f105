#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/effects/blend.h"
#include "host/effects/reflection.h"
#include "host/effects/rows.h"
#include "host/emit/early_out.h"
#include "host/emit/facet_geometry.h"
#include "host/emit/surface.h"
#include "hw/base/error.h"
#include "hw/isa/field_role.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using emit::FieldRequest;
using isa::Field;
using isa::Opcode;

constexpr std::string_view effect = "mirrors";
constexpr std::string_view without = "use --set effects.mirrors.on=false";
constexpr unsigned max_depth = 4;
/// Maximum number of mirrors in a picture; a mirror counts once for each time it is visible, also in mirrors.
constexpr std::size_t max_mirrors = 256;

struct Settings {
  unsigned depth = 1;
};

void visit_keys(Settings& settings, auto&& visit) {
  visit(scene::integer_key("depth", "", 1, max_depth, "maximum depth of mirrors seen in mirrors"), settings.depth);
}

/// A mirroring face.
struct Face {
  std::uint32_t primitive;
  facet::Halfspace halfspace;
};

/// Faces in one plane, and the drawing of the picture that they reflect.
struct Mirror {
  std::vector<Face> faces;
  unsigned reflectance = 0;  ///< in 1/256, from 1 to 256
  std::shared_ptr<const emit::Drawing> drawing;
  view::FixedLinear plane;  ///< plane of the mirror in the drawing
};

struct PreparedMirrors : emit::EffectState {
  std::vector<Mirror> mirrors;
  unsigned level = 0;          ///< number of mirrors between the eye and the drawing
  std::uint32_t surfaces = 0;  ///< maximum number of surfaces in a segment of the drawing
};

bool is_flat(const emit::Drawing& drawing, const Face& face) {
  return emit::is_flat(drawing.tree->primitives[face.primitive],
                       drawing.geometry->planes.planes()[face.halfspace.plane].normal);
}

/// Reflectance in 1/256.
unsigned scaled_reflectance(const lighting::Finish& finish) {
  if (finish.opacity < 1) return 0;
  return static_cast<unsigned>(view::to_fixed(finish.material.mirror, weight_bits).value_or(0));
}

/// Whether the face is turned to the eye and not seen edge-on.
bool is_seen(const emit::Drawing& drawing, const Face& face) {
  const view::ScreenPlane& plane = drawing.view.planes[face.halfspace.plane];
  const csg::PositiveTree& positive = drawing.plan.positive;
  const bool is_cut = positive.nodes[positive.leaf_of[face.primitive]].complemented;
  return plane.kind == view::PlaneKind::surface && plane.representable &&
         view::side_of(plane, face.halfspace) == (is_cut ? view::Side::back : view::Side::front);
}

std::vector<Face> mirroring_faces(const emit::Drawing& drawing, std::uint32_t primitive) {
  std::vector<Face> faces;
  for (const facet::Halfspace& halfspace : drawing.geometry->solids[primitive].halfspaces) {
    const Face face{primitive, halfspace};
    if (is_seen(drawing, face) && is_flat(drawing, face)) faces.push_back(face);
  }
  return faces;
}

/// The pixels that may show one of the primitives of the faces.
view::PixelRect face_pixels(const emit::Drawing& drawing, const std::vector<Face>& faces) {
  view::PixelRect pixels;
  for (const emit::SegmentPlan& segment : drawing.plan.segments) {
    for (const emit::PlannedSurface& one : segment.surfaces) {
      const bool shows = std::any_of(faces.begin(), faces.end(), [&](const Face& face) {
        return std::find(one.set.begin(), one.set.end(), face.primitive) != one.set.end();
      });
      if (shows) pixels = pixels.empty() ? one.block.pixels : view::hull(pixels, one.block.pixels);
    }
  }
  return drawing.reflection && !pixels.empty() ? view::common(pixels, drawing.reflection->pixels) : pixels;
}

/// The mirrors of a drawing: faces in the same plane with the same reflectance form one.
std::vector<Mirror> find_mirrors(const emit::Drawing& drawing) {
  std::vector<Mirror> mirrors;
  for (std::uint32_t i = 0; i < drawing.look.finishes.size(); ++i) {
    const unsigned reflectance = scaled_reflectance(drawing.look.finishes[i]);
    if (reflectance == 0) continue;
    for (const Face& face : mirroring_faces(drawing, i)) {
      const auto same = [&](const Mirror& one) {
        return one.reflectance == reflectance && one.faces.front().halfspace.plane == face.halfspace.plane;
      };
      const auto found = std::find_if(mirrors.begin(), mirrors.end(), same);
      if (found != mirrors.end()) {
        found->faces.push_back(face);
      } else {
        mirrors.push_back({{face}, reflectance, nullptr, {}});
      }
    }
  }
  std::erase_if(mirrors, [&](const Mirror& one) { return face_pixels(drawing, one.faces).empty(); });
  return mirrors;
}

/// Makes the drawing of the mirror's reflection. Returns false if the mirror is seen nearly edge-on and shows nothing.
bool draw_reflection(Mirror& mirror, const emit::Drawing& drawing, const emit::DrawingInputs& inputs) {
  const std::uint32_t plane = mirror.faces.front().halfspace.plane;
  const Reflected reflected_model = reflected(*drawing.tree, *drawing.geometry, plane);
  const std::uint32_t image = reflected_model.of_planes[plane].plane;
  view::View view =
      view::make_view(*reflected_model.geometry, *reflected_model.tree, drawing.view.camera, drawing.view.sampling);
  const view::ScreenPlane seen = view.planes[image];
  if (seen.kind != view::PlaneKind::surface || !seen.representable) return false;
  const unsigned count = drawing.reflection ? drawing.reflection->count + 1 : 1;
  mirror.plane = seen.linear;
  mirror.drawing = emit::make_drawing(
      reflected_model.tree, reflected_model.geometry, std::move(view), drawing.nesting + 1, inputs,
      emit::Reflection{count, image, face_pixels(drawing, mirror.faces),
                       reflected(drawing.look.lighting, *drawing.geometry, plane, drawing.view.camera)});
  return true;
}

std::string numbered(std::string_view name, unsigned level) { return std::string(name) + std::to_string(level); }

/// Emits the reflection of one mirror.
class MirrorEmitter {
 public:
  MirrorEmitter(const emit::Context& context, emit::Broadcast& out, const Mirror& mirror, unsigned level)
      : context_(context),
        out_(out),
        mirror_(mirror),
        depth_(field("depth", level)),
        colour_(field("colour", level)),
        owner_(field("owner", level)),
        flag_(field("flag", level)) {}

  void run() {
    if (!flag_faces()) return;
    const std::size_t begin = out_.size();
    draw();
    out_.origin = emit::effect_origin;
    out_.plain(Opcode::enable_load, flag_);
    emit_blend(out_, context_.layout.colour, colour_, mirror_.reflectance, context_.layout.of(effect, "product"));
    emit_early_out(context_, out_, begin, emit::effect_origin);
  }

 private:
  [[nodiscard]] Field field(std::string_view name, unsigned level) const {
    return context_.layout.of(effect, numbered(name, level));
  }

  /// E and flag := 1 where one of the faces is visible. Returns false, without appending instructions, if none is
  /// visible anywhere.
  bool flag_faces() {
    bool is_first = true;
    for (const emit::PlannedSurface& planned : context_.plan.surfaces) {
      if (!has_face(planned)) continue;
      const emit::Surface surface = emit::plan_surface(context_, planned, emit::deciding_sides(context_, planned));
      for (const emit::Facet& facet : surface.facets) {
        if (surface.nothing || !is_face(facet) || &facet != &first_in_plane(surface, facet)) continue;
        out_.origin = {isa::Purpose::effect, facet.primitive, isa::no_node};
        flag_facet(planned, surface, facet);
        if (!is_first) out_.plain(Opcode::enable_or, flag_);
        out_.plain(Opcode::enable_store, flag_);
        is_first = false;
      }
    }
    return !is_first;
  }

  [[nodiscard]] bool has_face(const emit::PlannedSurface& planned) const {
    return std::any_of(mirror_.faces.begin(), mirror_.faces.end(), [&](const Face& face) {
      return std::find(planned.set.begin(), planned.set.end(), face.primitive) != planned.set.end();
    });
  }

  [[nodiscard]] bool is_face(const emit::Facet& facet) const {
    return facet.at == emit::At::plane &&
           std::any_of(mirror_.faces.begin(), mirror_.faces.end(), [&](const Face& face) {
             return face.primitive == facet.primitive && face.halfspace == facet.halfspace;
           });
  }

  /// The first facet of the surface in the same plane, which owns the pixels where facets of several solids coincide.
  static const emit::Facet& first_in_plane(const emit::Surface& surface, const emit::Facet& facet) {
    return *std::find_if(surface.facets.begin(), surface.facets.end(), [&](const emit::Facet& one) {
      return one.at == emit::At::plane && one.halfspace.plane == facet.halfspace.plane;
    });
  }

  /// E := 1 where the facet is visible.
  void flag_facet(const emit::PlannedSurface& planned, const emit::Surface& surface, const emit::Facet& facet) {
    emit::enable_drawing(context_, out_);
    out_.equals(context_.layout.owner, planned.number);
    if (surface.facets.size() > 1)
      out_.surface(Opcode::linear_eq, context_.layout.depth, facet_plane(context_, facet), surface.block.pixels);
  }

  void draw() {
    emit::Layout layout = context_.layout;
    layout.depth = depth_;
    layout.colour = colour_;
    layout.owner = owner_;
    emit::Context inner = with_layout(context_for(*mirror_.drawing, context_), layout);
    inner.base = flag_;
    inner.beyond_plane = &mirror_.plane;
    emit_drawing(inner, out_);
  }

  const emit::Context& context_;
  emit::Broadcast& out_;
  const Mirror& mirror_;
  Field depth_;   ///< depth of the reflection
  Field colour_;  ///< colour of the reflection
  Field owner_;   ///< owner of the reflection
  Field flag_;    ///< 1 where the mirror is visible
};

class Mirrors final : public emit::EffectOf<Settings, PreparedMirrors> {
 public:
  [[nodiscard]] bool is_implied_by(const emit::Look& look) const override {
    return std::any_of(look.finishes.begin(), look.finishes.end(),
                       [](const lighting::Finish& one) { return scaled_reflectance(one) > 0; });
  }

  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& drawing,
                                                       const emit::DrawingInputs& inputs) const override {
    using isa::FieldRole;
    unsigned levels = 0;
    std::uint32_t surfaces = 1;
    for (const State* const one : all_prepared(drawing, inputs)) {
      levels = std::max(levels, one->level);
      surfaces = std::max(surfaces, one->surfaces);
    }
    std::vector<FieldRequest> all;
    for (unsigned level = 1; level <= levels; ++level) {
      all.push_back({numbered("depth", level), FieldRole::effect, drawing.view.sampling.z_bits, "depth", without});
      all.push_back({numbered("colour", level), FieldRole::effect, inputs.options.colour_bits, "colour", without});
      all.push_back({numbered("owner", level), FieldRole::effect, static_cast<unsigned>(std::bit_width(surfaces)),
                     "owner", without});
      all.push_back({numbered("flag", level), FieldRole::effect, 1, "mirror", without});
    }
    if (levels > 0) all.push_back({"product", FieldRole::scratch, 2 * weight_bits, "product", without, true});
    return all;
  }

  void compose(const emit::EffectCall& call, emit::Broadcast& out) const override {
    const State& ready = prepared(call);
    for (const Mirror& mirror : ready.mirrors) MirrorEmitter(call.context, out, mirror, ready.level + 1).run();
  }

 private:
  void prepare(State& state, const emit::Drawing& drawing, const emit::DrawingInputs& inputs) const override {
    state.level = drawing.reflection ? drawing.reflection->count : 0;
    for (const emit::SegmentPlan& segment : drawing.plan.segments)
      for (const emit::PlannedSurface& one : segment.surfaces) state.surfaces = std::max(state.surfaces, one.number);
    const unsigned depth = settings.depth;
    std::size_t all = 0;
    for (Mirror& mirror : state.level < depth ? find_mirrors(drawing) : std::vector<Mirror>()) {
      if (!draw_reflection(mirror, drawing, inputs)) continue;
      all += emit::with_inner_drawings(*mirror.drawing).size();
      if (all > max_mirrors) {
        throw InputError(fmt::format(
            "more than {} reflections must be drawn, counting those inside reflections; {}", max_mirrors,
            depth > 1 ? "use --set effects.mirrors.depth=1, or make fewer faces mirrors" : "make fewer faces mirrors"));
      }
      state.drawings.push_back(mirror.drawing);
      state.mirrors.push_back(std::move(mirror));
    }
  }
};

}  // namespace

extern const emit::EffectRow mirrors{
    .section = scene::effect_section<Settings>(
        "effects.mirrors",
        "flat faces of materials with mirror above 0 (those of cubes and polyhedra, the ends of cylinders; no "
        "curved sides, nothing transparent) show what is in front of them"),
    .technique =
        "the model is reflected in the face's plane, and the part behind the plane is drawn where the face is visible "
        "(Diefenbach and Badler 1997, with a flag bit and depth fields in place of the stencil)",
    .parts = emit::parts_of<Mirrors>,
    .needs_owners = true};

}  // namespace csgsim::effects
