#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/port_word.h"
#include "hw/pixel_square/screen.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::pixel_square {

/// What the frame buffer is told before a frame.
struct FrameContents {
  machines::Size picture;         ///< pixels that it holds
  std::uint64_t squares = 0;      ///< drawn or cleared
  std::uint32_t colour_bits = 0;  ///< a pixel
  std::uint32_t background = 0;   ///< colour of a cleared square
};

/// Holds the picture, its rows in banks in turn. In a clock each bank that the screen does not read takes one word from
/// a port, or one of background: that of the row in which the word begins. A word of a header needs a turn of any bank.
/// The ports, one a renderer and after them the sender's, or those of graphics processors, are looked at from the one
/// after the port that was served last; served are those that have a word, or a square to clear, and a bank that is
/// free. After the header of a square to clear come turns in which background is written, as many as the square's
/// colours would be words.
class FrameBuffer final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_in<PortWord>> colours;  ///< one a renderer
  sc_core::sc_vector<sc_core::sc_fifo_in<PortWord>> clears;   ///< one a graphics processor; else one
  sc_core::sc_out<std::uint64_t> frames{"frames"};            ///< that are whole

  FrameBuffer(sc_core::sc_module_name name, const machines::Machine& machine);

  void begin(const FrameContents& contents);

  /// Of every pixel, in row order: what was stored last; 0 if nothing was since a picture of that size was begun.
  [[nodiscard]] std::span<const std::uint32_t> picture() const { return picture_; }

  // Waves show the port that was served last at the last edge, if any; the square that came through it, with width 0
  // until its header is complete; the number of complete squares; and the row that the screen reads, if any.
  [[nodiscard]] std::optional<std::size_t> served() const { return served_; }
  [[nodiscard]] std::optional<std::uint32_t> refreshed() const { return screen_.row(); }
  [[nodiscard]] const isa::Region& served_square() const { return served_square_; }
  [[nodiscard]] std::uint64_t squares() const { return squares_; }

  /// Of a frame of so many clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return whole(clocks_, SquareActivity::waiting_for_renderer, clocks);
  }

 private:
  /// A bit of the colours of a square.
  struct Cursor {
    std::uint32_t x = 0;  ///< of the pixel in the square
    std::uint32_t y = 0;
    unsigned place = 0;  ///< of its colour's bits
  };

  /// The square that comes through a port.
  struct Incoming {
    std::uint64_t header = 0;
    unsigned gathered = 0;       ///< bits of the header that are in
    isa::Region region;          ///< once the header is whole
    std::uint64_t next_bit = 0;  ///< of its colours
    Cursor next;                 ///< where that is
  };

  void end_of_elaboration() override;
  void on_clock() override;
  void count(std::uint64_t clocks);
  void sleep();
  void serve_ports();
  bool serve(std::size_t port);
  [[nodiscard]] bool clears_through(std::size_t port) const { return port >= colours.size(); }
  [[nodiscard]] sc_core::sc_fifo_in<PortWord>& words(std::size_t port);
  [[nodiscard]] bool has_turn(std::size_t port);
  [[nodiscard]] bool any_has_turn();
  [[nodiscard]] bool has_bank(std::size_t port);
  [[nodiscard]] std::uint32_t bank_of(std::uint32_t row) const {
    return row % static_cast<std::uint32_t>(free_.size());
  }
  [[nodiscard]] static std::uint32_t row_of(const Incoming& square) { return square.region.y + square.next.y; }
  void take(std::size_t port, const PortWord& word);
  void take_header(Incoming& square, const PortWord& word) const;
  void store(Incoming& square, std::span<const std::uint64_t> bits);
  void clear(Incoming& square);
  [[nodiscard]] std::uint64_t bits_to_come(const Incoming& square) const;
  template <class Act>
  Cursor each_colour(const Incoming& square, const Act& act) const;
  void finish_if_whole(Incoming& square);
  [[nodiscard]] std::uint64_t colour_bits(const Incoming& square) const;
  [[nodiscard]] std::uint32_t& pixel(const Incoming& square, const Cursor& at);

  const sc_core::sc_time period_;
  const std::uint32_t port_bits_;
  std::uint64_t acted_at_ = 0;  ///< edge
  std::vector<std::uint32_t> picture_;
  FrameContents contents_;
  std::vector<Incoming> incoming_;  ///< one a port
  std::uint64_t squares_ = 0;
  std::size_t turn_ = 0;  ///< port that is asked first
  std::optional<std::size_t> served_;
  isa::Region served_square_;
  std::uint64_t frames_done_ = 0;
  Screen screen_;
  std::vector<bool> free_;     ///< of each bank, in the clock at hand
  std::size_t free_left_ = 0;  ///< banks that words may still take
  SquareClocks clocks_;
  sc_core::sc_event_or_list words_written_;  ///< at any port, or a frame has begun
  sc_core::sc_event begun_;
};

}  // namespace csgsim::pixel_square
