#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/emit/broadcast.h"
#include "host/emit/context.h"
#include "host/emit/drawing.h"
#include "host/emit/halfspaces.h"
#include "host/emit/layout.h"
#include "host/scene/schema.h"

namespace csgsim::emit {

/// An effect at work on one region: what it prepared for the drawing.
struct EffectCall {
  const EffectState& state;
  const Context& context;
};

/// Draws the picture once, colours and all, with the context of a drawing that an effect has prepared.
using DrawPicture = std::function<void(const Context& context)>;

/// What a scene may call for besides flat facets, with its settings. In what it does not override, it has no part. What
/// it broadcasts is billed to it.
class Effect {
 public:
  virtual ~Effect() = default;

  /// Whether a model calls for it by itself, where the scene does not say it.
  [[nodiscard]] virtual bool called_by(const Look& /*look*/) const { return false; }
  /// The model that is drawn in place of the file's. Throws InputError where the settings do not fit it.
  virtual model::Tree reshape(model::Tree&& tree) const { return std::move(tree); }
  /// Throws InputError where the settings do not fit the model. Called once for each drawing.
  [[nodiscard]] virtual std::unique_ptr<const EffectState> prepared_for(const Drawing& drawing,
                                                                        const Workshop& workshop) const = 0;
  /// Bits of pixel memory besides those of every picture; of `drawing`, the camera's own.
  [[nodiscard]] virtual std::vector<FieldRequest> fields(const Drawing& /*drawing*/,
                                                         const Workshop& /*workshop*/) const {
    return {};
  }

  /// Before a surface's depth test, where E is 1 at the pixels that have the surface: may clear E.
  virtual void admit(const EffectCall& /*call*/, Broadcast& /*out*/, const PlannedSurface& /*planned*/) const {}
  /// After a surface's merge, where E is 1 at the pixels that show it so far: may write fields, and leaves E.
  virtual void merge(const EffectCall& /*call*/, Broadcast& /*out*/, const PlannedSurface& /*planned*/) const {}
  /// Colours a facet into `field` where E is 1, and may clear E; E is 0 outside `pixels`. False if the facet is not the
  /// effect's: then nothing was broadcast.
  virtual bool shade(const EffectCall& /*call*/, Broadcast& /*out*/, const Facet& /*facet*/, isa::Field /*field*/,
                     const view::PixelRect& /*pixels*/) const {
    return false;
  }
  /// After all surfaces, before their colours: where lights are in shadow. Needs owners.
  virtual void light(const EffectCall& /*call*/, Broadcast& /*out*/, Shadows& /*shadows*/) const {}
  /// After the colours of a drawing.
  virtual void compose(const EffectCall& /*call*/, Broadcast& /*out*/) const {}
  /// In place of drawing the picture once. False if it does not.
  virtual bool around(const EffectCall& /*call*/, Broadcast& /*out*/, const DrawPicture& /*draw*/) const {
    return false;
  }
  /// Once, after the colours of a picture: of each, where there are several.
  virtual void finish(const EffectCall& /*call*/, Broadcast& /*out*/) const {}
  /// Once, after all pictures.
  virtual void enhance(const EffectCall& /*call*/, Broadcast& /*out*/) const {}
};

/// What an effect is derived from: it has its settings, which are made of its section's tables as scene::settings_of
/// says, and finds again what it prepared.
template <class SettingsType, class StateType = EffectState>
class EffectOf : public Effect {
 public:
  using Settings = SettingsType;
  using State = StateType;

  Settings settings;

  [[nodiscard]] std::unique_ptr<const EffectState> prepared_for(const Drawing& drawing,
                                                                const Workshop& workshop) const final {
    auto state = std::make_unique<State>();
    prepare(*state, drawing, workshop);
    return state;
  }

 protected:
  /// As prepared_for, into a blank state.
  virtual void prepare(State& /*state*/, const Drawing& /*drawing*/, const Workshop& /*workshop*/) const {}

  static const State& prepared(const EffectCall& call) { return static_cast<const State&>(call.state); }

  /// What was prepared for a drawing; null if it has not been yet.
  [[nodiscard]] const State* prepared_in(const Drawing& drawing, const Workshop& workshop) const {
    const auto own = std::ranges::find(workshop.called, this, [](const CalledEffect& one) { return one.effect.get(); });
    const auto number = static_cast<std::size_t>(own - workshop.called.begin());
    return number < drawing.states.size() ? static_cast<const State*>(drawing.states[number].get()) : nullptr;
  }

  /// What was prepared for a drawing and for all that are within it.
  [[nodiscard]] std::vector<const State*> all_prepared(const Drawing& drawing, const Workshop& workshop) const {
    std::vector<const State*> all;
    for (const Drawing* const one : with_inner(drawing)) {
      if (const State* const state = prepared_in(*one, workshop)) all.push_back(state);
    }
    return all;
  }
};

/// How a row makes its effect, and which parts it has that somebody asks for.
struct EffectParts {
  std::shared_ptr<const Effect> (*make)(const std::vector<scene::Values>& tables);  ///< throws as scene::table_of does
  bool shades;
  bool draws_around;
};

template <class Own>
inline constexpr EffectParts parts_of{[](const std::vector<scene::Values>& tables) -> std::shared_ptr<const Effect> {
                                        auto effect = std::make_shared<Own>();
                                        effect->settings = scene::settings_of<typename Own::Settings>(tables);
                                        return effect;
                                      },
                                      !std::is_same_v<decltype(&Own::shade), decltype(&Effect::shade)>,
                                      !std::is_same_v<decltype(&Own::around), decltype(&Effect::around)>};

/// A row of host/effects.
struct EffectRow {
  scene::Section section;      ///< of the scene file, named `effects.NAME`; that it is there calls for the effect
  std::string_view technique;  ///< and where it is from
  EffectParts parts;
  bool needs_owners = false;    ///< colours are found after all surfaces, by the number of the surface that is seen
  bool takes_quadrics = false;  ///< works where curved surfaces are drawn without facets
  bool sees_through = false;    ///< a primitive whose opacity is below 1 hides nothing

  [[nodiscard]] constexpr std::string_view name() const {
    return section.name.substr(std::string_view("effects.").size());
  }
};

/// Those that the scene or, where it says nothing, the model calls for, in the order of their rows; flat shading first.
std::vector<CalledEffect> called_effects(const Options& options, const Look& look);

/// What they ask of pixel memory for the camera's drawing.
std::vector<EffectFields> effect_fields(const Drawing& drawing, const Workshop& workshop);

bool any_needs_owners(std::span<const CalledEffect> called);

/// Has each effect of the context do its part, billed to it, until one returns true; whether one did.
template <class Part, class... Arguments>
bool for_effects(const Context& context, Broadcast& out, Part part, Arguments&... arguments) {
  for (std::size_t i = 0; i < context.called.size(); ++i) {
    if (((context.left_out >> i) & 1U) != 0) continue;
    const Billing billing(out, i);
    const EffectCall call{*(*context.states)[i], context};
    const Effect& effect = *context.called[i].effect;
    if constexpr (std::is_void_v<decltype((effect.*part)(call, out, arguments...))>) {
      (effect.*part)(call, out, arguments...);
    } else {
      if ((effect.*part)(call, out, arguments...)) return true;
    }
  }
  return false;
}

}  // namespace csgsim::emit
