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

/// A square that begins to leave.
struct SquareStart {
  isa::Region region;
  bool is_clear = false;  ///< nothing is seen there, and no words follow
};

/// What a sender is at, for waves: as the edge left it with which the clock began.
struct SenderStatus {
  std::string_view state;               ///< `receiving`, `testing`, `sending`, `done`, or what it waits for
  std::size_t square = 0;               ///< as many as there are when it is done
  std::optional<std::size_t> renderer;  ///< that gets it, once that is known
};

/// Hands out the squares, one after another, a word every `word_clocks` clocks, as long as there is room. A square goes
/// to the renderer with the fewest squares that it has not finished (the first of those); the header of one where
/// nothing is seen goes to the frame buffer. What squares consist of is for those that derive from it to say.
class Sender : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_out<isa::LinkWord>> links;  ///< one a renderer
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> finished;     ///< squares that each renderer has finished
  sc_core::sc_fifo_out<PortWord> clears{"clears"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  /// Of a frame of so many clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return whole(clocks_, SquareActivity::done, clocks);
  }
  [[nodiscard]] std::uint64_t squares_skipped() const { return skipped_; }
  [[nodiscard]] const SenderStatus& status() const { return status_; }

 protected:
  Sender(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t word_clocks);

  /// A frame of so many squares begins.
  void begin_frame(std::size_t squares);

  /// What is to be done in a clock before the square at hand can be sent; none, if it can.
  virtual std::optional<SquareActivity> prepare(std::size_t square) = 0;

  /// While that is waiting_for_divider: after what event it can be otherwise; null if it has to be asked at each edge.
  [[nodiscard]] virtual const sc_core::sc_event* prepared(std::size_t /*square*/) const { return nullptr; }

  /// What `working` means while a square is prepared, by name.
  [[nodiscard]] virtual std::string_view preparing() const = 0;

  /// Begins with the square that has been prepared.
  virtual SquareStart start(std::size_t square) = 0;

  /// Of SegmentStart, its instructions, SegmentEnd the word that leaves next; null while it is not there.
  [[nodiscard]] virtual const isa::LinkWord* next_word() const = 0;

  /// That word has left. Returns whether it was the last of the square.
  virtual bool pass() = 0;

 private:
  void on_clock() override;
  void sleep();
  SquareActivity act();
  SquareActivity as_told(SquareActivity activity);
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
  std::size_t index_ = 0;              ///< of the square at hand
  std::optional<SquareStart> square_;  ///< once it is prepared
  std::optional<std::size_t> target_;  ///< the renderer that gets it; none, if it is cleared
  std::size_t sent_ = 0;               ///< words of its header
  std::uint32_t elapsed_ = 0;          ///< clocks spent on the word at hand
  std::vector<std::uint64_t> handed_;  ///< squares that each renderer has got
  std::uint64_t skipped_ = 0;
  std::uint64_t acted_at_ = 0;  ///< edge
  SquareActivity activity_{};   ///< in the clock that ended there, and in those that it has slept since
  SquareClocks clocks_;
  SenderStatus status_;
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
