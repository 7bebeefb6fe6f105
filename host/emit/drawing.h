// A drawing: a model as one camera sees it, planned and ready to be emitted.
// Used by host/effects.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "host/emit/broadcast.h"
#include "host/emit/context.h"
#include "host/emit/look.h"
#include "host/emit/options.h"
#include "host/emit/plan.h"

namespace csgsim::emit {

/// A mirror image, which shows only the part of the reflected model behind the mirror.
struct Reflection {
  unsigned count = 1;           ///< number of mirrors on the light's path
  std::uint32_t plane = 0;      ///< the mirror's plane, an index into the canonical planes of the reflected model
  view::PixelRect pixels;       ///< pixels that may show the mirror
  lighting::Lighting lighting;  ///< the reflected lighting
};

/// A model as one camera sees it, with everything that is computed before emission. The camera's picture is one
/// drawing; effects prepare others, for example what a mirror shows.
struct Drawing {
  std::shared_ptr<const model::Tree> tree;
  std::shared_ptr<const facet::Geometry> geometry;
  view::View view;
  Look look;
  Plan plan;
  unsigned nesting = 0;  ///< number of drawings that enclose this one
  std::optional<Reflection> reflection;
  const Drawing* sampled_from = nullptr;  ///< the drawing that differs only in its sample positions; null if none
  EffectStates states;
};

/// Inputs for making drawings.
struct DrawingInputs {
  const machines::Machine& machine;
  const Options& options;
  std::span<const EffectRequest> called;
  csg::KeptResults* kept = nullptr;  ///< results of earlier frames of the model; null if none are kept
};

/// Plans a drawing and lets each called effect prepare it. `pairs` are those of another drawing of the same geometry,
/// or null. Throws InputError if an effect cannot prepare the drawing.
std::shared_ptr<const Drawing> make_drawing(std::shared_ptr<const model::Tree> tree,
                                            std::shared_ptr<const facet::Geometry> geometry, view::View view,
                                            unsigned nesting, const DrawingInputs& inputs,
                                            std::optional<Reflection> reflection = {},
                                            std::shared_ptr<csg::PairTable> pairs = nullptr);

/// The same drawing, sampled at `offset` (columns, rows) from the pixel centres.
std::shared_ptr<const Drawing> make_sample(const Drawing& drawing, const glm::dvec2& offset,
                                           const DrawingInputs& inputs);

/// The drawing and the drawings inside it that its effects prepared, recursively.
std::vector<const Drawing*> with_inner_drawings(const Drawing& drawing);

/// A context for another drawing with the same region, fields and settings.
Context context_for(const Drawing& drawing, const Context& outer);

/// Whether emit_surfaces() draws the surface.
bool is_drawn(const Context& context, const PlannedSurface& planned);

/// Numbers of half-spaces and primitives in the drawn surfaces.
struct DrawnCounts {
  std::uint32_t primitives = 0;
  std::uint32_t halfspaces = 0;
};

/// Initializes background, depth and owner at the context's pixels.
void emit_setup(const Context& context, Broadcast& out);

/// Draws the surfaces of the context's plan into Z2, and their colours unless owners are kept.
DrawnCounts emit_surfaces(const Context& context, Broadcast& out);

/// If owners are kept: emits shadows, then the colours of the visible surfaces. Else emits nothing.
void emit_shading(const Context& context, Broadcast& out);

/// Emits the effects that follow the colours.
void emit_composition(const Context& context, Broadcast& out);

/// Calls the four functions above, in this order.
DrawnCounts emit_drawing(const Context& context, Broadcast& out);

/// Emits the camera's picture with all effects.
DrawnCounts emit_picture(const Context& context, Broadcast& out);

}  // namespace csgsim::emit
