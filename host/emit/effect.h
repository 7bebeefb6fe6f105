#pragma once

#include <any>
#include <string_view>
#include <vector>

#include "host/emit/broadcast.h"
#include "host/emit/context.h"
#include "host/emit/halfspaces.h"
#include "host/scene/schema.h"

namespace csgsim::emit {

/// What a scene may call for besides flat facets: a row of host/effects. Where a function may be null, the effect has
/// no part in it.
struct Effect {
  scene::Section section;      ///< of the scene file, named `effects.NAME`; that it is there calls for the effect
  std::string_view technique;  ///< and where it is from

  /// Colours a facet into `field` where E is 1, and may clear E; E is 0 outside `pixels`. False if the facet is not the
  /// effect's: then nothing was broadcast.
  bool (*shade)(const std::any& settings, const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                const view::PixelRect& pixels) = nullptr;

  [[nodiscard]] constexpr std::string_view name() const {
    return section.name.substr(std::string_view("effects.").size());
  }
};

/// Whether an effect may colour facets, so that E may be less afterwards.
bool has_shaders(const Context& context);

/// Colours a facet into `field` where E is 1: by the first effect whose facet it is, else in one colour.
void emit_colour(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                 const view::PixelRect& pixels);

}  // namespace csgsim::emit
