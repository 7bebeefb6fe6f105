#pragma once

#include <cstdint>
#include <optional>

#include "hw/isa/program.h"
#include "hw/pixel_square/timing_agenda.h"

namespace csgsim::pixel_square {

/// Number of words of a square's header.
std::uint64_t header_words(std::uint64_t port_bits);

/// The words of a square that have not yet left for the frame buffer: first its header, then its colours.
class LeavingSquare {
 public:
  LeavingSquare() = default;
  LeavingSquare(const isa::Region& region, std::uint32_t colour_bits, std::uint64_t port_bits);

  [[nodiscard]] std::uint64_t words_left() const { return words_; }

  /// First and last row of the square that the next word contains; empty for a header word.
  struct Rows {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  [[nodiscard]] std::optional<Rows> rows() const;

  /// Row of the picture in which the next word of colours begins; empty if the next word is a header word.
  [[nodiscard]] std::optional<std::uint32_t> picture_row() const;

  /// Advances past the word that has been sent.
  void advance();

  /// Drops the words of the header.
  void skip_header();

 private:
  std::uint32_t top_ = 0;  ///< picture row of the square's first row
  std::uint64_t port_bits_ = 1;
  std::uint64_t row_bits_ = 1;
  std::uint64_t header_words_ = 0;  ///< header words still to leave
  std::uint64_t words_ = 0;         ///< words still to leave, including the header's
  std::uint64_t bits_ = 0;          ///< colour bits still to leave
  std::uint32_t row_ = 0;           ///< row in which the next word of colours begins
  std::uint64_t at_ = 0;            ///< first bit of that word within the row
};

/// Edges at which rows of a square in a single buffer are available for sending. Latching of the first row starts at
/// the edge after the square begins to leave; latching of each other row starts when the previous row is transferred to
/// the output register. A row is transferred once it is latched and the next word of colours needs it.
class RowLatch {
 public:
  /// `clocks`: clocks to latch a row.
  RowLatch(std::uint64_t clocks, Time start_clock)
      : clocks_(clocks), latched_(start_clock + 1 + clocks), needed_(start_clock + 1) {}

  /// Edge at which `row`, which the next word of colours needs, is transferred.
  [[nodiscard]] Time transfer_edge(std::uint32_t row);

  /// Records that a word of colours leaves at edge `now`.
  void record_word(Time now) { needed_ = now + 1; }

 private:
  std::uint64_t clocks_;
  Time latched_;            ///< edge from which the next row can be transferred
  Time needed_;             ///< edge from which the next word of colours is assembled
  Time transferred_ = 0;    ///< edge of the last transfer
  std::uint32_t rows_ = 0;  ///< rows transferred
};

}  // namespace csgsim::pixel_square
