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
class StoredDepths;
struct Drawing;
struct EffectRow;
struct Facet;

/// An effect that the scene or the model calls for, which has its settings.
struct CalledEffect {
  const EffectRow* row = nullptr;
  std::shared_ptr<const Effect> effect;
};

/// What an effect prepares for a drawing: this, and in a struct of its own whatever else it likes.
struct EffectState {
  std::vector<bool> apart;  ///< by primitive: whose surfaces the effect draws itself; empty: none
  std::vector<std::shared_ptr<const Drawing>> drawings;  ///< within it, if the effect makes some

  virtual ~EffectState() = default;
};

/// One a called effect.
using EffectStates = std::vector<std::unique_ptr<const EffectState>>;

/// A light that is in shadow at some pixels.
struct ShadowBit {
  std::size_t light = 0;  ///< index into Lighting::lights
  isa::Field bit;         ///< 1 where its light does not reach what is seen
  /// Facets that have some of the shadow; of others the bit says nothing. Each a primitive and a half-space of it.
  std::vector<std::pair<std::uint32_t, facet::Halfspace>> facets;
};

/// Where lights are in shadow.
struct Shadows {
  std::vector<ShadowBit> bits;
  isa::Field spare;  ///< one bit for shading to keep E in
};

/// The value of a facet, in place of its colour.
using Paint = std::function<std::uint32_t(const Facet& facet)>;

/// What every part of the emitter reads while it works on one segment.
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

  std::size_t segment = 0;                          ///< number of the plan's
  std::span<const CalledEffect> called{};           ///< effects, in the order of their rows
  const EffectStates* states = nullptr;             ///< of the drawing
  std::uint32_t left_out = 0;                       ///< bit i: effect i has no part in this drawing
  unsigned nesting = 0;                             ///< drawings that this one is within
  isa::Field base{};                                ///< a bit that is 1 where the drawing is made; width 0: everywhere
  isa::Field beyond{};                              ///< only what is behind this depth is seen; width 0: all
  const view::FixedLinear* beyond_plane = nullptr;  ///< only what is behind this plane is seen; null: all
  const std::vector<bool>* drawn =
      nullptr;  ///< by primitive: whose surfaces are drawn; null: all but what effects draw
  const lighting::Lighting* lights = nullptr;  ///< in place of the look's
  const Paint* paint = nullptr;                ///< in place of colours
  const StoredDepths* stored = nullptr;        ///< depths that are kept while surfaces are drawn; null: none
  csg::Counted counted{};                      ///< where what the host does is counted

  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << view.sampling.z_bits) - 1; }
  [[nodiscard]] bool complemented(std::uint32_t primitive) const {
    return positive.nodes[positive.leaf_of[primitive]].complemented;
  }
  [[nodiscard]] const view::FixedLinear& linear_of(facet::Halfspace halfspace) const {
    return view.planes[halfspace.plane].linear;
  }
  [[nodiscard]] view::Range range_of(facet::Halfspace halfspace, const view::PixelRect& pixels) const {
    return csg::depth_range(view.planes[halfspace.plane], view.sampling.fraction_bits, pixels);
  }
  [[nodiscard]] const lighting::Lighting& lighting() const { return lights != nullptr ? *lights : look.lighting; }
};

/// The same drawing into other fields.
Context with_layout(const Context& context, const Layout& layout);

/// E := where the context's drawing is made: its base, or everywhere.
void enable_drawing(const Context& context, Broadcast& out);

/// Of what an effect broadcasts that serves no surface.
inline constexpr isa::Origin effect_origin{isa::Purpose::effect, isa::no_primitive, isa::no_node};

}  // namespace csgsim::emit
