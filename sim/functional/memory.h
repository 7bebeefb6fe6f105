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

/// The pixel memory of a tile. Each bit is held in a plane or, while its field is used as a number, in lanes; the
/// form changes when an instruction needs the other. Compiled Programs use a field one way, so that it seldom changes;
/// where they write a field now as a whole and now in parts, as colours and their channels, it stays in parts.
class Memory {
 public:
  Memory(TileShape shape, std::uint32_t bits);

  /// Every bit 0, keeping the storage.
  void clear();

  /// The plane that holds the bit, to read and write.
  TileBits& plane(unsigned bit);

  /// The bit to read in those blocks, its form unchanged: the plane that holds it, or `copy` filled from lanes.
  const TileBits& read(unsigned bit, std::uint64_t blocks, TileBits& copy) const;

  /// Is the bit 0 everywhere, as far as that is known without a look at pixels?
  [[nodiscard]] bool is_zero(unsigned bit) const {
    return holder_[bit] == nullptr && (!planes_[bit] || planes_[bit]->any() == 0);
  }

  /// The lanes that hold exactly this field, to read and write.
  Lanes& lanes(isa::Field field);

  /// The fields, within that one and lowest first, whose lanes hold all of it; none unless there are several.
  [[nodiscard]] std::vector<isa::Field> parts(isa::Field field) const;

  /// Do lanes hold exactly this field?
  [[nodiscard]] bool in_lanes(isa::Field field) const {
    const Lanes* const holder = holder_[field.base];
    return holder != nullptr && holder->field == field;
  }
  /// Is every bit of the field held in a plane?
  [[nodiscard]] bool in_planes(isa::Field field) const;

  /// The field's value at every pixel, row after row, `stride` values from one to the next.
  void values(isa::Field field, std::uint32_t* out, std::size_t stride) const;

  /// The field's value at one pixel.
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const;

 private:
  TileBits& stored_plane(unsigned bit);
  Lanes& unused_lanes();
  /// Hands the lanes' bits to their planes.
  void spill(Lanes& lanes);

  TileShape shape_;
  std::vector<std::unique_ptr<TileBits>> planes_;  ///< none yet: 0; 0 too while lanes hold the bit
  std::vector<Lanes*> holder_;                     ///< for each bit the lanes that hold it, or none
  std::vector<std::unique_ptr<Lanes>> lanes_;      ///< of width 0: unused
};

}  // namespace csgsim::functional
