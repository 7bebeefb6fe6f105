#pragma once

#include <cstdint>
#include <span>

#include "sim/engine/work.h"
#include "sim/functional/lanes.h"
#include "sim/functional/tile_bits.h"

// Loops over lanes, each compiled for several instruction sets and chosen at run time. Bounds are kept up to date.

namespace csgsim::functional {

/// Whether a block's bounds, or F's at its corners, may decide for all its pixels. Where they may not, every lane is
/// looked at, for a test to hold the decisions against.
enum class Decide : std::uint8_t { by_block, by_pixel };

/// The pixels of a tile that a kernel works on.
struct Enabled {
  TileBits& enable;
  const TileShape& shape;
  Decide decide;
  engine::Work& work;
};

/// How many pixels have a one.
std::uint32_t count_ones(const TileBits& bits, const TileShape& shape);

/// Where enabled: lanes := value.
void set_lanes(const Enabled& pixels, Lanes& lanes, std::uint32_t value);

/// Where enabled: target := source.
void copy_lanes(const Enabled& pixels, Lanes& target, const Lanes& source);

/// Where enabled: target := the low bits of target + source.
void add_lanes(const Enabled& pixels, Lanes& target, const Lanes& source, std::uint32_t low_bits);

enum class Comparison : std::uint8_t { less, less_or_equal, equal };

/// enable := enable and left ? right. Returns how many pixels are enabled then.
std::uint32_t compare_lanes(const Enabled& pixels, Comparison comparison, const Lanes& left, const Lanes& right);

/// Writes the values of a block that is constant; until its bounds are changed it stays so.
void fill_block(Lanes& lanes, unsigned block);

/// Makes the block's bounds those of its values.
void find_bounds(Lanes& lanes, unsigned block);

/// In those blocks: planes := bits of the values, from bit `first` on.
void gather_planes(const Lanes& lanes, const TileShape& shape, std::uint64_t blocks, unsigned first,
                   std::span<TileBits* const> planes);

/// In those blocks: values := the planes' bits, the lowest first; one that there is none of is 0.
void scatter_planes(std::span<const TileBits* const> planes, const TileShape& shape, std::uint64_t blocks,
                    Lanes& lanes);

/// In those blocks: the bits of the target's field that are the source's too, `part`, become what they are there. They
/// are 0 before.
void merge_lanes(const Lanes& source, isa::Field part, std::uint64_t blocks, Lanes& target);

}  // namespace csgsim::functional
