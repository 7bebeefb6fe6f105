#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "host/effects/rows.h"
#include "host/emit/facet_geometry.h"
#include "host/model/shapes.h"
#include "hw/isa/field_role.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;

enum class Between : std::uint8_t { facets, primitives };

constexpr std::array<std::string_view, 2> between_names{"facets", "primitives"};

struct EdgeSettings {
  glm::dvec3 colour{0};
  Between between = Between::facets;
  double crease = 35;
};

void visit_keys(EdgeSettings& settings, auto&& visit) {
  visit(scene::colour_key("colour", "colour of the lines"), settings.colour);
  visit(scene::choice_key("between", between_names, "the parts whose edges are drawn"), settings.between);
  visit(scene::number_key("crease", "degrees", 0, 180,
                          "facets of a sphere or of a cylinder's side that meet at a smaller angle count as one"),
        settings.crease);
}

/// A number for each half-space of a primitive, and one for its other parts. Facets without an edge between them have
/// the same number.
struct Numbers : emit::EffectState {
  std::vector<std::vector<std::uint32_t>> of_halfspaces;  ///< per primitive, the number of each half-space
  std::vector<std::uint32_t> of_primitives;
  std::uint32_t most = 0;

  [[nodiscard]] unsigned bits() const { return static_cast<unsigned>(std::bit_width(most)); }
};

std::vector<bool> find_curved(const model::Primitive& primitive, const facet::Convex& solid,
                              const facet::PlaneTable& planes, double crease) {
  std::vector<bool> curved;
  for (const facet::Halfspace& halfspace : solid.halfspaces)
    curved.push_back(!emit::is_flat(primitive, planes.planes()[halfspace.plane].normal));
  const auto count = static_cast<std::size_t>(std::count(curved.begin(), curved.end(), true));
  const bool is_smooth = count > 0 && model::facet_angle(primitive.shape, count) * 180 / std::numbers::pi < crease;
  if (!is_smooth) curved.assign(curved.size(), false);
  return curved;
}

/// Number 0 is the background.
void number(Numbers& numbers, const model::Tree& tree, const facet::Geometry& scene, const EdgeSettings& settings) {
  for (std::size_t i = 0; i < tree.primitives.size(); ++i) {
    const facet::Convex& solid = scene.solids[i];
    const std::uint32_t whole = ++numbers.most;
    numbers.of_primitives.push_back(whole);
    std::vector<std::uint32_t>& own = numbers.of_halfspaces.emplace_back(solid.halfspaces.size(), whole);
    if (settings.between == Between::primitives) continue;
    const std::vector<bool> curved = find_curved(tree.primitives[i], solid, scene.planes, settings.crease);
    for (std::size_t h = 0; h < own.size(); ++h)
      if (!curved[h]) own[h] = ++numbers.most;
  }
}

/// Indices into the drawings of an EffectState.
enum : std::size_t { here, right, below };

constexpr std::array<glm::dvec2, 3> places{{{0, 0}, {1, 0}, {0, 1}}};

/// Draws into the field the numbers of the facets that are visible in a drawing.
void draw_numbers(const emit::Context& outer, emit::Broadcast& out, const Numbers& numbers,
                  const emit::Drawing& drawing, isa::Field field) {
  const emit::Paint paint = [&](const emit::Facet& facet) {
    if (facet.at == emit::At::cap) return numbers.of_primitives[facet.primitive];
    const std::vector<facet::Halfspace>& all = drawing.geometry->solids[facet.primitive].halfspaces;
    const auto found = std::find_if(all.begin(), all.end(), [&](const facet::Halfspace& one) {
      return one.plane == facet.halfspace.plane && one.positive == facet.halfspace.positive;
    });
    return numbers.of_halfspaces[facet.primitive].at(static_cast<std::size_t>(found - all.begin()));
  };
  emit::Layout layout = outer.layout;
  layout.depth = layout.of("edges", "depth");
  layout.colour = field;
  layout.candidate_colour = {};
  layout.owner = {};
  const emit::Context elsewhere = emit::with_layout(outer, layout);
  emit::Context context = emit::context_for(drawing, elsewhere);
  context.called = {};
  context.paint = &paint;
  out.origin = {isa::Purpose::setup, isa::no_primitive, isa::no_node};
  emit::enable_drawing(context, out);
  out.plain(Opcode::set_constant, layout.depth, {}, static_cast<std::uint64_t>(context.farthest()));
  out.plain(Opcode::set_constant, field, {}, 0);
  emit::emit_surfaces(context, out);
}

