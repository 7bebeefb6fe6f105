#include "host/emit/flat_shading.h"

#include <array>

#include "host/emit/curved_light.h"
#include "host/emit/facet_colour.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

struct NoSettings {};

void visit_keys(NoSettings& /*settings*/, const auto& /*visit*/) {}

class FlatShading final : public EffectOf<NoSettings> {
 public:
  [[nodiscard]] bool is_implied_by(const Look& /*look*/) const override { return true; }

  bool shade(const EffectCall& call, Broadcast& out, const Facet& facet, isa::Field field,
             const view::PixelRect& pixels) const override {
    if (is_curved(facet.at)) {
      emit_curved_light(call.context, out, facet, field, pixels);
      return true;
    }
    out.plain(isa::Opcode::set_constant, field, {}, facet_colour(call.context, facet));
    return true;
  }
};

constexpr std::array rows{&flat};

}  // namespace

const EffectRow flat{.section = scene::effect_section<NoSettings>("effects.flat", "every facet in one colour"),
                     .technique = "Lambert's law and the highlights of Blinn 1977, computed once per facet by the host",
                     .parts = parts_of<FlatShading>,
                     .takes_quadrics = true};

std::span<const EffectRow* const> only_flat_shading() { return rows; }

}  // namespace csgsim::emit
