// Depths of quadrics at the pixels, and comparisons with them.
// Used by the emitter's surfaces, half-spaces and stored depths.
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

/// The bounds of a primitive. Throws InputError, naming the primitive, if one does not fit the machine.
std::vector<QuadricBound> quadric_bounds(const Context& context, std::uint32_t primitive);

/// Whether every point of the block, or none, is within the bound; Containment::depends if the pruning `halfspaces` is
/// off.
csg::Containment locate_block(const Context& context, const QuadricBound& bound, const csg::Block& block);

/// The parts of a bound that matter to the points of a block.
struct RelevantParts {
  bool outline = true;  ///< whether the ray meets the quadric
  bool near = true;
  bool far = true;
};

RelevantParts relevant_parts(const Context& context, const QuadricBound& bound, const csg::Block& block);

/// Whether the depth of the bound's visible side, which may be the nearer or the farther one, may be 0 or less at some
/// of the pixels.
bool may_reach_near(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels);

/// Bits for the quadrics of the model, and for light on them in colours of `colour_bits` bits.
QuadricBits quadric_bits(const facet::Geometry& geometry, const view::View& view, unsigned colour_bits);

/// Whether the only quadric depths drawn are nearer depths of paraboloids that fit Z1 unclamped, of primitives that are
/// not compared with others, and Z1 has room for computing the light (QuadricBits::in_place). There must be no colour
/// field for Z1 and no effect.
bool draws_in_place(const facet::Geometry& geometry, const view::View& view, const Plan& plan, unsigned colour_bits);

/// Whether the only quadric depths drawn are nearer depths of ellipsoids that fit Z1 unclamped, of primitives that are
/// not compared with others (QuadricBits::root_in_candidate). There must be no colour field for Z1 and no effect.
bool takes_roots_in_candidate(const facet::Geometry& geometry, const view::View& view, const Plan& plan);

enum class Root : std::uint8_t { near, far };

/// E stays 1 where the ray meets the quadric, or is inside it if it is an edge test. Computes no depth.
void emit_outline(const Context& context, Broadcast& out, const QuadricBound& bound, const view::PixelRect& pixels);

/// Computes the root of the discriminant. E stays 1 where the ray meets the quadric; for QuadricRole::until, it stays 1
/// at all pixels that emit_depth, which has to follow, needs. E must be 0 outside `enabled`, which is `pixels` or a
/// rectangle around them in which no other ray meets the quadric.
void emit_root(const Context& context, Broadcast& out, const QuadricBound& bound, const view::PixelRect& pixels,
               const view::PixelRect& enabled);

/// Whether bounds prove that no ray of `enclosing` outside `pixels` meets the quadric.
bool is_met_within(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels,
                   const view::PixelRect& enclosing);

/// Computes a depth of the quadric where E is 1, after emit_root. Returns the field that holds it, as wide as Z1:
/// `into` if given and writable, else the low part of the layout's sum. Depths are clamped to the depth range.
/// Preserves the root; restores E as it was before an emit_root of QuadricRole::until.
isa::Field emit_depth(const Context& context, Broadcast& out, const QuadricBound& bound, Root root,
                      const view::PixelRect& pixels, isa::Field into = {});

/// E := E and "Z1 is within the bound", tested with the parts that matter in the block.
void emit_comparison(const Context& context, Broadcast& out, const QuadricBound& bound, const csg::Block& block);

}  // namespace csgsim::emit
