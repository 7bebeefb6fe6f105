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

/// The host's end of the link to a divider: sends the model, a word every `link.word_clocks`, in the last of these or
/// in the first clock after it in which there is room; the first after `link.latency` clocks.
class ModelSource final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_out<isa::LinkWord> words{"words"};

  ModelSource(sc_core::sc_module_name name, const machines::Link& link);

  /// Starts at the next edge. The bytes have to live until the frame is drawn.
  void begin(std::span<const std::uint8_t> model);

  /// Of a frame of so many clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return whole(clocks_, SquareActivity::done, clocks);
  }

  /// For waves: words that have left, and what it did at the last edge.
  [[nodiscard]] std::uint64_t words_sent() const { return sent_ / link_.width; }
  [[nodiscard]] std::string_view state() const { return state_; }

 private:
  void on_clock() override;
  [[nodiscard]] bool done() const { return sent_ >= 8 * std::uint64_t{model_.size()}; }
  SquareActivity act();
  [[nodiscard]] isa::LinkWord next_word() const;

  const machines::Link link_;
  std::span<const std::uint8_t> model_;
  std::uint64_t sent_ = 0;  ///< bits
  std::uint32_t latency_left_ = 0;
  std::uint32_t elapsed_ = 0;  ///< clocks spent on the word at hand
  SquareClocks clocks_;
  std::string_view state_;
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
