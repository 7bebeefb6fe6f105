#include "host/effects/transparency.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/effects/layers.h"
#include "host/effects/screen_door.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

namespace {

enum class Method : std::uint8_t { layers, screen_door };

constexpr std::array<std::string_view, 2> methods{"layers", "screen-door"};
constexpr unsigned most_layers = 16;

struct Settings {
  Method method = Method::layers;
  std::optional<unsigned> layers;
};

constexpr std::array keys{
    scene::choice_key<&Settings::method>("method", methods, "blend layers, or leave out pixels by a pattern"),
    scene::integer_key<&Settings::layers>("layers", "", 1, most_layers,
                                          "see-through surfaces that a pixel shows behind one another, the nearest; if "
                                          "not given, as many as their rectangles let lie there, 16 at most")};

/// What is prepared for a drawing. Clang tells what is in a std::any by the name of its type, unnamed namespaces left
/// out: effects that look for theirs among others' have a name of their own for it.
struct PreparedPanes {
  Panes panes;                    ///< method layers
  std::vector<unsigned> pattern;  ///< method screen-door: by primitive, pixels of every 4 x 4
};

const Settings& settings_of(const std::any& settings) { return std::any_cast<const Settings&>(settings); }
const PreparedPanes& prepared(const emit::EffectCall& call) {
  return std::any_cast<const PreparedPanes&>(call.state.own);
}

emit::EffectState prepare(const std::any& settings, const emit::Drawing& drawing, const emit::Workshop& /*workshop*/) {
  PreparedPanes ready;
  emit::EffectState state;
  const bool is_layered = settings_of(settings).method == Method::layers;
  if (is_layered) ready.panes = panes_of(drawing, settings_of(settings).layers.value_or(most_layers));
  for (const lighting::Finish& finish : drawing.look.finishes) {
    const auto pixels = static_cast<unsigned>(view::to_fixed(finish.opacity, 4).value_or(most_pixels));
    ready.pattern.push_back(pixels);
    state.apart.push_back(is_layered ? finish.opacity < 1 : pixels == 0);
  }
  state.own = std::move(ready);
  return state;
}

/// What was prepared for each of the drawings.
std::vector<const PreparedPanes*> all_prepared(const emit::Drawing& drawing) {
  std::vector<const PreparedPanes*> all;
  for (const emit::Drawing* const one : emit::with_inner(drawing))
    for (const emit::EffectState& state : one->states)
      if (const auto* const ready = std::any_cast<PreparedPanes>(&state.own)) all.push_back(ready);
  return all;
}

std::vector<emit::FieldRequest> fields(const std::any& settings, const emit::Drawing& drawing,
                                       const emit::Workshop& workshop) {
  if (settings_of(settings).method != Method::layers) return {};
  const std::vector<const PreparedPanes*> all = all_prepared(drawing);
  std::vector<const Panes*> panes(all.size());
  std::transform(all.begin(), all.end(), panes.begin(), [](const PreparedPanes* one) { return &one->panes; });
  return layer_fields(drawing.view.sampling.z_bits, workshop.options.colour_bits, panes,
                      emit::any_needs_owners(workshop.called));
}

void admit(const emit::EffectCall& call, emit::Broadcast& out, const emit::PlannedSurface& planned) {
  if (settings_of(call.settings).method == Method::layers)
    return emit_joints(call.context, out, prepared(call).panes, planned);
  out.origin = {isa::Purpose::merge, planned.primitive(), isa::no_node};
  emit_screen_door(out, prepared(call).pattern[planned.primitive()], call.context.layout.mask);
}

void merge(const emit::EffectCall& call, emit::Broadcast& out, const emit::PlannedSurface& planned) {
  if (settings_of(call.settings).method == Method::layers)
    emit_opacity(call.context, out, prepared(call).panes, planned.primitive());
}

void compose(const emit::EffectCall& call, emit::Broadcast& out) {
  if (settings_of(call.settings).method == Method::layers) emit_layers(call.context, out, prepared(call).panes);
}

}  // namespace

std::optional<scene::Scene> by_screen_door(scene::Scene scene) {
  const bool says_how = std::any_of(scene.effects.begin(), scene.effects.end(), [](const scene::CalledEffect& one) {
    return one.name == transparency.section.name;
  });
  const bool lets_through = std::any_of(scene.materials.begin(), scene.materials.end(),
                                        [](const scene::MaterialRule& one) { return one.opacity.value_or(1) < 1; });
  if (says_how || lets_through) return std::nullopt;
  scene.effects.push_back({transparency.section.name, Settings{Method::screen_door, {}}});
  return scene;
}

const emit::Effect transparency{
    .section = {"effects.transparency",
                "primitives whose opacity is below 1 let through what is behind them; of coincident surfaces the first "
                "in tree order is seen, opaque ones before see-through ones",
                false, keys, scene::blank_section<Settings>, scene::keep_effect},
    .technique =
        "layers: depth peeling (Mammen, Transparency and Antialiasing Algorithms Implemented with the Virtual Pixel "
        "Maps Technique, IEEE CG&A, 1989; Everitt, Interactive Order-Independent Transparency, 2001), with two depth "
        "fields beside that of the opaque surfaces; screen-door: Fuchs et al., SIGGRAPH 1985, with an ordered dither",
    .called_by =
        [](const emit::Look& look) {
          return std::any_of(look.finishes.begin(), look.finishes.end(),
                             [](const lighting::Finish& one) { return one.opacity < 1; });
        },
    .prepare = prepare,
    .fields = fields,
    .sees_through = true,
    .admit = admit,
    .merge = merge,
    .compose = compose};

}  // namespace csgsim::effects
