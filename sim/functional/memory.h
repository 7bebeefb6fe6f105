// The pixel memory of a tile, as bit planes or lanes.
// Used by tile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "sim/functional/lanes.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// The blocks of a tile on which an instruction works, and those among them in which it overwrites the field at all
/// pixels.
struct TargetBlocks {
  std::uint64_t blocks = ~std::uint64_t{0};
  std::uint64_t overwritten = 0;
};

/// The pixel memory of a tile. In each block, a bit is stored in a plane or, while its field is used as a number, in
/// lanes; the form changes when an instruction needs the other one, and only in the blocks on which it works. Compiled
/// Programs mostly use a field in one way, so that this is rare; a field that is also written part by part, as a
/// colour is by channel, is kept in the lanes of its parts.
class Memory {
 public:
  static constexpr std::uint64_t all_blocks = ~std::uint64_t{0};

  Memory(TileShape shape, std::uint32_t bits);

  /// Clears every bit, keeping the storage.
  void clear();

  /// The plane that stores the bit in those blocks, for reading and writing there.
  TileBits& plane(unsigned bit, std::uint64_t blocks = all_blocks);

  /// The planes that store a field in the target blocks, lowest bit first. `planes` must have room for them.
  void planes(isa::Field field, const TargetBlocks& target, std::span<TileBits*> planes);

  /// Reads the bit in those blocks without changing its form: returns the plane that stores it or, if lanes store it,
  /// `copy`, filled from them.
  const TileBits& read(unsigned bit, std::uint64_t blocks, TileBits& copy) const;

  /// Whether the bit is known to be 0 everywhere without examining pixels.
  [[nodiscard]] bool is_zero(unsigned bit) const {
    return (!planes_[bit] || planes_[bit]->any() == 0) && (holder_counts_[bit] == 0 || is_in_planes({to_base(bit), 1}));
  }

  /// The lanes that store exactly this field in those blocks, for reading and writing there. The lanes returned by the
  /// previous call stay valid if its field is disjoint.
  Lanes& lanes(isa::Field field, const TargetBlocks& target = {});

  /// The fields within the given one, lowest first, whose lanes store all of it in those blocks; empty unless there are
  /// several.
  [[nodiscard]] std::vector<isa::Field> parts(isa::Field field, std::uint64_t blocks = all_blocks) const;

  /// Whether lanes store exactly this field in those blocks.
  [[nodiscard]] bool is_in_lanes(isa::Field field, std::uint64_t blocks = all_blocks) const;
  /// Whether planes store every bit of the field in those blocks.
  [[nodiscard]] bool is_in_planes(isa::Field field, std::uint64_t blocks = all_blocks) const;

  /// Writes the field's value at every pixel, row by row, with `stride` values per row.
  void values(isa::Field field, std::uint32_t* out, std::size_t stride) const;

  /// The field's value at one pixel.
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const;

 private:
  /// Lanes, and the blocks in which they store their field's bits.
  struct Holder {
    isa::Field field;
    std::uint64_t blocks = 0;
    std::unique_ptr<Lanes> lanes;
  };

  static std::uint16_t to_base(unsigned bit) { return static_cast<std::uint16_t>(bit); }
  TileBits& stored_plane(unsigned bit);
  Holder& holder_for(isa::Field field);
  Holder& add_holder();
  void set_field(Holder& holder, isa::Field field);
  /// A holder in use that can be replaced, other than the last one requested.
  Holder& reused_holder();
  /// Converts the field to lanes, at least in the target blocks.
  void convert_to_lanes(Holder& holder, const TargetBlocks& target);
  /// Moves the bits of `to`'s field from the lanes of `from` in those blocks; in `kept` the values are preserved.
  void move(Holder& from, Holder& to, std::uint64_t blocks, std::uint64_t kept);
  /// Blocks in which the field is the same at all pixels, so that conversion to lanes is free.
  [[nodiscard]] std::uint64_t uniform_blocks(isa::Field field) const;
  /// Writes the lanes' bits in those blocks to their planes.
  void spill(Holder& holder, std::uint64_t blocks);
  /// Writes the bits of a field that the lanes store to their planes.
  void write_planes(const Holder& holder, isa::Field field, std::uint64_t blocks);

  TileShape shape_;
  std::vector<std::unique_ptr<TileBits>> planes_;  ///< null or cleared: 0; also 0 where lanes store the bit
  std::vector<Holder> holders_;                    ///< no two store a bit in the same block
  std::vector<std::uint8_t> holder_counts_;        ///< for each bit, the number of holders whose field contains it
  std::size_t next_reused_ = 0;                    ///< index of the next holder to replace, once all are in use
  Lanes* last_ = nullptr;                          ///< last lanes requested
};

}  // namespace csgsim::functional