class Edges final : public emit::EffectOf<EdgeSettings, Numbers> {
 public:
  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& drawing,
                                                       const emit::DrawingInputs& inputs) const override {
    const unsigned bits = all_prepared(drawing, inputs).front()->bits();
    const auto request = [](std::string_view name, unsigned width, std::string_view what) {
      return emit::FieldRequest{std::string(name), isa::FieldRole::effect, width, what,
                                "use --set effects.edges.on=false"};
    };
    return {request("here", bits, "number of a facet"), request("there", bits, "number of a facet"),
            request("depth", drawing.view.sampling.z_bits, "depth of a neighbour"), request("line", 1, "edge")};
  }

  void finish(const emit::EffectCall& call, emit::Broadcast& out) const override {
    const emit::Context& context = call.context;
    const isa::Field own = context.layout.of("edges", "here");
    const isa::Field other = context.layout.of("edges", "there");
    const isa::Field line = context.layout.of("edges", "line");
    const auto plain = [&](Opcode opcode, isa::Field first = {}, isa::Field second = {}, std::uint64_t constant = 0) {
      out.origin = emit::effect_origin;
      out.plain(opcode, first, second, constant);
    };
    draw_numbers(context, out, prepared(call), *call.state.drawings[here], own);
    plain(Opcode::enable_all);
    plain(Opcode::set_constant, line, {}, 0);
    for (const std::size_t neighbour : {right, below}) {
      draw_numbers(context, out, prepared(call), *call.state.drawings[neighbour], other);
      plain(Opcode::enable_all);
      plain(Opcode::field_eq, own, other);
      plain(Opcode::enable_invert);
      plain(Opcode::enable_or, line);
      plain(Opcode::enable_store, line);
    }
    if (context.base.width > 0) plain(Opcode::enable_and, context.base);
    plain(Opcode::set_constant, context.layout.colour, {},
          emit::packed_colour(settings.colour, context.options.colour_bits));
  }

 private:
  void prepare(State& state, const emit::Drawing& drawing, const emit::DrawingInputs& inputs) const override {
    // Lines are drawn in the finished picture only, not in drawings inside it.
    if (drawing.nesting > 0) return;
    number(state, *drawing.tree, *drawing.geometry, settings);
    for (const glm::dvec2& place : places) {
      view::Sampling sampling = drawing.view.sampling;
      sampling.offset += place;
      // No effect applies to the numbers.
      state.drawings.push_back(
          emit::make_drawing(drawing.tree, drawing.geometry,
                             view::make_view(*drawing.geometry, *drawing.tree, drawing.view.camera, sampling),
                             drawing.nesting + 1, {inputs.machine, inputs.options, {}}, {}, drawing.plan.pairs));
    }
  }
};

}  // namespace

extern const emit::EffectRow edges{
    .section = scene::effect_section<EdgeSettings>("effects.edges",
                                                   "lines where facets or primitives meet, as in a technical drawing"),
    .technique =
        "after Saito and Takahashi 1990: pixels are compared with their neighbours by what is visible there; as pixels "
        "cannot read a neighbour, the numbers of facets are drawn three times: unshifted, shifted by a column and "
        "shifted by a row",
    .parts = emit::parts_of<Edges>};

}  // namespace csgsim::effects
