#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

/// The cells of a chain: memory, enable bit, and an adder of `word_bits` bits with its carry.
class Cells {
 public:
  Cells(std::uint32_t count, std::uint32_t memory_bits, std::uint32_t word_bits);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(enable_.size()); }
  [[nodiscard]] std::uint32_t memory_bits() const { return memory_bits_; }

  /// Takes a word of F in, and makes of it what the next cell gets: F + A.
  void add(std::uint32_t cell, PacketWord& word);

  /// The words of the packet's F that have come in so far.
  [[nodiscard]] std::uint64_t sum(std::uint32_t cell) const { return sum_[cell]; }

  /// Memory and enable become 0.
  void clear(std::uint32_t cell);

  /// Carries out a valid instruction, whose F has come in.
  void act(std::uint32_t cell, const isa::Instruction& instruction);

  [[nodiscard]] bool enabled(std::uint32_t cell) const { return enable_[cell] != 0; }
  [[nodiscard]] std::size_t cell_words() const { return cell_words_; }
  [[nodiscard]] std::span<const std::uint64_t> memory(std::uint32_t cell) const {
    return std::span(memory_).subspan(cell * cell_words_, cell_words_);
  }
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;

 private:
  void write(std::uint32_t cell, isa::Field field, std::uint64_t value);
  void write_linear(std::uint32_t cell, isa::Field field, std::int64_t value);

  std::uint32_t memory_bits_;
  std::uint32_t word_bits_;
  std::uint64_t word_mask_;
  std::size_t cell_words_;
  std::vector<std::uint64_t> memory_;
  std::vector<std::uint64_t> sum_;
  std::vector<std::uint8_t> carry_;
  std::vector<std::uint8_t> enable_;
};

}  // namespace csgsim::scan_line
