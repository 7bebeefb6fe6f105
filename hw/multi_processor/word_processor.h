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

/// What a node does to one pixel after the other, a word of some bits at a time, and the clocks that it takes. A field,
/// a sum, and an enable bit begin at a word of their own. It does the same at every pixel, enabled or not, unless it
/// branches over what has no effect there.
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
  /// What it would have taken if no branch were taken.
  [[nodiscard]] std::uint64_t whole_clocks() const { return whole_clocks_; }

  void count_pixel() { spend(loop_.pixel); }
  void count_row() { spend(loop_.row); }

  /// Takes an instruction from the list, as it came; where a half-space's number came, it works out the expression.
  void fetch(const isa::Instruction& instruction, const ListForm& form);

  /// Makes an instruction of the list a call in the chain of a native program; and calls it there.
  void link(const isa::Instruction& instruction, const ListForm& form);
  void call(const isa::Instruction& instruction);

  /// Gets numbers of so many bits, which follow each other from the beginning of a word on, into words of their own.
  template <class Width, std::size_t count>
  void unpack(std::span<Width, count> widths) {
    if (field_clocks_ == unpacked) return;
    unsigned place = 0;
    for (const unsigned width : widths) {
      unpack(width, place % word_bits_);
      place += width;
    }
  }

  /// A*x + B*y + C, modulo 2^64.
  std::uint64_t start(const isa::Linear& linear, std::uint32_t x, std::uint32_t y);

  /// What is to be added to F to go that far; A or B is the coefficient.
  std::uint64_t step(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t distance);

  /// Goes on to the next pixel or row.
  void add(const isa::Linear& linear, std::uint64_t& sum, std::uint64_t step);

  /// Every instruction begins by looking at E, and may have no more to do at the pixel.
  void look(const isa::Instruction& instruction, const PixelMemory& memory, std::size_t pixel);

  /// Carries out the rest of a valid instruction at a pixel that it has looked at, whose sum is at hand.
  void act(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel, std::uint64_t sum);

  /// Makes the memory and the enable bit of a pixel 0.
  void clear(unsigned memory_bits) {
    write_words(memory_bits);
    write_words(1);
  }

  /// Copies a field of a pixel into the image memory; or puts a constant there.
  std::uint32_t load_colour(const PixelMemory& memory, std::size_t pixel, isa::Field colour);
  void store_colour(isa::Field colour) { write_words(colour.width); }

 private:
  [[nodiscard]] std::uint64_t words(unsigned bits) const { return quotient_up(bits, word_bits_); }
  /// Nothing of what a branch has gone over takes time.
  void spend(std::uint64_t clocks) {
    whole_clocks_ += clocks;
    if (!is_over_) clocks_ += clocks;
  }
  /// Over the rest of the instruction.
  void branch(bool is_taken);

  void read_words(unsigned bits) { spend(words(bits) * operations_.read); }
  void write_words(unsigned bits) { spend(words(bits) * operations_.write); }
  void add_words(unsigned bits) { spend(words(bits) * operations_.add); }
  void compare_words(unsigned bits) { spend(words(bits) * operations_.compare); }
  void combine_words(unsigned bits) { spend(words(bits) * operations_.logic); }

  void shift_word(unsigned places) { spend(operations_.shift + std::uint64_t{operations_.shift_bit} * places); }
  void shift_words(unsigned bits, unsigned places);
  void unpack(unsigned bits, unsigned place);

  std::uint64_t multiply(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t factor);
  std::uint64_t read(const PixelMemory& memory, std::size_t pixel, isa::Field field);
  void write_enable(PixelMemory& memory, std::size_t pixel, bool value);
  void write(PixelMemory& memory, std::size_t pixel, isa::Field field, std::uint64_t value, bool where);
  std::int64_t value_of(std::uint64_t sum, const isa::Linear& linear);
  std::uint64_t root_of(std::uint64_t field, unsigned bits);
  void carry_out(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel, std::int64_t f);
  void write_linear(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel, std::int64_t f,
                    bool where);

  std::uint32_t word_bits_;
  OperationClocks operations_;
  std::uint32_t field_clocks_;
  BranchFigures branches_;
  ChainFigures chain_;
  std::uint32_t list_clocks_;
  LoopClocks loop_;
  std::uint64_t clocks_ = 0;
  std::uint64_t whole_clocks_ = 0;
  bool is_over_ = false;  ///< a branch is taken over the rest of the instruction at the pixel
};

}  // namespace csgsim::multi_processor
