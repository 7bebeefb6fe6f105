#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "sim/functional/bit_plane.h"
#include "sim/functional/rect.h"

namespace csgsim::sim {

/// A field's value at every pixel; 0 outside `bounds`.
struct Lanes {
  isa::Field field;
  std::vector<std::uint32_t> values;
  Rect bounds;
};

/// The pixel memory of an array. Each bit is held in a bit plane or, while its field is used as a number, in lanes; the
/// form changes when an instruction needs the other. Compiled Programs use a field one way, so that it seldom changes;
/// where they write a field now as a whole and now in parts, as colours and their channels, it stays in parts.
class Memory {
 public:
  Memory(std::uint32_t width, std::uint32_t height, std::uint32_t bits);

  /// Every bit 0, keeping the storage.
  void clear();

  /// The plane that holds the bit, to read and write.
  BitPlane& plane(unsigned bit);

  /// The bit to read where the rectangle is, its form unchanged: the plane that holds it, or `copy` filled from lanes.
  const BitPlane& read(unsigned bit, const Rect& where, BitPlane& copy) const;

  /// The lanes that hold exactly this field, to read and write.
  Lanes& lanes(isa::Field field);

  /// The lane of the block's first pixel, if the block's cells are those of the rectangle.
  [[nodiscard]] std::uint32_t* at(Lanes& lanes, const Rect& rect) const {
    const Cells cells(rect);
    return lanes.values.data() + first_lane(cells.row, cells.column);
  }

  /// The fields, within that one and lowest first, whose lanes hold all of it; none unless there are several.
  [[nodiscard]] std::vector<isa::Field> parts(isa::Field field) const;

  /// Is every bit of the field held in a plane?
  [[nodiscard]] bool in_planes(isa::Field field) const;

  /// The field's value at every pixel, in row order without padding.
  void values(isa::Field field, std::span<std::uint32_t> out) const;

 private:
  [[nodiscard]] std::size_t first_lane(std::uint32_t row, std::uint32_t column) const {
    return (static_cast<std::size_t>(row) * words_per_row_ + column) * word_bits;
  }
  BitPlane& stored_plane(unsigned bit);
  Lanes& unused_lanes();
  /// Hands the lanes' bits to their planes.
  void spill(Lanes& lanes);
  void set_to_zero(Lanes& lanes) const;

  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t words_per_row_;
  std::vector<std::unique_ptr<BitPlane>> planes_;  ///< none yet: 0; 0 too while lanes hold the bit
  std::vector<Lanes*> holder_;                     ///< for each bit the lanes that hold it, or none
  std::vector<std::unique_ptr<Lanes>> lanes_;      ///< of width 0: unused, all values 0
};

}  // namespace csgsim::sim
