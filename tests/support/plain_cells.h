#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hw/scan_line/packet.h"

/// Reference cells of a scan-line array: each clock's work is performed immediately, one cell after another.
namespace csgsim::test {

using scan_line::CellShape;
using scan_line::CellWork;
using scan_line::FieldWords;

/// Beat as it enters a cell, with the words that the previous cell computed.
struct PlainBeat : scan_line::Packet {
  std::uint32_t number = 0;
  std::uint64_t f = 0;
  std::uint64_t a = 0;
  std::uint64_t aa = 0;

  [[nodiscard]] bool last() const { return number + 1 == beats; }
};

/// Operands of the ALU.
struct AluOperands {
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  std::uint32_t field_bits = 0;  ///< width of the field that must hold x
};

/// Progress of a cell's shifter and ALU with the operands of a packet.
class PlainAlu {
 public:
  void begin() { *this = {}; }

  /// One clock: shifts a word, or, if all words are aligned, passes the next bits through the ALU.
  void clock(const CellWork& work, const AluOperands& operands, const CellShape& cell);

  /// Whether the work is complete.
  [[nodiscard]] bool is_done(const CellWork& work, const CellShape& cell) const;

  [[nodiscard]] std::uint64_t value() const { return value_; }  ///< low bits of the result
  // Results of a difference x - y:
  /// Signed comparison.
  [[nodiscard]] bool less() const { return negative_x_ != negative_y_ ? negative_x_ : negative_; }
  /// Unsigned comparison.
  [[nodiscard]] bool below() const { return carry_; }
  [[nodiscard]] bool equal() const { return !differs_; }
  [[nodiscard]] bool fits() const { return !negative_x_ && !beyond_; }  ///< whether x fits the field

 private:
  [[nodiscard]] bool moves(const CellWork& work, const CellShape& cell) const;
  void advance_shift(const CellWork& work, const CellShape& cell);
  void take(const CellWork& work, const AluOperands& operands, std::uint32_t count);

  std::size_t move_ = 0;     ///< index into the moves of the work
  std::uint32_t word_ = 0;   ///< index of the operand word
  std::uint32_t moved_ = 0;  ///< bits by which that word has been shifted
  std::uint32_t taken_ = 0;  ///< number of bits that the ALU has processed
  std::uint64_t value_ = 0;  ///< result of those bits
  bool carry_ = false;       ///< carry out of those bits; borrow for a difference
  bool differs_ = false;     ///< some bit of the difference is 1
  bool beyond_ = false;      ///< some bit of x above the field is 1
  bool negative_ = false;    ///< top bit of the value
  bool negative_x_ = false;  ///< top bits of the operands
  bool negative_y_ = false;
};

/// Each cell has a multi-port memory of words, an enable bit, a word-wide adder with carry, a shifter, an ALU, and
/// registers for the received words of F, two fetched fields and the field to be written. Squares need a second adder
/// with carry, which updates the difference. Cells below a tree have neither adder.
class PlainCells {
 public:
  PlainCells(std::uint32_t count, std::uint32_t memory_bits, const CellShape& shape);

  /// Receives a word of F and computes the words of F and of the difference for the next cell.
  void add(std::uint32_t cell, PlainBeat& word);

  /// Receives the bits of F that a tree delivers to the cell with the beat.
  void take(std::uint32_t cell, const PlainBeat& beat);

  /// Words of the packet's F received until now.
  [[nodiscard]] std::uint64_t sum(std::uint32_t cell) const { return sum_[cell]; }

  /// Sets memory and enable to 0.
  void clear(std::uint32_t cell);

  /// Reads memory through the ports in the clock of the beat.
  void fetch(std::uint32_t cell, const PlainBeat& beat);

  /// One clock of the shifter or of the ALU.
  void work(std::uint32_t cell, const PlainBeat& beat);

  /// One clock of a trial for a root bit, in which the ALU adds or subtracts the next group of bits.
  void try_root_bit(std::uint32_t cell, const PlainBeat& beat);

  /// Executes a valid instruction whose F and fields have arrived, except for the write to memory. Throws
  /// std::logic_error if a field has not been read, the ALU is still busy, or a root is incomplete.
  void execute(std::uint32_t cell, const PlainBeat& beat);

  /// Writes memory through the ports in the clock of the beat.
  void store(std::uint32_t cell, const PlainBeat& beat);

  /// Words fetched of the first or second field.
  [[nodiscard]] std::uint64_t fetched(std::uint32_t cell, std::size_t field = 0) const {
    return fetched_[cell].at(field);
  }
  [[nodiscard]] bool carry(std::uint32_t cell) const { return carry_[cell] != 0; }  ///< carry of the running sum
  [[nodiscard]] bool difference_carry(std::uint32_t cell) const { return difference_carry_[cell] != 0; }
  [[nodiscard]] const PlainAlu& alu(std::uint32_t cell) const { return alus_[cell]; }
  [[nodiscard]] bool writes(std::uint32_t cell) const { return writes_[cell] != 0; }  ///< whether the result is written

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(enable_.size()); }
  [[nodiscard]] bool enabled(std::uint32_t cell) const { return enable_[cell] != 0; }
  [[nodiscard]] std::span<const std::uint64_t> memory(std::uint32_t cell) const {
    return std::span(memory_).subspan(cell * cell_words_, cell_words_);
  }
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;

 private:
  /// Result of the ALU for an instruction.
  struct Result {
    bool enable = false;
    bool writes = false;
    std::uint64_t value = 0;
  };

  /// Progress of a root.
  struct Root {
    std::uint32_t bit = 0;    ///< bit of the root under trial, highest first
    std::uint32_t tried = 0;  ///< bits of this trial that are complete
    bool carry = false;       ///< carry out of those bits
    bool negative = false;    ///< the remainder is negative
  };

  /// Adds two words; `carry` is the carry in and becomes the carry out.
  [[nodiscard]] std::uint64_t add_words(std::uint64_t left, std::uint64_t right, std::uint8_t& carry) const;
  [[nodiscard]] AluOperands operands_of(std::uint32_t cell, const isa::Instruction& instruction) const;
  [[nodiscard]] Result result_of(std::uint32_t cell, const isa::Instruction& instruction) const;
  [[nodiscard]] isa::Field part_of_word(const FieldWords& words, std::uint32_t word) const;

  CellShape shape_;
  std::uint64_t word_mask_;
  std::size_t cell_words_;
  std::vector<std::uint64_t> memory_;
  std::vector<std::uint64_t> sum_;
  std::vector<std::uint8_t> carry_;
  std::vector<std::uint8_t> difference_carry_;
  std::vector<std::uint8_t> enable_;
  std::vector<std::array<std::uint64_t, 2>> fetched_;
  std::vector<std::uint32_t> words_fetched_;  ///< words of the packet fetched until now
  std::vector<PlainAlu> alus_;
  std::vector<Root> roots_;
  std::vector<std::uint64_t> result_;
  std::vector<std::uint8_t> writes_;  ///< whether the result will be written
};

/// Chain of such cells through which beats advance one cell per clock, or a tree whose levels they descend.
class PlainChain {
 public:
  PlainChain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape);

  /// Advances by one clock; `entering` is in cell 0 or at the root of the tree.
  void step(const scan_line::Beat& entering);

  [[nodiscard]] const PlainCells& cells() const { return cells_; }

  /// Beat that is in the cell in the coming clock; null if none is.
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
