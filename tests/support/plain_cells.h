#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hw/scan_line/packet.h"

/// Cells of a scan-line array that do each clock's work at once, one cell after another.
namespace csgsim::test {

using scan_line::CellShape;
using scan_line::CellWork;
using scan_line::FieldWords;

/// A beat as it comes into a cell, with the words that the cell before has made.
struct PlainBeat : scan_line::Packet {
  std::uint32_t number = 0;
  std::uint64_t f = 0;
  std::uint64_t a = 0;
  std::uint64_t aa = 0;

  [[nodiscard]] bool last() const { return number + 1 == beats; }
};

/// The numbers that the ALU meets.
struct AluOperands {
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  std::uint32_t field_bits = 0;  ///< of the field that x is meant to fit
};

/// What a cell's shifter and ALU have come to with the operands of a packet.
class PlainAlu {
 public:
  void begin() { *this = {}; }

  /// A clock: a word moves on, or, if all lie where they are wanted, the ALU takes the next bits.
  void clock(const CellWork& work, const AluOperands& operands, const CellShape& cell);

  /// Nothing is left to do.
  [[nodiscard]] bool done(const CellWork& work, const CellShape& cell) const;

  [[nodiscard]] std::uint64_t value() const { return value_; }  ///< the low bits
  // Of a difference x - y:
  [[nodiscard]] bool less() const { return negative_x_ != negative_y_ ? negative_x_ : negative_; }  ///< with signs
  [[nodiscard]] bool below() const { return carry_; }                                               ///< without
  [[nodiscard]] bool equal() const { return !differs_; }
  [[nodiscard]] bool fits() const { return !negative_x_ && !beyond_; }  ///< x the field

 private:
  [[nodiscard]] bool moves(const CellWork& work, const CellShape& cell) const;
  void move_on(const CellWork& work, const CellShape& cell);
  void take(const CellWork& work, const AluOperands& operands, std::uint32_t count);

  std::size_t move_ = 0;     ///< of the work's
  std::uint32_t word_ = 0;   ///< of its operand
  std::uint32_t moved_ = 0;  ///< bits, of that word
  std::uint32_t taken_ = 0;  ///< bits that the ALU has gone through
  std::uint64_t value_ = 0;  ///< of these
  bool carry_ = false;       ///< out of them; of a difference the borrow
  bool differs_ = false;     ///< a bit of the difference is 1
  bool beyond_ = false;      ///< a bit of x above the field is
  bool negative_ = false;    ///< the highest bit of the value
  bool negative_x_ = false;  ///< and of the operands
  bool negative_y_ = false;
};

/// Each cell has a memory of words with so many ports, an enable bit, an adder of a word with its carry, a shifter, an
/// ALU, and registers: the words of F that have come in, two fields that have been read, and a field to be written. For
/// squares there is a second adder, which brings the difference up to date, with its carry. Below a tree there are none
/// of these adders.
class PlainCells {
 public:
  PlainCells(std::uint32_t count, std::uint32_t memory_bits, const CellShape& shape);

  /// Takes a word of F in, and makes of it and of the difference what the next cell gets.
  void add(std::uint32_t cell, PlainBeat& word);

  /// Takes in the bits of F that a tree brings the cell with the beat.
  void take(std::uint32_t cell, const PlainBeat& beat);

  /// The words of the packet's F that have come in so far.
  [[nodiscard]] std::uint64_t sum(std::uint32_t cell) const { return sum_[cell]; }

  /// Memory and enable become 0.
  void clear(std::uint32_t cell);

  /// What the ports read in the clock of that beat.
  void fetch(std::uint32_t cell, const PlainBeat& beat);

  /// A clock of the shifter or of the ALU.
  void work(std::uint32_t cell, const PlainBeat& beat);

  /// A clock of a root's trials, in which the ALU subtracts or adds the bits that it goes through in one.
  void try_root(std::uint32_t cell, const PlainBeat& beat);

  /// Carries out a valid instruction, whose F and fields have come in, but for what is written. Throws std::logic_error
  /// if a field has not been read, the ALU is not through, or a root is not complete.
  void act(std::uint32_t cell, const PlainBeat& beat);

  /// What the ports write in the clock of that beat.
  void store(std::uint32_t cell, const PlainBeat& beat);

  /// What has been read of a field, of the first or the second.
  [[nodiscard]] std::uint64_t fetched(std::uint32_t cell, std::size_t field = 0) const {
    return fetched_[cell].at(field);
  }
  [[nodiscard]] bool carry(std::uint32_t cell) const { return carry_[cell] != 0; }  ///< of the running sum
  [[nodiscard]] bool difference_carry(std::uint32_t cell) const { return difference_carry_[cell] != 0; }
  [[nodiscard]] const PlainAlu& alu(std::uint32_t cell) const { return alus_[cell]; }
  [[nodiscard]] bool writes(std::uint32_t cell) const { return writes_[cell] != 0; }  ///< the result

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(enable_.size()); }
  [[nodiscard]] bool enabled(std::uint32_t cell) const { return enable_[cell] != 0; }
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
  std::vector<PlainAlu> alus_;
  std::vector<Root> roots_;
  std::vector<std::uint64_t> result_;
  std::vector<std::uint8_t> writes_;  ///< whether the result is to be written
};

/// Such cells behind one another, through which beats move on by one a clock, or below a tree whose levels they go
/// down.
class PlainChain {
 public:
  PlainChain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape);

  /// One clock, in which that beat is in cell 0, or at the root of the tree.
  void step(const scan_line::Beat& entering);

  [[nodiscard]] const PlainCells& cells() const { return cells_; }

  /// The beat that is in that cell in the clock that comes, if one is.
  [[nodiscard]] const PlainBeat* beat_in(std::uint32_t cell) const;

 private:
  struct Flight {
    PlainBeat beat;
    std::uint32_t moved = 0;  ///< clocks since it entered
  };

  [[nodiscard]] std::uint32_t clocks_to(std::uint32_t cell) const;
  void work(PlainBeat& beat, std::uint32_t cell);

  CellShape shape_;
  PlainCells cells_;
  std::vector<Flight> flights_;
};

}  // namespace csgsim::test
