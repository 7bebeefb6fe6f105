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

/// How a model is seen that is seen in a mirror: of it, reflected, only what is behind the mirror.
struct Reflection {
  unsigned count = 1;           ///< mirrors on the way
  std::uint32_t plane = 0;      ///< the mirror's, among the canonical planes of the reflected model
  view::PixelRect pixels;       ///< that may show the mirror
  lighting::Lighting lighting;  ///< reflected too
};

/// A model as one camera sees it, with all that is worked out before anything is broadcast. The camera's picture is
/// one; effects prepare others, as of what a mirror shows.
struct Drawing {
  std::shared_ptr<const model::Tree> tree;
  std::shared_ptr<const facet::Geometry> geometry;
  view::View view;
  Look look;
  Plan plan;
  unsigned nesting = 0;  ///< drawings that it is within
  std::optional<Reflection> reflection;
  const Drawing* sampled_from = nullptr;  ///< the same but for where its pixels are sampled, if that is another one
  EffectStates states;
};

/// What drawings are made with.
struct Workshop {
  const machines::Machine& machine;
  const Options& options;
  std::span<const CalledEffect> called;
};

/// Plans a drawing, and has each called effect prepare it. Throws InputError where an effect cannot.
std::shared_ptr<const Drawing> make_drawing(std::shared_ptr<const model::Tree> tree,
                                            std::shared_ptr<const facet::Geometry> geometry, view::View view,
                                            unsigned nesting, const Workshop& workshop,
                                            std::optional<Reflection> reflection = {});

/// The same drawing, sampled so far from the pixels' centres: columns and rows.
std::shared_ptr<const Drawing> make_sample(const Drawing& drawing, const glm::dvec2& offset, const Workshop& workshop);

/// The drawing and all that its effects prepared, themselves within one another.
std::vector<const Drawing*> with_inner(const Drawing& drawing);

/// The same region, fields and settings, for another drawing.
Context context_of(const Drawing& drawing, const Context& outer);

/// Whether the surface is one of those that emit_surfaces draws.
bool is_drawn(const Context& context, const PlannedSurface& planned);

/// Half-spaces and primitives that surfaces were drawn of.
struct Kept {
  std::uint32_t primitives = 0;
  std::uint32_t halfspaces = 0;
};

/// Nothing seen yet at the context's pixels: background, depth and owner.
void emit_setup(const Context& context, Broadcast& out);

/// The surfaces of the context's plan into Z2, colours too unless owners are kept.
Kept emit_surfaces(const Context& context, Broadcast& out);

/// Where owners are kept: shadows, then the colours of the surfaces that are seen. Nothing otherwise.
void emit_shading(const Context& context, Broadcast& out);

/// The effects that follow the colours.
void emit_composition(const Context& context, Broadcast& out);

/// All four, one after another.
Kept emit_drawing(const Context& context, Broadcast& out);

/// The camera's picture with all effects.
Kept emit_picture(const Context& context, Broadcast& out);

}  // namespace csgsim::emit
