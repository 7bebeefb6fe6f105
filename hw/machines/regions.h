// Regions of the picture, and other properties of a machine that the compiler needs. Used by hw/host, hw/pixel_planes,
// hw/pixel_square, hw/process, host/effects, host/emit and sim/studies.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// The regions of the machine's picture, in the order in which it draws them.
std::vector<isa::Region> regions(const Machine& machine);

/// How a machine divides the model itself, by the rules of docs/machines/pixel-square.md: the host sends the model as
/// seen by the camera, and the machine computes the instructions of each region.
struct Division {
  /// Side of a group in regions, for the first of two levels; 0 for a single level.
  std::uint32_t group_side = 0;
  /// Maximum number of primitives and half-spaces that may remain after the first level.
  std::uint64_t list_entries = 0;
  /// Explicit groups, in the order in which the machine draws them, if they are not squares of regions.
  std::vector<isa::Region> groups{};

  bool operator==(const Division&) const = default;
};

/// The division that the machine performs; empty if the host divides the model.
std::optional<Division> division(const Machine& machine);

/// The field of pixel memory to which a finished picture with `colour_bits` bits of colour is copied, to be displayed
/// while the next picture is drawn. Its width is 0 if the picture is displayed from the field in which it was drawn.
isa::Field second_buffer(std::uint32_t colour_bits, const Machine& machine);

/// Whether the host keeps an active list per line; Programs then contain the row extent of each piece.
bool keeps_active_list(const Machine& machine);

/// Whether the controller can test if any pixel is enabled.
bool has_global_or(const Machine& machine);

}  // namespace csgsim::machines
