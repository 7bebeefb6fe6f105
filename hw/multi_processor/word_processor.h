#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/base/quotient.h"
#include "hw/isa/instruction.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_form.h"
#include "hw/multi_processor/pixel_memory.h"

namespace csgsim::multi_processor {

/// Operations of a node on single pixels, word by word, and their clocks. A field, a sum and an enable bit each begin
/// at a word. The work is the same at every pixel, enabled or not, unless the node branches over work without effect.
class WordProcessor {
 public:
  explicit WordProcessor(const Figures& figures)
      : word_bits_(figures.word_bits),
        operations_(figures.operations),
        field_clocks_(figures.field_clocks),
        branches_(figures.branches),
        chain_(figures.chain),
        list_clocks_(figures.node_tests.instruction),
        loop_(figures.loop) {}

  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }
  /// Clocks if no branch were taken.
  [[nodiscard]] std::uint64_t unbranched_clocks() const { return unbranched_clocks_; }

  // Count an iteration of the loop over pixels, or over rows.
  void count_pixel() { spend(loop_.pixel); }
  void count_row() { spend(loop_.row); }

  /// Reads an instruction from the received list; if it holds a half-space's index, computes the expression.
  void fetch(const isa::Instruction& instruction, const ListForm& form);

  /// Appends an instruction of the list to the call chain of a native program; call() executes it from there.
  void link(const isa::Instruction& instruction, const ListForm& form);
  void call(const isa::Instruction& instruction);

  /// Unpacks consecutive numbers of the given widths, packed from the start of a word, to separate words.
  template <class Width, std::size_t count>
  void unpack(std::span<Width, count> widths) {
    if (field_clocks_ == unpacked) return;
    unsigned place = 0;
    for (const unsigned width : widths) {
      unpack(width, place % word_bits_);
      place += width;
    }
  }

  /// Computes A*x + B*y + C, modulo 2^64.
  std::uint64_t start(const isa::Linear& linear, std::uint32_t x, std::uint32_t y);

  /// Increment of F over `distance` pixels in x or y; `coefficient` is A or B.
  std::uint64_t step(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t distance);

  /// Advances `sum` to the next pixel or row by adding `step`.
  void add(const isa::Linear& linear, std::uint64_t& sum, std::uint64_t step);

  /// Tests the enable bit E at the start of every instruction. If the node branches over disabled pixels and E is 0,
  /// skips the instruction at this pixel.
  void test_enable(const isa::Instruction& instruction, const PixelMemory& memory, std::size_t pixel);

  /// Executes the rest of a valid instruction at a pixel whose E was tested and whose sum is computed.
  void act(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel, std::uint64_t sum);

  /// Clears the memory and the enable bit of a pixel.
  void clear(unsigned memory_bits) {
    write_words(memory_bits);
    write_words(1);
  }

  /// Reads a colour field of a pixel; store_colour() writes it, or a constant, to the image memory.
  std::uint32_t load_colour(const PixelMemory& memory, std::size_t pixel, isa::Field colour);
  void store_colour(isa::Field colour) { write_words(colour.width); }

 private:
  [[nodiscard]] std::uint64_t words(unsigned bits) const { return quotient_up(bits, word_bits_); }
  /// Counts the clocks of an operation; only unbranched_clocks() counts skipped work.
  void spend(std::uint64_t clocks) {
    unbranched_clocks_ += clocks;
    if (!skipping_) clocks_ += clocks;
  }
  /// Counts a branch; if taken, skips the rest of the instruction.
  void branch(bool is_taken);

  void read_words(unsigned bits) { spend(words(bits) * operations_.read); }
  void write_words(unsigned bits) { spend(words(bits) * operations_.write); }
  void add_words(unsigned bits) { spend(words(bits) * operations_.add); }
  void compare_words(unsigned bits) { spend(words(bits) * operations_.compare); }
  void combine_words(unsigned bits) { spend(words(bits) * operations_.logic); }

  void shift_word(unsigned places) { spend(operations_.shift + std::uint64_t{operations_.shift_bit} * places); }
  void shift_words(unsigned bits, unsigned places);
  void unpack(unsigned bits, unsigned first_bit);

  std::uint64_t multiply(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t factor);
  std::uint64_t read(const PixelMemory& memory, std::size_t pixel, isa::Field field);
  void write_enable(PixelMemory& memory, std::size_t pixel, bool is_enabled);
  void write(PixelMemory& memory, std::size_t pixel, isa::Field field, std::uint64_t value, bool is_selected);
  std::int64_t extract_value(std::uint64_t sum, const isa::Linear& linear);
  std::uint64_t compute_root(std::uint64_t field, unsigned bits);
  void execute_opcode(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel,
                      std::int64_t linear_value);
  void write_linear(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel,
                    std::int64_t linear_value, bool is_selected);

  std::uint32_t word_bits_;
  OperationClocks operations_;
  std::uint32_t field_clocks_;
  BranchFigures branches_;
  ChainFigures chain_;
  std::uint32_t list_clocks_;
  LoopClocks loop_;
  std::uint64_t clocks_ = 0;
  std::uint64_t unbranched_clocks_ = 0;
  bool skipping_ = false;  ///< a branch is taken over the rest of the instruction at the pixel
};

}  // namespace csgsim::multi_processor
