#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/scan_line/cell_alu.h"
#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

/// The cells of a chain. Each has a memory of words with so many ports, an enable bit, an adder of a word with its
/// carry, a shifter, an ALU, and registers: the words of F that have come in, two fields that have been read, and a
/// field to be written. The memory writes single bits of a word. For squares there is a second adder, which brings the
/// difference up to date, with its carry. Below a tree there are none of these adders. A root is taken by the ALU, in
/// the register of the first field read.
class Cells {
 public:
  Cells(std::uint32_t count, std::uint32_t memory_bits, const CellShape& shape);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(enable_.size()); }
  [[nodiscard]] std::uint32_t memory_bits() const { return memory_bits_; }

  /// Takes a word of F in, and makes of it and of the difference what the next cell gets.
  void add(std::uint32_t cell, PacketWord& word);

  /// Takes in the bits of F that a tree brings the cell with the beat.
  void take(std::uint32_t cell, const PacketWord& beat);

  /// The words of the packet's F that have come in so far.
  [[nodiscard]] std::uint64_t sum(std::uint32_t cell) const { return sum_[cell]; }

  /// Memory and enable become 0.
  void clear(std::uint32_t cell);

  /// What the ports read in the clock of that beat.
  void fetch(std::uint32_t cell, const PacketWord& beat);

  /// A clock of the shifter or of the ALU.
  void work(std::uint32_t cell, const PacketWord& beat);

  /// A clock of a root's trials, in which the ALU subtracts or adds the bits that it goes through in one.
  void try_root(std::uint32_t cell, const PacketWord& beat);

  /// Carries out a valid instruction, whose F and fields have come in, but for what is written. Throws std::logic_error
  /// if a field has not been read, the ALU is not through, or a root is not complete.
  void act(std::uint32_t cell, const PacketWord& beat);

  /// What the ports write in the clock of that beat.
  void store(std::uint32_t cell, const PacketWord& beat);

  /// What has been read of a field, of the first or the second.
  [[nodiscard]] std::uint64_t fetched(std::uint32_t cell, std::size_t field = 0) const {
    return fetched_[cell].at(field);
  }

  // For who compares registers.
  [[nodiscard]] bool carry(std::uint32_t cell) const { return carry_[cell] != 0; }  ///< of the running sum
  [[nodiscard]] bool difference_carry(std::uint32_t cell) const { return difference_carry_[cell] != 0; }
  [[nodiscard]] const CellAlu& alu(std::uint32_t cell) const { return alus_[cell]; }
  [[nodiscard]] bool writes(std::uint32_t cell) const { return writes_[cell] != 0; }  ///< the result

  [[nodiscard]] bool enabled(std::uint32_t cell) const { return enable_[cell] != 0; }
  [[nodiscard]] std::size_t cell_words() const { return cell_words_; }
  [[nodiscard]] std::span<const std::uint64_t> memory(std::uint32_t cell) const {
    return std::span(memory_).subspan(cell * cell_words_, cell_words_);
  }
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;

 private:
  /// What the ALU makes of an instruction.
  struct Result {
    bool enable = false;
    bool writes = false;
    std::uint64_t value = 0;
  };

  /// How far a root has come.
  struct Root {
    std::uint32_t bit = 0;    ///< of the root, the highest first
    std::uint32_t tried = 0;  ///< bits of the trial for it
    bool carry = false;       ///< out of these
    bool negative = false;    ///< the remainder
  };

  /// Adds a word to another; `carry` goes in, and is the carry out then.
  [[nodiscard]] std::uint64_t add_words(std::uint64_t one, std::uint64_t other, std::uint8_t& carry) const;
  [[nodiscard]] AluOperands operands_of(std::uint32_t cell, const isa::Instruction& instruction) const;
  [[nodiscard]] Result result_of(std::uint32_t cell, const isa::Instruction& instruction) const;
  [[nodiscard]] isa::Field part_in(const FieldWords& words, std::uint32_t word) const;

  std::uint32_t memory_bits_;
  CellShape shape_;
  std::uint64_t word_mask_;
  std::size_t cell_words_;
  std::vector<std::uint64_t> memory_;
  std::vector<std::uint64_t> sum_;
  std::vector<std::uint8_t> carry_;
  std::vector<std::uint8_t> difference_carry_;
  std::vector<std::uint8_t> enable_;
  std::vector<std::array<std::uint64_t, 2>> fetched_;
  std::vector<std::uint32_t> words_fetched_;  ///< of the packet
  std::vector<CellAlu> alus_;
  std::vector<Root> roots_;
  std::vector<std::uint64_t> result_;
  std::vector<std::uint8_t> writes_;  ///< whether the result is to be written
};

}  // namespace csgsim::scan_line
