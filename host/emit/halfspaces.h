// Facets and the half-spaces that decide a solid's surface in a block.
// Used by host/effects.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/emit/context.h"
#include "host/emit/quadric_depths.h"

namespace csgsim::emit {

/// The location of a facet.
enum class At : std::uint8_t {
  plane,         ///< on the plane of its half-space
  near,          ///< at depth 0, to which rounding moved it
  cap,           ///< at depth 0, where the near plane cuts the primitive open; no half-space
  quadric_near,  ///< on the nearer depth of a quadric; no half-space
  quadric_far,   ///< on the farther depth of a quadric; no half-space
};

constexpr bool is_curved(At at) { return at == At::quadric_near || at == At::quadric_far; }

/// The visible part of a half-space of a primitive, or of a quadric that bounds it.
struct Facet {
  std::uint32_t primitive = model::no_index;
  facet::Halfspace halfspace;
  At at = At::plane;
  facet::QuadricSide quadric{};  ///< valid if the facet is curved
};

/// The origin of instructions for a facet of a surface.
isa::Origin facet_origin(isa::Purpose purpose, const PlannedSurface& planned, const Facet& facet);

/// The visible facet of a quadric with nothing in front of it. `complemented`: the solid is subtracted.
std::optional<Facet> visible_facet(const QuadricBound& bound, bool complemented);

/// The plane of a facet that is not curved: that of its half-space, or depth 0.
view::FixedLinear facet_plane(const Context& context, const Facet& facet);

/// The half-spaces of a convex solid on one side that must be broadcast for a block.
struct DecidingFacets {
  std::vector<Facet> facets;  ///< in the order of primitives and faces
  bool nothing = false;       ///< a half-space contains no point of the block
};

/// Drops half-spaces that contain the whole block, if that pruning is on. Throws InputError, naming the primitive, if
/// the coefficients of a remaining one do not fit the machine.
DecidingFacets cutting_facets(const Context& context, std::span<const std::uint32_t> set, view::Side side,
                              const csg::Block& block);

/// Also drops fronts nearer than another front, and backs farther than another back, by at least a depth step at every
/// corner of the block's pixels (thesis 7.3.3) or at every pixel, depending on the pruning. Throws as cutting_facets
/// does.
DecidingFacets deciding_facets(const Context& context, std::span<const std::uint32_t> set, view::Side side,
                               const csg::Block& block);

/// The half-spaces and quadrics that must be broadcast to draw a solid's surface in a block's pixels. The half-spaces
/// are tested over all depths, because Z1 is unknown before.
struct Sides {
  csg::Block column;  ///< the pixels, all depths
  DecidingFacets fronts;
  DecidingFacets backs;
  std::vector<QuadricBound> quadrics{};  ///< quadrics that are not edge tests
  std::uint32_t edges = 0;               ///< number of edge tests, including those of quadrics
  bool nothing = false;                  ///< a quadric contains no point of the column

  /// Number of half-spaces and quadrics, including edge tests.
  [[nodiscard]] std::uint32_t count() const;
};

Sides deciding_sides(const Context& context, const PlannedSurface& planned);

/// Whether emit_edges() would append any instruction.
bool has_edges(const Context& context, std::uint32_t primitive, const csg::Block& block);

/// Appends the edge tests of a primitive, and of its quadrics, that cut the block: E stays 1 inside them.
void emit_edges(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block);

}  // namespace csgsim::emit
