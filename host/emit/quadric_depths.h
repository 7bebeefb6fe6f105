#pragma once

#include <vector>

#include "host/csg/locate.h"
#include "host/emit/context.h"
#include "host/emit/plan.h"
#include "host/view/screen_quadric.h"

namespace csgsim::emit {

/// A quadric that bounds a primitive.
struct QuadricBound {
  std::uint32_t primitive = model::no_index;
  facet::QuadricSide side;
  view::QuadricRole role = view::QuadricRole::between;
};

/// The bounds of a primitive. Throws InputError, naming the primitive, where one does not fit the machine.
std::vector<QuadricBound> quadric_bounds(const Context& context, std::uint32_t primitive);

/// Whether every point of the block, or none, is within the bound, if such pruning is asked for.
csg::Known known_of(const Context& context, const QuadricBound& bound, const csg::Block& block);

/// What of a bound matters to points of a block.
struct Matters {
  bool outline = true;  ///< whether the ray meets it
  bool near = true;
  bool far = true;
};

Matters what_matters(const Context& context, const QuadricBound& bound, const csg::Block& block);

/// Whether the nearer (farther) of its depths, if that is what is seen of it, may be 0 or before it in those pixels.
bool may_reach_near(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels);

/// Bits that the quadrics of the model take, and light on them in colours of that many bits.
QuadricBits quadric_bits(const facet::Geometry& geometry, const view::View& view, unsigned colour_bits);

/// Whether all that is drawn of the model's quadrics is the nearer depth of a paraboloid that fits Z1 as it is, of
/// primitives that are compared with no other, and Z1 has room to work out light on them (QuadricBits::in_place). There
/// must be no colour beside Z1 and no effect.
bool draws_in_place(const facet::Geometry& geometry, const view::View& view, const Plan& plan, unsigned colour_bits);

/// Whether all that is drawn of the model's quadrics is the nearer depth of ellipsoids that fits Z1 as it is, of
/// primitives that are compared with no other (QuadricBits::root_in_candidate). There must be no colour beside Z1 and
/// no effect.
bool takes_roots_in_candidate(const facet::Geometry& geometry, const view::View& view, const Plan& plan);

enum class Root : std::uint8_t { near, far };

/// E stays 1 where the ray meets the quadric, or is in it if it is an edge test: no depths.
void emit_outline(const Context& context, Broadcast& out, const QuadricBound& bound, const view::PixelRect& pixels);

/// The root of the discriminant. E stays 1 where the ray meets the quadric, and for QuadricRole::until, whose
/// emit_depth has to follow, everywhere that it needs.
/// E has to be 0 outside `enabled`, which is `pixels` or a rectangle around them in which no other ray meets it.
void emit_root(const Context& context, Broadcast& out, const QuadricBound& bound, const view::PixelRect& pixels,
               const view::PixelRect& enabled);

/// Whether no ray of the rectangle meets the quadric but those through `pixels`, as far as bounds tell.
bool is_met_within(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels,
                   const view::PixelRect& rect);

/// A depth of the quadric where E is 1, after emit_root: returns the field that it is in, as wide as Z1: `into`, if one
/// is given that may be written, or the low part of the layout's sum. What is before
/// the depth range becomes 0, what is behind it the farthest. Leaves the root, and E as it was before an emit_root of
/// QuadricRole::until.
isa::Field emit_depth(const Context& context, Broadcast& out, const QuadricBound& bound, Root root,
                      const view::PixelRect& pixels, isa::Field into = {});

/// E := E and "Z1 is within the bound", by what matters in the block.
void emit_comparison(const Context& context, Broadcast& out, const QuadricBound& bound, const csg::Block& block);

}  // namespace csgsim::emit
