#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/emit/effect.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// The see-through surfaces of a drawing, and how many may be seen behind one another.
struct Panes {
  std::vector<unsigned> opacities;                 ///< that there are, in 1/256, from 1 to 255, ascending
  std::vector<std::uint32_t> kinds;                ///< by primitive: place among them; any for those that are not drawn
  std::vector<bool> drawn;                         ///< by primitive: whether it is see-through, and not wholly clear
  std::vector<unsigned> layers;                    ///< by segment: surfaces behind one another at a pixel, at most
  std::uint32_t surfaces = 0;                      ///< most that a segment has
  std::vector<std::vector<std::uint32_t>> pieces;  ///< by primitive: touching_pieces
};

/// Rectangles that have a pixel in common, the most that there are.
unsigned most_overlapping(std::span<const view::PixelRect> rectangles);

/// At most that many layers.
Panes panes_of(const emit::Drawing& drawing, unsigned most_layers);

/// What emit_layers needs for all of these drawings; `has_owners`: colours are found by the number of the surface. For
/// depths of 20 bits and colours of 24 it is 44 bits for one layer and 120 for several, and the bits of the number of
/// an opacity, where they differ, and of an owner.
std::vector<emit::FieldRequest> layer_fields(unsigned z_bits, unsigned colour_bits, std::span<const Panes* const> panes,
                                             bool has_owners);

/// Draws the panes over the colours of the drawing, whose depths stay. Blending is rounded where opacities become
/// multiples of 1/256 (1/256 at least unless it is 0, 255/256 at most), where the part that a layer behind others has
/// does, and once at the end: with n layers a channel of 8 bits is off from exact blending of the rounded colours by n
/// levels at most, half a level more if an opacity is above 511/512.
void emit_layers(const emit::Context& context, emit::Broadcast& out, const Panes& panes);

/// Before the depth test of a pane, where E is 1 at the pixels that have its surface.
void emit_joints(const emit::Context& context, emit::Broadcast& out, const Panes& panes,
                 const emit::PlannedSurface& planned);

/// After the merge of a pane.
void emit_opacity(const emit::Context& context, emit::Broadcast& out, const Panes& panes, std::uint32_t primitive);

}  // namespace csgsim::effects
