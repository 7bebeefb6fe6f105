// Transparency by layers: depth peeling in pixel memory.
// Used by transparency.cpp and tests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/emit/effect.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// The transparent surfaces of a drawing, and the maximum number of layers that are visible at a pixel.
struct Panes {
  std::vector<unsigned> opacities;  ///< the distinct opacities in 1/256, from 1 to 255, ascending
  /// Per primitive: index into `opacities`; arbitrary for primitives that are not drawn.
  std::vector<std::uint32_t> kinds;
  std::vector<bool> drawn;  ///< per primitive: whether it is transparent, but not fully
  /// Per segment: maximum number of surfaces behind one another at a pixel.
  std::vector<unsigned> layers;
  std::uint32_t surfaces = 0;                      ///< maximum number of surfaces in a segment
  std::vector<std::vector<std::uint32_t>> pieces;  ///< per primitive: result of touching_pieces()
};

/// Maximum number of rectangles that share a pixel.
unsigned max_overlap(std::span<const view::PixelRect> rectangles);

/// The panes of a drawing, with at most `max_layers` layers.
Panes find_panes(const emit::Drawing& drawing, unsigned max_layers);

/// Fields that emit_layers() needs for all of these drawings. `has_owners`: whether colours are found by the number of
/// the surface. For 20 bits of depth and 24 bits of colour, one layer takes 44 bits and several layers take 120; the
/// index of an opacity, if opacities differ, and the number of an owner take additional bits.
std::vector<emit::FieldRequest> layer_fields(unsigned z_bits, unsigned colour_bits, std::span<const Panes* const> panes,
                                             bool has_owners);

/// Draws the panes over the colours of the drawing, whose depths are preserved. Rounding occurs when opacities are
/// converted to multiples of 1/256 (at least 1/256 unless 0, and at most 255/256), when the weight of a layer behind
/// others is computed, and once at the end: with n layers, a channel of 8 bits differs from exact blending of the
/// rounded colours by at most n levels, and by another half level if an opacity is above 511/512.
void emit_layers(const emit::Context& context, emit::Broadcast& out, const Panes& panes);

/// Clears E where the surface of a pane is inside another piece of the same solid or leaves the solid into it
/// (emit_outside()). Called before the depth test, when E is 1 at the pixels of the surface.
void emit_joints(const emit::Context& context, emit::Broadcast& out, const Panes& panes,
                 const emit::PlannedSurface& planned);

/// Writes the index of the primitive's opacity where E is 1, if opacities differ. Called after the merge of a pane.
void emit_opacity(const emit::Context& context, emit::Broadcast& out, const Panes& panes, std::uint32_t primitive);

}  // namespace csgsim::effects
