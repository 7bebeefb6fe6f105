// Vectorized operations on lanes, the numeric form of a tile's fields.
// Used by tile and memory.
#pragma once

#include <cstdint>
#include <span>

#include "sim/engine/work.h"
#include "sim/functional/lanes.h"
#include "sim/functional/tile_bits.h"

// Loops over lanes, compiled for several instruction sets and dispatched at run time. They update the bounds of blocks.

namespace csgsim::functional {

/// Whether a block's bounds, or F at its corners, may decide for all its pixels. by_pixel examines every lane; tests
/// compare both.
enum class Decide : std::uint8_t { by_block, by_pixel };

/// The pixels on which a kernel works: those of a tile that are enabled.
struct EnabledPixels {
  TileBits& enable;
  const TileShape& shape;
  Decide decide;
  engine::Work& work;
};

/// Number of pixels whose bit is 1.
std::uint32_t count_ones(const TileBits& bits, const TileShape& shape);

/// lanes := value where enabled.
void set_lanes(const EnabledPixels& pixels, Lanes& lanes, std::uint32_t value);

/// target := source where enabled.
void copy_lanes(const EnabledPixels& pixels, Lanes& target, const Lanes& source);

/// target := the low bits of target + source where enabled.
void add_lanes(const EnabledPixels& pixels, Lanes& target, const Lanes& source, std::uint32_t low_bits);

enum class Comparison : std::uint8_t { less, less_or_equal, equal };

/// enable := enable and (left OP right), where OP is the comparison. Returns the number of pixels enabled afterwards.
std::uint32_t compare_lanes(const EnabledPixels& pixels, Comparison comparison, const Lanes& left, const Lanes& right);

/// Sets every value of a constant block to its bound. Values of constant blocks are otherwise undefined. The block
/// counts as constant until its bounds are changed.
void fill_block(Lanes& lanes, unsigned block);

/// Recomputes the block's bounds from its values.
void find_bounds(Lanes& lanes, unsigned block);

/// planes := bits of the values, from bit `first_bit` on, in the given blocks.
void gather_planes(const Lanes& lanes, const TileShape& shape, std::uint64_t block_mask, unsigned first_bit,
                   std::span<TileBits* const> planes);

/// values := the planes' bits, lowest first, in the given blocks; a missing plane counts as 0.
void scatter_planes(std::span<const TileBits* const> planes, const TileShape& shape, std::uint64_t block_mask,
                    Lanes& lanes);

/// Copies the bits `part`, which are in both fields, from the source to the target in the given blocks. They must be 0
/// in the target before.
void merge_lanes(const Lanes& source, isa::Field part, std::uint64_t block_mask, Lanes& target);

}  // namespace csgsim::functional
