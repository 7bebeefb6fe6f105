#pragma once

#include <any>
#include <functional>
#include <string_view>
#include <vector>

#include "host/emit/broadcast.h"
#include "host/emit/context.h"
#include "host/emit/drawing.h"
#include "host/emit/halfspaces.h"
#include "host/emit/layout.h"
#include "host/scene/schema.h"

namespace csgsim::emit {

/// An effect at work on one region: what it was called with, and what it prepared for the drawing.
struct EffectCall {
  const std::any& settings;
  const EffectState& state;
  const Context& context;
};

/// Draws the picture once, colours and all, with the context of a drawing that an effect has prepared.
using DrawPicture = std::function<void(const Context& context)>;

/// What a scene may call for besides flat facets: a row of host/effects. Where a function may be null, the effect has
/// no part in it. What it broadcasts is billed to it.
struct Effect {
  scene::Section section;      ///< of the scene file, named `effects.NAME`; that it is there calls for the effect
  std::string_view technique;  ///< and where it is from

  /// Whether a model calls for it by itself, where the scene does not say it.
  bool (*called_by)(const Look& look) = nullptr;
  /// The model that is drawn in place of the file's. Throws InputError where the settings do not fit it.
  model::Tree (*reshape)(const std::any& settings, model::Tree&& tree) = nullptr;
  /// Throws InputError where the settings do not fit the model. Called once for each drawing.
  EffectState (*prepare)(const std::any& settings, const Drawing& drawing, const Workshop& workshop) = nullptr;
  /// Bits of pixel memory besides those of every picture; of `drawing`, the camera's own.
  std::vector<FieldRequest> (*fields)(const std::any& settings, const Drawing& drawing,
                                      const Workshop& workshop) = nullptr;
  bool needs_owners = false;    ///< colours are found after all surfaces, by the number of the surface that is seen
  bool takes_quadrics = false;  ///< works where curved surfaces are drawn without facets
  bool sees_through = false;    ///< a primitive whose opacity is below 1 hides nothing

  /// Before a surface's depth test, where E is 1 at the pixels that have the surface: may clear E.
  void (*admit)(const EffectCall& call, Broadcast& out, const PlannedSurface& planned) = nullptr;
  /// After a surface's merge, where E is 1 at the pixels that show it so far: may write fields, and leaves E.
  void (*merge)(const EffectCall& call, Broadcast& out, const PlannedSurface& planned) = nullptr;
  /// Colours a facet into `field` where E is 1, and may clear E; E is 0 outside `pixels`. False if the facet is not the
  /// effect's: then nothing was broadcast.
  bool (*shade)(const EffectCall& call, Broadcast& out, const Facet& facet, isa::Field field,
                const view::PixelRect& pixels) = nullptr;
  /// After all surfaces, before their colours: where lights are in shadow. Needs owners.
  Shadows (*light)(const EffectCall& call, Broadcast& out) = nullptr;
  /// After the colours of a drawing.
  void (*compose)(const EffectCall& call, Broadcast& out) = nullptr;
  /// In place of drawing the picture once.
  void (*around)(const EffectCall& call, Broadcast& out, const DrawPicture& draw) = nullptr;
  /// Once, after the colours of a picture: of each, where there are several.
  void (*finish)(const EffectCall& call, Broadcast& out) = nullptr;
  /// Once, after all pictures.
  void (*enhance)(const EffectCall& call, Broadcast& out) = nullptr;

  [[nodiscard]] constexpr std::string_view name() const {
    return section.name.substr(std::string_view("effects.").size());
  }
};

/// Those that the scene or, where it says nothing, the model calls for, in the order of their rows; flat shading first.
std::vector<CalledEffect> called_effects(const Options& options, const Look& look);

/// What they ask of pixel memory for the camera's drawing.
std::vector<EffectFields> effect_fields(const Drawing& drawing, const Workshop& workshop);

bool any_needs_owners(std::span<const CalledEffect> called);

/// Calls visit(effect, call) for each effect of the context that has such a part, billed to it. Stops where visit
/// returns true, and returns whether it did.
template <class Part, class Visit>
bool for_effects(const Context& context, Broadcast& out, Part Effect::*part, const Visit& visit) {
  for (std::size_t i = 0; i < context.called.size(); ++i) {
    const CalledEffect& one = context.called[i];
    if (one.effect->*part == nullptr || ((context.left_out >> i) & 1U) != 0) continue;
    const Billing billing(out, i);
    const EffectCall call{one.settings, (*context.states)[i], context};
    if (visit(*one.effect, call)) return true;
  }
  return false;
}

}  // namespace csgsim::emit
