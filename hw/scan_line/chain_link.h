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

/// The host's end of the link to a chain. Sends each line that is handed over: where it begins, its instructions, and
/// its end. A word is on the link for Link::word_clocks clocks and goes into the FIFO at the end of the last, or at the
/// first edge after that which finds room; then the next word follows, at once that of the next line if it is there.
/// The frame's first word begins Link::latency clocks after its line was taken.
class ChainLink final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<std::uint32_t> lines{"lines"};
  sc_core::sc_fifo_out<isa::LinkWord> words{"words"};

  ChainLink(sc_core::sc_module_name name, const machines::Link& link);

  /// For that many lines of the frame. Starts with the next clock.
  void begin(const PictureLines& frame, std::size_t lines);

  [[nodiscard]] const ActivityCounter& counter() const { return counter_; }  ///< of the frame that began last
  [[nodiscard]] std::uint64_t sent() const { return sent_; }                 ///< words

  // For waves.
  [[nodiscard]] std::string_view activity() const { return counter_.now(); }
  /// That it sends; none while it waits for one.
  [[nodiscard]] std::optional<std::uint32_t> line() const {
    return state_ == State::waiting ? std::nullopt : std::optional(line_);
  }

 private:
  enum class State : std::uint8_t { waiting, latent, sending, blocked };

  void on_clock() override;
  void go_on();
  void store_word();
  void take_line();
  void take_command();
  [[nodiscard]] LineActivity doing() const;

  const machines::Link link_;
  PictureLines frame_;
  std::size_t lines_left_ = 0;  ///< to be taken
  State state_ = State::waiting;
  std::uint32_t left_ = 0;     ///< clocks of the latency, or of the word on the link
  std::uint32_t latency_ = 0;  ///< of the line that is taken next
  std::uint32_t line_ = 0;
  std::size_t command_ = 0;                ///< of the line: its beginning, its instructions, its end
  std::vector<isa::LinkWord> of_command_;  ///< words
  std::size_t word_ = 0;                   ///< of these, the one on the link
  std::uint64_t sent_ = 0;
  ActivityCounter counter_;
};

}  // namespace csgsim::scan_line
