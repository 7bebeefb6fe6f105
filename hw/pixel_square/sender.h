#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/port_word.h"
#include "hw/systemc/clocked_module.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_square {

/// A square that the sender begins to send.
struct SquareStart {
  isa::Region region;
  bool is_clear = false;  ///< whether the square is empty, so that no words follow
};

/// State of a sender, for waves, in the clock that began with the last edge.
struct SenderStatus {
  /// `receiving`, `testing`, `sending`, `done`, or the name of the reason for waiting.
  std::string_view state;
  std::size_t square = 0;               ///< index of the square; the number of squares when done
  std::optional<std::size_t> renderer;  ///< renderer that receives the square, once chosen
};

/// Distributes the squares one after another, one word per `word_clocks` clocks while there is room. A square goes to
/// the renderer with the fewest unfinished squares (ties go to the lowest number); the header of an empty square goes
/// to the frame buffer. Derived classes provide the words of a square.
class Sender : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_out<isa::LinkWord>> links;  ///< one per renderer
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> finished;     ///< squares finished by each renderer
  sc_core::sc_fifo_out<PortWord> clears{"clears"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  /// Clocks by activity in a frame of `clocks` clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return complete_clocks(clocks_, SquareActivity::done, clocks);
  }
  [[nodiscard]] std::uint64_t squares_skipped() const { return skipped_; }
  [[nodiscard]] const SenderStatus& status() const { return status_; }

 protected:
  Sender(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t word_clocks);

  /// Begins a frame of `squares` squares.
  void begin_frame(std::size_t squares);

  /// The reason for waiting in this clock if the square cannot be sent yet; empty if sending can begin.
  virtual std::optional<SquareActivity> prepare(std::size_t square) = 0;

  /// Event to wait for after prepare() has returned waiting_for_divider; null to call prepare() at each edge.
  [[nodiscard]] virtual const sc_core::sc_event* prepared(std::size_t /*square*/) const { return nullptr; }

  /// State shown in waves while prepare() returns `working`.
  [[nodiscard]] virtual std::string_view preparing() const = 0;

  /// Begins sending the prepared square.
  virtual SquareStart start(std::size_t square) = 0;

  /// Next word of SegmentStart, the instructions and SegmentEnd; null while none is available.
  [[nodiscard]] virtual const isa::LinkWord* next_word() const = 0;

  /// Advances past the word that has been sent. Returns whether it was the last word of the square.
  virtual bool advance() = 0;

 private:
  void on_clock() override;
  void sleep();
  SquareActivity act();
  SquareActivity record_state(SquareActivity activity);
  SquareActivity send();
  SquareActivity send_header();
  SquareActivity send_word();
  void begin_square();
  void end_square();
  [[nodiscard]] std::size_t least_busy() const;

  const sc_core::sc_time period_;
  const std::uint32_t word_clocks_;
  const std::uint32_t port_bits_;
  std::size_t squares_ = 0;
  std::size_t index_ = 0;                ///< index of the square in progress
  std::optional<SquareStart> square_;    ///< set once the square is prepared
  std::optional<std::size_t> target_;    ///< renderer that receives the square; none if it is cleared
  std::size_t sent_ = 0;                 ///< number of words of the header of an empty square already sent
  std::uint32_t elapsed_ = 0;            ///< clocks spent on the current word
  std::vector<std::uint64_t> assigned_;  ///< squares assigned to each renderer
  std::uint64_t skipped_ = 0;
  std::uint64_t acted_at_ = 0;  ///< edge at which the sender acted last
  SquareActivity activity_{};   ///< activity of the last clock, and of the clocks since then in which the sender slept
  SquareClocks clocks_;
  SenderStatus status_;
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
