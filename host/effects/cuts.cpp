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

constexpr double most_spacing = 256;

void visit_keys(Cut& cut, auto&& visit) {
  visit(scene::vector_key("normal", "", "points to the side that is taken away"), cut.normal);
  visit(scene::vector_key("point", "model units", "a point of the plane"), cut.point);
  visit(scene::colour_key("colour", "of the section; the usual one of what is cut, if not given"), cut.colour);
  visit(scene::number_key("hatch", "pixels", 0, most_spacing,
                          "from one line of the hatching to the next, 4 at least; 0: none"),
        cut.hatch);
  visit(scene::number_key("angle", "degrees", -180, 180, "of the lines, from the picture's columns"), cut.angle);
  visit(scene::colour_key("hatch_colour", "of the lines"), cut.hatch_colour);
}

constexpr double least_spacing = 4;

void complete(const Cut& cut) {
  if (glm::length(cut.normal) == 0) throw InputError("a cut has a normal; add normal = [x, y, z], not all 0");
  if (cut.hatch > 0 && cut.hatch < least_spacing) {
    throw InputError(fmt::format("lines {:g} pixels apart run together; take hatch = {:g} or more, or 0 for none",
                                 cut.hatch, least_spacing));
  }
}

/// A cube that holds what is left of anything within `reach` of the plane's point: its upper face is the plane.
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

/// 2^bits units of a hatching's linear expression are from one line to the next: across 2^14 pixels lines are off by
/// 1/128 of that at most.
constexpr unsigned period_bits = 20;

/// Lines whose width is a quarter of their distance: E stays 1 on them.
void emit_lines(emit::Broadcast& out, const Cut& cut, const glm::dvec2& offset) {
  const double turn = cut.angle * std::numbers::pi / 180;
  const auto coefficient = [&](double part) { return view::to_fixed(part / cut.hatch, period_bits).value_or(0); };
  const view::FixedLinear across{coefficient(-std::sin(turn)), coefficient(std::cos(turn)),
                                 coefficient(std::cos(turn) * offset.y - std::sin(turn) * offset.x)};
  // The upper half of a period, and of that what is in the upper half of the same moved on by a quarter.
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
    out.plain(isa::Opcode::set_constant, field, {}, emit::packed(cut.hatch_colour, context.options.colour_bits));
    return true;
  }
};

}  // namespace

extern const emit::EffectRow cuts{
    .section = scene::effect_section<std::vector<Cut>>(
        "effects.cuts", "cutting planes: what is before them is taken away, what they cut is capped"),
    .technique =
        "each plane is one more half-space that intersects the model, so that caps and the holes in them follow "
        "from the tree; hatching is a linear expression of which all but the low bits are cut off",
    .parts = emit::parts_of<Cuts>};

}  // namespace csgsim::effects
