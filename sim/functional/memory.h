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

/// Blocks of a tile that an instruction works on, and those of them at all of whose pixels it writes the field,
/// whatever was there.
struct Worked {
  std::uint64_t blocks = ~std::uint64_t{0};
  std::uint64_t overwritten = 0;
};

/// The pixel memory of a tile. In each block a bit is held in a plane or, while its field is used as a number, in
/// lanes; the form changes when an instruction needs the other, in the blocks that it works on alone. Compiled Programs
/// mostly use a field one way, so that it seldom changes; where they write a field now as a whole and now in parts, as
/// colours and their channels, it stays in parts.
class Memory {
 public:
  static constexpr std::uint64_t all_blocks = ~std::uint64_t{0};

  Memory(TileShape shape, std::uint32_t bits);

  /// Every bit 0, keeping the storage.
  void clear();

  /// The plane that holds the bit in those blocks, to read and write there.
  TileBits& plane(unsigned bit, std::uint64_t blocks = all_blocks);

  /// The planes that hold a field in the blocks that are worked on, the lowest bit first. `planes` has room for them.
  void planes(isa::Field field, const Worked& worked, std::span<TileBits*> planes);

  /// The bit to read in those blocks, its form unchanged: the plane that holds it, or `copy` filled from lanes.
  const TileBits& read(unsigned bit, std::uint64_t blocks, TileBits& copy) const;

  /// Is the bit 0 everywhere, as far as that is known without a look at pixels?
  [[nodiscard]] bool is_zero(unsigned bit) const {
    return (!planes_[bit] || planes_[bit]->any() == 0) && (holders_of_[bit] == 0 || in_planes({base_of(bit), 1}));
  }

  /// The lanes that hold exactly this field in those blocks, to read and write there; so do those that were asked for
  /// before these, of a field apart.
  Lanes& lanes(isa::Field field, const Worked& worked = {});

  /// The fields, within that one and lowest first, whose lanes hold all of it in those blocks; none unless there are
  /// several.
  [[nodiscard]] std::vector<isa::Field> parts(isa::Field field, std::uint64_t blocks = all_blocks) const;

  /// Do lanes hold exactly this field in those blocks?
  [[nodiscard]] bool in_lanes(isa::Field field, std::uint64_t blocks = all_blocks) const;
  /// Is every bit of the field held in a plane in those blocks?
  [[nodiscard]] bool in_planes(isa::Field field, std::uint64_t blocks = all_blocks) const;

  /// The field's value at every pixel, row after row, `stride` values from one to the next.
  void values(isa::Field field, std::uint32_t* out, std::size_t stride) const;

  /// The field's value at one pixel.
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const;

 private:
  /// Lanes, and the blocks in which they hold their field's bits.
  struct Holder {
    isa::Field field;
    std::uint64_t blocks = 0;
    std::unique_ptr<Lanes> lanes;
  };

  static std::uint16_t base_of(unsigned bit) { return static_cast<std::uint16_t>(bit); }
  TileBits& stored_plane(unsigned bit);
  Holder& holder_for(isa::Field field);
  Holder& add_holder();
  void set_field(Holder& holder, isa::Field field);
  /// One that is in use, but not the last that was asked for.
  Holder& reused_holder();
  /// Into lanes, in the blocks that are worked on at least.
  void take(Holder& holder, const Worked& worked);
  /// What lanes hold of others' field in those blocks goes over to them, in `kept` with its value.
  void move(Holder& from, Holder& to, std::uint64_t blocks, std::uint64_t kept);
  /// Blocks that lanes of the field can take for nothing, since it is the same at all their pixels.
  [[nodiscard]] std::uint64_t even_blocks(isa::Field field) const;
  /// Hands the lanes' bits in those blocks to their planes.
  void spill(Holder& holder, std::uint64_t blocks);
  /// Writes those of a field that the lanes hold to their planes.
  void write_planes(const Holder& holder, isa::Field field, std::uint64_t blocks);

  TileShape shape_;
  std::vector<std::unique_ptr<TileBits>> planes_;  ///< none yet: 0; 0 too where lanes hold the bit
  std::vector<Holder> holders_;                    ///< no two hold a bit in the same block
  std::vector<std::uint8_t> holders_of_;           ///< for each bit, how many have it in their field
  std::size_t next_reused_ = 0;                    ///< of holders_, where all are in use
  Lanes* last_ = nullptr;                          ///< asked for
};

}  // namespace csgsim::functional
