// State that all parts of the emitter share while they work on one segment.
// Used by host/effects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "host/emit/broadcast.h"
#include "host/emit/layout.h"
#include "host/emit/look.h"
#include "host/emit/options.h"
#include "host/emit/plan.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

class Effect;
class KnownColours;
class StoredDepths;
struct Drawing;
struct EffectRow;
struct Facet;

/// An effect that the scene or the model calls for, with its settings.
struct EffectRequest {
  const EffectRow* row = nullptr;
  std::shared_ptr<const Effect> effect;
};

/// State that an effect prepares for a drawing; effects derive their own states from it.
struct EffectState {
  std::vector<bool> apart;  ///< by primitive: whether the effect itself draws its surfaces; empty: for none
  std::vector<std::shared_ptr<const Drawing>> drawings;  ///< inner drawings that the effect makes, if any

  virtual ~EffectState() = default;
};

/// One state per called effect.
using EffectStates = std::vector<std::unique_ptr<const EffectState>>;

/// A light that is in shadow at some pixels.
struct ShadowBit {
  std::size_t light = 0;  ///< index into Lighting::lights
  isa::Field bit;         ///< 1 where the light does not reach the visible surface
  /// Facets that may be in the shadow, each as a primitive and one of its half-spaces. The bit is undefined for others.
  std::vector<std::pair<std::uint32_t, facet::Halfspace>> facets;
};

/// The shadow bits of all lights.
struct Shadows {
  std::vector<ShadowBit> bits;
  isa::Field spare;  ///< one bit in which shading saves E
};

/// Returns the value written for a facet in place of its colour.
using Paint = std::function<std::uint32_t(const Facet& facet)>;

/// Inputs of all parts of the emitter while they work on one segment.
struct Context {
  const model::Tree& tree;
  const facet::Geometry& geometry;
  const view::View& view;
  const csg::PositiveTree& positive;
  const SegmentPlan& plan;
  const Layout& layout;
  const Options& options;
  const machines::Machine& machine;
  const Look& look;

  std::size_t segment = 0;                          ///< index into the segments of the plan
  std::span<const EffectRequest> called{};          ///< effects, in the order of their rows
  const EffectStates* states = nullptr;             ///< by called effect: its state for the drawing
  std::uint32_t left_out = 0;                       ///< bit i: effect i takes no part in this drawing
  unsigned nesting = 0;                             ///< number of drawings that enclose this one
  isa::Field base{};                                ///< 1 at the pixels of the drawing; width 0: everywhere
  isa::Field beyond{};                              ///< only surfaces behind this depth are visible; width 0: all
  const view::FixedLinear* beyond_plane = nullptr;  ///< only surfaces behind this plane are visible; null: all
  const std::vector<bool>* drawn =
      nullptr;  ///< by primitive: whether its surfaces are drawn; null: those that no effect draws itself
  const lighting::Lighting* lights = nullptr;  ///< used in place of the look's lighting; may be null
  const Paint* paint = nullptr;                ///< used in place of colours; may be null
  const StoredDepths* stored = nullptr;        ///< depths stored while surfaces are drawn; null: none
  csg::Counted counted{};                      ///< counters of host work
  KnownColours* known_colours = nullptr;       ///< colours computed for the frame until now; null: none are kept

  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << view.sampling.z_bits) - 1; }
  [[nodiscard]] bool complemented(std::uint32_t primitive) const {
    return positive.nodes[positive.leaf_of[primitive]].complemented;
  }
  [[nodiscard]] const view::FixedLinear& linear_plane(facet::Halfspace halfspace) const {
    return view.planes[halfspace.plane].linear;
  }
  [[nodiscard]] view::Range depth_range(facet::Halfspace halfspace, const view::PixelRect& pixels) const {
    return csg::depth_range(view.planes[halfspace.plane], view.sampling.fraction_bits, pixels);
  }
  [[nodiscard]] const lighting::Lighting& lighting() const { return lights != nullptr ? *lights : look.lighting; }
};

/// The same drawing with another layout of fields.
Context with_layout(const Context& context, const Layout& layout);

/// E := 1 at the pixels of the context's drawing: its base, or everywhere.
void enable_drawing(const Context& context, Broadcast& out);

/// Origin of an effect's instructions that belong to no surface.
inline constexpr isa::Origin effect_origin{isa::Purpose::effect, isa::no_primitive, isa::no_node};

}  // namespace csgsim::emit
