#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "host/effects/rows.h"
#include "host/emit/facet_colour.h"
#include "host/facet/geometry.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

struct Cut {
  glm::dvec3 normal{0};
  glm::dvec3 point{0};
  std::optional<glm::dvec3> colour;
  glm::dvec3 hatch_colour{0};
  double hatch = 0;
  double angle = 45;
};

constexpr double max_spacing = 256;

void visit_keys(Cut& cut, auto&& visit) {
  visit(scene::vector_key("normal", "", "points to the side that is removed"), cut.normal);
  visit(scene::vector_key("point", "model units", "a point on the plane"), cut.point);
  visit(scene::colour_key("colour", "colour of the section; by default that of the solid that is cut"), cut.colour);
  visit(scene::number_key("hatch", "pixels", 0, max_spacing,
                          "distance between hatching lines, at least 4; 0: no hatching"),
        cut.hatch);
  visit(scene::number_key("angle", "degrees", -180, 180, "angle of the lines to the picture's columns"), cut.angle);
  visit(scene::colour_key("hatch_colour", "colour of the lines"), cut.hatch_colour);
}

constexpr double min_spacing = 4;

void complete(const Cut& cut) {
  if (glm::length(cut.normal) == 0) throw InputError("a cut needs a normal; add normal = [x, y, z], not all 0");
  if (cut.hatch > 0 && cut.hatch < min_spacing) {
    throw InputError(fmt::format("lines {:g} pixels apart merge; set hatch to {:g} or more, or to 0 for no hatching",
                                 cut.hatch, min_spacing));
  }
}

/// A cube that contains the part on the kept side of everything within `reach` of the plane's point; its upper face is
/// in the plane.
model::Primitive kept_side(const Cut& cut, std::uint32_t number, double reach) {
  const glm::dvec3 up = glm::normalize(cut.normal);
  const glm::dvec3 side = std::abs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(side, up));
  const glm::dvec3 ahead = glm::cross(up, right);
  const glm::dvec3 corner = cut.point - reach * (right + ahead + up * 2.0);
  model::Primitive primitive;
  primitive.shape = model::Cube{glm::dvec3(2 * reach)};
  primitive.transform =
      glm::dmat4(glm::dvec4(right, 0), glm::dvec4(ahead, 0), glm::dvec4(up, 0), glm::dvec4(corner, 1));
  primitive.colour = cut.colour.value_or(lighting::default_cut_colour);
  primitive.section = number;
  return primitive;
}

/// The distance between lines is 2^bits units of the hatching's linear expression. Across 2^14 pixels, the lines
/// deviate by at most 1/128 of this distance.
constexpr unsigned period_bits = 20;

/// Leaves E at 1 on the lines, whose width is a quarter of their distance.
void emit_lines(emit::Broadcast& out, const Cut& cut, const glm::dvec2& offset) {
  const double turn = cut.angle * std::numbers::pi / 180;
  const auto coefficient = [&](double part) { return view::to_fixed(part / cut.hatch, period_bits).value_or(0); };
  const view::FixedLinear across{coefficient(-std::sin(turn)), coefficient(std::cos(turn)),
                                 coefficient(std::cos(turn) * offset.y - std::sin(turn) * offset.x)};
  // The lines are the upper half of a period, intersected with the upper half of the same pattern shifted by a quarter.
  out.stripe(across, period_bits);
  out.stripe({across.a, across.b, across.c + (std::int64_t{1} << (period_bits - 2))}, period_bits);
}

class Cuts final : public emit::EffectOf<std::vector<Cut>> {
 public:
  model::Tree reshape(model::Tree&& tree) const override {
    if (tree.root == model::no_index) return std::move(tree);
    const facet::Box box = facet::make_geometry(tree).box;
    if (box.empty()) return std::move(tree);
    model::Node all;
    all.op = model::Operator::intersect;
    all.children.push_back(tree.root);
    for (std::uint32_t i = 0; i < settings.size(); ++i) {
      const double reach = 2 * (box.diagonal() + glm::length(settings[i].point - box.centre()));
      all.children.push_back(model::add_leaf(tree, kept_side(settings[i], i, reach)));
    }
    tree.root = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.push_back(std::move(all));
    return std::move(tree);
  }

  bool shade(const emit::EffectCall& call, emit::Broadcast& out, const emit::Facet& facet, isa::Field field,
             const view::PixelRect& /*pixels*/) const override {
    const emit::Context& context = call.context;
    const std::uint32_t section = context.tree.primitives[facet.primitive].section;
    if (section == model::no_index) return false;
    out.plain(isa::Opcode::set_constant, field, {}, emit::facet_colour(context, facet));
    const Cut& cut = settings.at(section);
    if (cut.hatch == 0) return true;
    emit_lines(out, cut, context.view.sampling.offset);
    out.plain(isa::Opcode::set_constant, field, {}, emit::packed_colour(cut.hatch_colour, context.options.colour_bits));
    return true;
  }
};

}  // namespace

extern const emit::EffectRow cuts{
    .section = scene::effect_section<std::vector<Cut>>(
        "effects.cuts",
        "cutting planes: everything on the side that `normal` points to is removed, and the cut solids are capped"),
    .technique =
        "each plane is one more half-space that intersects the model, so that the caps and their holes follow "
        "from the tree; hatching uses only the low bits of a linear expression",
    .parts = emit::parts_of<Cuts>};

}  // namespace csgsim::effects
