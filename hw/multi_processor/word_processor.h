#pragma once

#include <cstdint>
#include <span>

#include "hw/base/quotient.h"
#include "hw/isa/instruction.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/pixel_memory.h"

namespace csgsim::multi_processor {

/// What a node does to one pixel after the other, a word of some bits at a time, and the clocks that it takes. A field,
/// a sum, and an enable bit begin at a word of their own. It does the same at every pixel, enabled or not.
class WordProcessor {
 public:
  explicit WordProcessor(const Figures& figures)
      : word_bits_(figures.word_bits),
        operations_(figures.operations),
        field_clocks_(figures.field_clocks),
        loop_(figures.loop) {}

  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }

  void count_pixel() { clocks_ += loop_.pixel; }
  void count_row() { clocks_ += loop_.row; }

  /// Takes an instruction from the list, as it came.
  void fetch(const isa::Instruction& instruction);

  /// Gets numbers of so many bits, which follow each other from the beginning of a word on, into words of their own.
  template <class Width>
  void unpack(std::span<const Width> widths) {
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

  /// Carries out a valid instruction at a pixel whose sum is at hand. Every instruction begins by looking at E.
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
  void read_words(unsigned bits) { clocks_ += words(bits) * operations_.read; }
  void write_words(unsigned bits) { clocks_ += words(bits) * operations_.write; }
  void add_words(unsigned bits) { clocks_ += words(bits) * operations_.add; }
  void compare_words(unsigned bits) { clocks_ += words(bits) * operations_.compare; }
  void combine_words(unsigned bits) { clocks_ += words(bits) * operations_.logic; }

  void shift_word(unsigned places) { clocks_ += operations_.shift + std::uint64_t{operations_.shift_bit} * places; }
  void shift_words(unsigned bits, unsigned places);
  void unpack(unsigned bits, unsigned place);

  std::uint64_t multiply(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t factor);
  std::uint64_t read(const PixelMemory& memory, std::size_t pixel, isa::Field field);
  void write_enable(PixelMemory& memory, std::size_t pixel, bool value);
  void write(PixelMemory& memory, std::size_t pixel, isa::Field field, std::uint64_t value, bool where);
  std::int64_t value_of(std::uint64_t sum, const isa::Linear& linear);
  std::uint64_t root_of(std::uint64_t field, unsigned bits);
  void write_linear(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel, std::int64_t f,
                    bool where);

  std::uint32_t word_bits_;
  OperationClocks operations_;
  std::uint32_t field_clocks_;
  LoopClocks loop_;
  std::uint64_t clocks_ = 0;
};

}  // namespace csgsim::multi_processor
