#include "host/effects/transparency.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/effects/layers.h"
#include "host/effects/rows.h"
#include "host/effects/screen_door.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

extern const emit::EffectRow transparency;

namespace {

enum class Method : std::uint8_t { layers, screen_door };

constexpr std::array<std::string_view, 2> methods{"layers", "screen-door"};
constexpr unsigned max_layers = 16;

struct Settings {
  Method method = Method::layers;
  std::optional<unsigned> layers;
};

void visit_keys(Settings& settings, auto&& visit) {
  visit(scene::choice_key("method", methods, "blend layers, or omit pixels by a pattern"), settings.method);
  visit(scene::integer_key(
            "layers", "", 1, max_layers,
            "maximum number of transparent surfaces, the nearest ones, that a pixel shows; by default as many "
            "as their rectangles allow, at most 16"),
        settings.layers);
}

struct Prepared : emit::EffectState {
  Panes panes;                    ///< for method layers
  std::vector<unsigned> pattern;  ///< for method screen-door: per primitive, the number of pixels of each 4 x 4 block
};

class Transparency final : public emit::EffectOf<Settings, Prepared> {
 public:
  [[nodiscard]] bool is_implied_by(const emit::Look& look) const override {
    return std::any_of(look.finishes.begin(), look.finishes.end(),
                       [](const lighting::Finish& one) { return one.opacity < 1; });
  }

  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& drawing,
                                                       const emit::DrawingInputs& inputs) const override {
    if (!is_layered()) return {};
    std::vector<const Panes*> panes;
    for (const State* const one : all_prepared(drawing, inputs)) panes.push_back(&one->panes);
    return layer_fields(drawing.view.sampling.z_bits, inputs.options.colour_bits, panes,
                        emit::any_needs_owners(inputs.called));
  }

  void admit(const emit::EffectCall& call, emit::Broadcast& out, const emit::PlannedSurface& planned) const override {
    if (is_layered()) return emit_joints(call.context, out, prepared(call).panes, planned);
    out.origin = {isa::Purpose::merge, planned.primitive(), isa::no_node};
    emit_screen_door(out, prepared(call).pattern[planned.primitive()], call.context.layout.mask);
  }

  void merge(const emit::EffectCall& call, emit::Broadcast& out, const emit::PlannedSurface& planned) const override {
    if (is_layered()) emit_opacity(call.context, out, prepared(call).panes, planned.primitive());
  }

  void compose(const emit::EffectCall& call, emit::Broadcast& out) const override {
    if (is_layered()) emit_layers(call.context, out, prepared(call).panes);
  }

 private:
  void prepare(State& state, const emit::Drawing& drawing, const emit::DrawingInputs& /*inputs*/) const override {
    if (is_layered()) state.panes = find_panes(drawing, settings.layers.value_or(max_layers));
    for (const lighting::Finish& finish : drawing.look.finishes) {
      const auto pixels = static_cast<unsigned>(view::to_fixed(finish.opacity, 4).value_or(max_pattern_pixels));
      state.pattern.push_back(pixels);
      state.apart.push_back(is_layered() ? finish.opacity < 1 : pixels == 0);
    }
  }

  [[nodiscard]] bool is_layered() const { return settings.method == Method::layers; }
};

}  // namespace

std::optional<scene::Scene> with_screen_doors(scene::Scene scene) {
  const bool sets_effect = std::any_of(scene.effects.begin(), scene.effects.end(), [](const scene::EffectRequest& one) {
    return one.name == transparency.section.name;
  });
  const bool is_transparent = std::any_of(scene.materials.begin(), scene.materials.end(),
                                          [](const scene::MaterialRule& one) { return one.opacity.value_or(1) < 1; });
  if (sets_effect || is_transparent) return std::nullopt;
  scene.effects.push_back({transparency.section.name, {scene::values_of(Settings{Method::screen_door, {}})}});
  return scene;
}

extern const emit::EffectRow transparency{
    .section = scene::effect_section<Settings>(
        "effects.transparency",
        "primitives whose opacity is below 1 let through what is behind them; of coincident surfaces the first "
        "in tree order is visible, opaque ones before transparent ones"),
    .technique =
        "layers: depth peeling (Mammen 1989; Everitt 2001), with two depth fields beside that of the opaque surfaces; "
        "screen-door: Fuchs et al. 1985, with an ordered dither",
    .parts = emit::parts_of<Transparency>,
    .sees_through = true};

}  // namespace csgsim::effects
