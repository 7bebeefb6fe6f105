// Memory of a divider that holds the records of a display model.
// Used by hw/pixel_square.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/display_model.h"
#include "hw/division/encoding.h"
#include "hw/isa/link_word.h"

namespace csgsim::division {

/// The records of a display model in a memory that is read word by word: each record begins at a new word, and all
/// records of a kind are equally wide (docs/machines/pixel-square.md).
class ModelMemory {
 public:
  ModelMemory() = default;
  /// `word_bits`: 1 to 256.
  ModelMemory(const DisplayModel& model, unsigned word_bits);

  [[nodiscard]] PrimitiveHead primitive(std::uint32_t index) const;
  /// Half-space `number` of a primitive, which must exist.
  [[nodiscard]] Halfspace halfspace(std::uint32_t primitive, std::uint32_t number) const;
  [[nodiscard]] Plane plane(std::uint32_t index) const;

  // Number of words of a record.
  [[nodiscard]] std::uint64_t primitive_words() const { return primitives_.record_words; }
  [[nodiscard]] std::uint64_t halfspace_words() const { return halfspaces_.record_words; }
  [[nodiscard]] std::uint64_t plane_words() const { return planes_.record_words; }
  [[nodiscard]] unsigned plane_bits() const { return widths_.plane_record(); }

 private:
  struct Records {
    std::uint64_t record_words = 0;
    std::vector<isa::LinkWord> words;
  };

  void add(const Bits& record, Records& records) const;
  [[nodiscard]] Bits read(const Records& records, std::size_t index) const;

  unsigned word_bits_ = 1;
  Widths widths_;
  Records primitives_;
  Records halfspaces_;
  Records planes_;
  /// Index of each primitive's first half-space among all half-spaces; in hardware, part of the tree's leaves.
  std::vector<std::size_t> first_halfspaces_;
};

}  // namespace csgsim::division
