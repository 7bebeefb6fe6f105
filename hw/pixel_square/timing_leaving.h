#pragma once

#include <cstdint>
#include <optional>

#include "hw/isa/program.h"
#include "hw/pixel_square/timing_agenda.h"

namespace csgsim::pixel_square {

/// Words in which a square's place leaves for the frame buffer.
std::uint64_t header_words(std::uint64_t port_bits);

/// The words in which a square leaves for the frame buffer: those of its header, and those of its colours.
class LeavingSquare {
 public:
  LeavingSquare() = default;
  LeavingSquare(const isa::Region& region, std::uint32_t colour_bits, std::uint64_t port_bits);

  [[nodiscard]] std::uint64_t words_left() const { return words_; }

  /// Of the next word, rows of the square; nothing for a word of the header.
  struct Rows {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  [[nodiscard]] std::optional<Rows> rows() const;

  /// The picture's row in which the next word begins; nothing for one of the header.
  [[nodiscard]] std::optional<std::uint32_t> picture_row() const;

  /// It leaves.
  void advance();

  /// No word of the header leaves.
  void skip_header();

 private:
  std::uint32_t top_ = 0;  ///< row of the picture
  std::uint64_t port_bits_ = 1;
  std::uint64_t row_bits_ = 1;
  std::uint64_t header_words_ = 0;  ///< still to leave
  std::uint64_t words_ = 0;         ///< still to leave, with those
  std::uint64_t bits_ = 0;          ///< of colours, still to leave
  std::uint32_t row_ = 0;           ///< in which the next word of colours begins
  std::uint64_t at_ = 0;            ///< and at which bit of it
};

/// When the rows of a square in one buffer are where words are made of them. The first is latched from the edge after
/// the one at which the square begins to leave; each other from that at which the row before it goes over into the
/// register from which words leave. It does so when it is latched and the next word of colours cannot be made without.
class RowLatch {
 public:
  /// `clocks`: in which a row is latched.
  RowLatch(std::uint64_t clocks, Time begun) : clocks_(clocks), latched_(begun + 1 + clocks), wanted_(begun + 1) {}

  /// The edge at which the row goes over, of which the next word of colours needs something.
  [[nodiscard]] Time there(std::uint32_t row);

  /// A word of colours leaves.
  void pass(Time now) { wanted_ = now + 1; }

 private:
  std::uint64_t clocks_;
  Time latched_;            ///< from that edge on the next row can go over
  Time wanted_;             ///< from that edge on the next word of colours is made
  Time over_ = 0;           ///< edge at which the last did
  std::uint32_t rows_ = 0;  ///< that have
};

}  // namespace csgsim::pixel_square
