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

/// Parameters of a frame, set before it begins.
struct FrameContents {
  machines::Size picture;         ///< size of the stored picture, in pixels
  std::uint64_t squares = 0;      ///< number of squares, drawn or cleared
  std::uint32_t colour_bits = 0;  ///< bits of colour per pixel
  std::uint32_t background = 0;   ///< colour of a cleared square
};

/// Holds the picture; its rows are interleaved over the banks. In each clock, every bank that the screen does not read
/// accepts one word from a port, or one word of background. A word goes to the bank of the row in which it begins; a
/// header word occupies any free bank. The ports (one per renderer, then the ports of the sender or the graphics
/// processors) are served round-robin, starting after the port that was served last. A port is served if a word or a
/// square to clear is pending and its bank is free. After the header of a square to clear, one word of background is
/// written per turn until the square is filled.
class FrameBuffer final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_in<PortWord>> colours;  ///< one per renderer
  sc_core::sc_vector<sc_core::sc_fifo_in<PortWord>> clears;   ///< one per graphics processor; otherwise one
  sc_core::sc_out<std::uint64_t> frames{"frames"};            ///< number of complete frames

  FrameBuffer(sc_core::sc_module_name name, const machines::Machine& machine);

  void begin(const FrameContents& contents);

  /// Colour of every pixel, in row order: the last stored value, or 0 if none was stored since the picture's size last
  /// changed.
  [[nodiscard]] std::span<const std::uint32_t> picture() const { return picture_; }

  // State for waves.
  /// The port served last at the last edge, if any.
  [[nodiscard]] std::optional<std::size_t> served() const { return served_; }
  /// The row that the screen reads, if any.
  [[nodiscard]] std::optional<std::uint32_t> refreshed() const { return screen_.row(); }
  /// The square that came through the port served last; its width is 0 until its header is complete.
  [[nodiscard]] const isa::Region& served_square() const { return served_square_; }
  /// Number of complete squares.
  [[nodiscard]] std::uint64_t squares() const { return squares_; }

  /// Clocks by activity in a frame of `clocks` clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return complete_clocks(clocks_, SquareActivity::waiting_for_renderer, clocks);
  }

 private:
  /// Position of a bit in the colours of a square.
  struct Cursor {
    std::uint32_t x = 0;  ///< column of the pixel in the square
    std::uint32_t y = 0;
    unsigned place = 0;  ///< bit position within the colour
  };

  /// The square that a port receives.
  struct Incoming {
    std::uint64_t header = 0;
    unsigned gathered = 0;       ///< bits of the header received
    isa::Region region;          ///< valid once the header is complete
    std::uint64_t next_bit = 0;  ///< index of the next colour bit
    Cursor next;                 ///< position of that bit
  };

  void end_of_elaboration() override;
  void on_clock() override;
  void count_clocks(std::uint64_t clocks);
  void sleep();
  void serve_ports();
  bool try_serve(std::size_t port);
  [[nodiscard]] bool is_clear_port(std::size_t port) const { return port >= colours.size(); }
  [[nodiscard]] sc_core::sc_fifo_in<PortWord>& port_words(std::size_t port);
  [[nodiscard]] bool has_pending(std::size_t port);
  [[nodiscard]] bool any_pending();
  [[nodiscard]] bool try_claim_bank(std::size_t port);
  [[nodiscard]] std::uint32_t bank_of(std::uint32_t row) const {
    return row % static_cast<std::uint32_t>(free_.size());
  }
  [[nodiscard]] static std::uint32_t row_of(const Incoming& square) { return square.region.y + square.next.y; }
  void accept_word(std::size_t port, const PortWord& word);
  void take_header(Incoming& square, const PortWord& word) const;
  void store_colours(Incoming& square, std::span<const std::uint64_t> bits);
  void clear(Incoming& square);
  [[nodiscard]] std::uint64_t remaining_word_bits(const Incoming& square) const;
  template <class Visit>
  Cursor for_each_colour(const Incoming& square, const Visit& visit) const;
  void finish_if_complete(Incoming& square);
  [[nodiscard]] std::uint64_t colour_bits(const Incoming& square) const;
  [[nodiscard]] std::uint32_t& pixel(const Incoming& square, const Cursor& position);

  const sc_core::sc_time period_;
  const std::uint32_t port_bits_;
  std::uint64_t acted_at_ = 0;  ///< clock edge
  std::vector<std::uint32_t> picture_;
  FrameContents contents_;
  std::vector<Incoming> incoming_;  ///< one per port
  std::uint64_t squares_ = 0;
  std::size_t turn_ = 0;  ///< port that is polled first
  std::optional<std::size_t> served_;
  isa::Region served_square_;
  std::uint64_t frames_done_ = 0;
  Screen screen_;
  std::vector<bool> free_;     ///< whether each bank is free in the current clock
  std::size_t free_left_ = 0;  ///< banks that can still accept a word
  SquareClocks clocks_;
  sc_core::sc_event_or_list words_written_;  ///< a word was written at any port, or a frame has begun
  sc_core::sc_event begun_;
};

}  // namespace csgsim::pixel_square
