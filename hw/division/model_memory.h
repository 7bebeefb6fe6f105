#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/display_model.h"
#include "hw/division/encoding.h"
#include "hw/isa/link_word.h"

namespace csgsim::division {

/// The records of a display model as a memory keeps them that is read a word at a time: each begins at a new word, and
/// those of a kind have one width (docs/machines/pixel-square.md).
class ModelMemory {
 public:
  ModelMemory() = default;
  /// Words of 1 to 256 bits.
  ModelMemory(const DisplayModel& model, unsigned word_bits);

  [[nodiscard]] PrimitiveHead primitive(std::uint32_t index) const;
  /// Of a primitive, which has to have it.
  [[nodiscard]] Halfspace halfspace(std::uint32_t primitive, std::uint32_t number) const;
  [[nodiscard]] Plane plane(std::uint32_t index) const;

  // Words of a record.
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
  std::vector<std::size_t> first_halfspaces_;  ///< of each primitive its first among all: the tree's leaves hold it
};

}  // namespace csgsim::division
