#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::pixel_square {

/// The host's end of the link to a divider. Sends one word of the model per `link.word_clocks` clocks, in the last of
/// these or in the first later clock in which the FIFO has room; the first word follows `link.latency` clocks after the
/// start.
class ModelSource final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_out<isa::LinkWord> words{"words"};

  ModelSource(sc_core::sc_module_name name, const machines::Link& link);

  /// Starts at the next edge. The bytes must outlive the frame.
  void begin(std::span<const std::uint8_t> model);

  /// Clocks by activity in a frame of `clocks` clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return complete_clocks(clocks_, SquareActivity::done, clocks);
  }

  // State for waves: the number of words sent, and the activity at the last edge.
  [[nodiscard]] std::uint64_t words_sent() const { return sent_ / link_.width; }
  [[nodiscard]] std::string_view state() const { return state_; }

 private:
  void on_clock() override;
  [[nodiscard]] bool done() const { return sent_ >= 8 * std::uint64_t{model_.size()}; }
  SquareActivity act();
  [[nodiscard]] isa::LinkWord next_word() const;

  const machines::Link link_;
  std::span<const std::uint8_t> model_;
  std::uint64_t sent_ = 0;  ///< number of bits sent
  std::uint32_t latency_left_ = 0;
  std::uint32_t elapsed_ = 0;  ///< clocks spent on the current word
  SquareClocks clocks_;
  std::string_view state_;
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
