#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/emit/context.h"
#include "host/emit/quadric_depths.h"

namespace csgsim::emit {

/// Where a facet is.
enum class At : std::uint8_t {
  plane,         ///< on the plane of its half-space
  near,          ///< at depth 0, where rounding has taken it
  cap,           ///< at depth 0, where the near plane cuts the primitive open; it has no half-space
  quadric_near,  ///< on the nearer of a quadric's depths; it has no half-space
  quadric_far,   ///< on the farther
};

constexpr bool is_curved(At at) { return at == At::quadric_near || at == At::quadric_far; }

/// A half-space of a primitive, or a quadric that bounds it, as what is seen of it.
struct Facet {
  std::uint32_t primitive = model::no_index;
  facet::Halfspace halfspace;
  At at = At::plane;
  facet::QuadricSide quadric{};  ///< if it is curved
};

/// The origin of what belongs to a facet of a surface.
isa::Origin origin_of(isa::Purpose purpose, const PlannedSurface& planned, const Facet& facet);

/// The facet that is seen of a quadric where nothing is before it; `complemented`: where its solid is taken away.
std::optional<Facet> seen_of(const QuadricBound& bound, bool complemented);

/// Where the facet, which is not curved, is: the plane of its half-space, or depth 0.
view::FixedLinear plane_of(const Context& context, const Facet& facet);

/// The half-spaces of a convex solid on one side that have to be broadcast for a block.
struct Deciding {
  std::vector<Facet> facets;  ///< in the order of primitives and faces
  bool nothing = false;       ///< one of them holds nothing of the block
};

/// Leaves out half-spaces that hold the whole block, if such pruning is asked for. Throws InputError, naming the
/// primitive, where the coefficients of one that decides do not fit the machine.
Deciding undecided(const Context& context, std::span<const std::uint32_t> set, view::Side side,
                   const csg::Block& block);

/// Also leaves out fronts nearer than another front and backs farther than another back, by a depth step at least, at
/// every corner of the block's pixels (thesis 7.3.3) or at every pixel, whichever is asked for. Throws as undecided
/// does.
Deciding deciding(const Context& context, std::span<const std::uint32_t> set, view::Side side, const csg::Block& block);

/// What has to be broadcast to draw a solid's surface in a block's pixels. Half-spaces decide over the whole depth
/// range, as Z1 is not known yet.
struct Sides {
  csg::Block column;  ///< the pixels, all depths
  Deciding fronts;
  Deciding backs;
  std::vector<QuadricBound> quadrics{};  ///< that are no edge tests
  std::uint32_t edges = 0;               ///< edge tests, of quadrics too
  bool nothing = false;                  ///< a quadric holds nothing of the column

  /// Half-spaces, edge tests included.
  [[nodiscard]] std::uint32_t count() const;
};

Sides deciding_sides(const Context& context, const PlannedSurface& planned);

/// Whether emit_edges broadcasts anything.
bool has_edges(const Context& context, std::uint32_t primitive, const csg::Block& block);

/// Edge tests of a primitive that cut the block, of its quadrics too: E stays 1 inside them.
void emit_edges(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block);

}  // namespace csgsim::emit
