#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/wire.h"
#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "hw/scan_line/activity.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::scan_line {

/// The host's end of the link to a chain. Sends each line that it receives: its start, its instructions, and its end. A
/// word occupies the link for Link::word_clocks clocks and enters the FIFO at the end of the last of these, or at the
/// first later edge with room. Then the next word follows, also across lines if the next line is available. The frame's
/// first word starts Link::latency clocks after its line was taken.
class ChainLink final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<std::uint32_t> lines{"lines"};
  sc_core::sc_fifo_out<isa::LinkWord> words{"words"};

  ChainLink(sc_core::sc_module_name name, const machines::Link& link);

  /// Begins a frame with the next clock; the chain draws `lines_to_send` of its lines.
  void begin(const PictureLines& frame, std::size_t lines_to_send);

  [[nodiscard]] const ActivityCounter& counter() const { return counter_; }  ///< counter of the frame that began last
  [[nodiscard]] std::uint64_t sent() const { return sent_; }                 ///< number of words sent

  // State for waves.
  [[nodiscard]] std::string_view activity() const { return counter_.now(); }
  /// Line being sent; empty while the link waits for a line.
  [[nodiscard]] std::optional<std::uint32_t> line() const {
    return state_ == State::waiting ? std::nullopt : std::optional(line_);
  }

 private:
  enum class State : std::uint8_t { waiting, latent, sending, blocked };

  void on_clock() override;
  void advance();
  void store_word();
  void take_line();
  void take_command();
  [[nodiscard]] LineActivity current_activity() const;

  const machines::Link link_;
  PictureLines frame_;
  std::size_t lines_left_ = 0;  ///< number of lines not yet taken
  State state_ = State::waiting;
  std::uint32_t left_ = 0;     ///< remaining clocks of the latency, or of the word on the link
  std::uint32_t latency_ = 0;  ///< latency of the line that is taken next
  std::uint32_t line_ = 0;
  std::size_t command_ = 0;                   ///< index within the line: its start, its instructions, its end
  std::vector<isa::LinkWord> command_words_;  ///< words of the current command
  std::size_t word_ = 0;                      ///< index of the word on the link
  std::uint64_t sent_ = 0;
  ActivityCounter counter_;
};

}  // namespace csgsim::scan_line
