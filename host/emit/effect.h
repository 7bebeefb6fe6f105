// The interface of effects, and the row that registers one.
// Used by host/effects and sim/session.
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

/// Arguments of an effect's work on one region: its state for the drawing, and the context.
struct EffectCall {
  const EffectState& state;
  const Context& context;
};

/// Draws the picture once, with colours, from the context of a drawing that an effect has prepared.
using DrawPicture = std::function<void(const Context& context)>;

/// A technique that a scene may call for beyond flat facets, with its settings. The default of each function does
/// nothing. Instructions that an effect appends are billed to it.
class Effect {
 public:
  virtual ~Effect() = default;

  /// Whether a model with this look requires the effect although the scene does not mention it.
  [[nodiscard]] virtual bool is_implied_by(const Look& /*look*/) const { return false; }
  /// Returns the model to draw in place of the file's. Throws InputError if the settings do not fit it.
  virtual model::Tree reshape(model::Tree&& tree) const { return std::move(tree); }
  /// Computes the effect's state for a drawing, once per drawing. Throws InputError if the settings do not fit the
  /// model.
  [[nodiscard]] virtual std::unique_ptr<const EffectState> prepared_for(const Drawing& drawing,
                                                                        const DrawingInputs& inputs) const = 0;
  /// The fields of pixel memory that the effect needs; `drawing` is the camera's.
  [[nodiscard]] virtual std::vector<FieldRequest> fields(const Drawing& /*drawing*/,
                                                         const DrawingInputs& /*inputs*/) const {
    return {};
  }

  /// Called before a surface's depth test, with E 1 at the surface's pixels; may clear E.
  virtual void admit(const EffectCall& /*call*/, Broadcast& /*out*/, const PlannedSurface& /*planned*/) const {}
  /// Called after a surface's merge, with E 1 at the pixels that show it until now; may write fields and preserves E.
  virtual void merge(const EffectCall& /*call*/, Broadcast& /*out*/, const PlannedSurface& /*planned*/) const {}
  /// Colours a facet into `field` where E is 1, and may clear E; E is 0 outside `pixels`. Returns false without
  /// appending instructions if the facet is not the effect's.
  virtual bool shade(const EffectCall& /*call*/, Broadcast& /*out*/, const Facet& /*facet*/, isa::Field /*field*/,
                     const view::PixelRect& /*pixels*/) const {
    return false;
  }
  /// Called after all surfaces and before their colours: finds where lights are in shadow. Needs owners.
  virtual void light(const EffectCall& /*call*/, Broadcast& /*out*/, Shadows& /*shadows*/) const {}
  /// Called after the colours of a drawing.
  virtual void compose(const EffectCall& /*call*/, Broadcast& /*out*/) const {}
  /// Draws the picture by calling `draw`, possibly several times. Returns false without appending instructions if the
  /// effect does not do this; the caller then draws the picture once.
  virtual bool draw_around(const EffectCall& /*call*/, Broadcast& /*out*/, const DrawPicture& /*draw*/) const {
    return false;
  }
  /// Called once after the colours of each picture.
  virtual void finish(const EffectCall& /*call*/, Broadcast& /*out*/) const {}
  /// Called once after all pictures.
  virtual void enhance(const EffectCall& /*call*/, Broadcast& /*out*/) const {}
};

/// Base class of effects. It holds the settings parsed by scene::settings_of from the tables of its section, and
/// provides access to the prepared state.
template <class SettingsType, class StateType = EffectState>
class EffectOf : public Effect {
 public:
  using Settings = SettingsType;
  using State = StateType;

  Settings settings;

  [[nodiscard]] std::unique_ptr<const EffectState> prepared_for(const Drawing& drawing,
                                                                const DrawingInputs& inputs) const final {
    auto state = std::make_unique<State>();
    prepare(*state, drawing, inputs);
    return state;
  }

 protected:
  /// Prepares a default-constructed state.
  virtual void prepare(State& /*state*/, const Drawing& /*drawing*/, const DrawingInputs& /*inputs*/) const {}

  static const State& prepared(const EffectCall& call) { return static_cast<const State&>(call.state); }

  /// The state prepared for a drawing; null if there is none yet.
  [[nodiscard]] const State* prepared_in(const Drawing& drawing, const DrawingInputs& inputs) const {
    const auto own = std::ranges::find(inputs.called, this, [](const EffectRequest& one) { return one.effect.get(); });
    const auto number = static_cast<std::size_t>(own - inputs.called.begin());
    return number < drawing.states.size() ? static_cast<const State*>(drawing.states[number].get()) : nullptr;
  }

  /// The states prepared for a drawing and for all drawings inside it.
  [[nodiscard]] std::vector<const State*> all_prepared(const Drawing& drawing, const DrawingInputs& inputs) const {
    std::vector<const State*> all;
    for (const Drawing* const one : with_inner_drawings(drawing)) {
      if (const State* const state = prepared_in(*one, inputs)) all.push_back(state);
    }
    return all;
  }
};

/// The factory of an effect, and which optional functions it overrides.
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
                                      !std::is_same_v<decltype(&Own::draw_around), decltype(&Effect::draw_around)>};

/// A row of the table in host/effects.
struct EffectRow {
  scene::Section section;      ///< section of the scene file, named `effects.NAME`; its presence calls for the effect
  std::string_view technique;  ///< the technique and its source
  EffectParts parts;
  bool needs_owners = false;    ///< colours are computed after all surfaces, by the number of the visible surface
  bool takes_quadrics = false;  ///< supports curved surfaces drawn without facets
  bool sees_through = false;    ///< primitives with an opacity below 1 hide nothing

  [[nodiscard]] constexpr std::string_view name() const {
    return section.name.substr(std::string_view("effects.").size());
  }
};

/// The effects that the scene calls for, or the model where the scene does not mention them, in the order of their
/// rows; flat shading is the first.
std::vector<EffectRequest> called_effects(const Options& options, const Look& look);

/// The first of these effects that makes something transparent; null if there is none.
const EffectRow* find_transparency_effect(const Options& options, const model::Tree& tree, const view::Camera& camera);

/// Fields of pixel memory that the effects request for the camera's drawing.
std::vector<EffectFields> effect_fields(const Drawing& drawing, const DrawingInputs& inputs);

bool any_needs_owners(std::span<const EffectRequest> called);

/// Calls the member function `part` of each effect of the context, until a call returns true. Each effect is billed for
/// its instructions. Returns whether a call returned true.
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
