#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// The regions of the machine's picture, in the order in which it draws them.
std::vector<isa::Region> regions(const Machine& machine);

/// How a machine divides the model itself, by the rules of docs/machines/pixel-square.md: the host sends it the model
/// as the camera sees it, and it makes the instructions of each region.
struct Division {
  /// Regions of a group, along a row and down, for the first of two levels; 0 if there is one level.
  std::uint32_t group_side = 0;
  std::uint64_t list_entries = 0;  ///< that what a group leaves has to fit
  /// The groups themselves, in the order in which the machine draws them, where they are no such squares of regions.
  std::vector<isa::Region> groups{};

  bool operator==(const Division&) const = default;
};

/// None, if the host divides the model.
std::optional<Division> division(const Machine& machine);

/// The field of pixel memory into which a finished picture of so many bits of colour is copied, to be shown while the
/// next is drawn; of width 0, if it is shown from where it was drawn.
isa::Field second_buffer(std::uint32_t colour_bits, const Machine& machine);

/// Whether its host keeps a list of what is active on a line: its Programs say the rows of each piece.
bool keeps_active_list(const Machine& machine);

/// Whether the controller learns if any pixel is enabled.
bool has_global_or(const Machine& machine);

}  // namespace csgsim::machines
