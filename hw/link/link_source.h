// The host's end of a link.
// Used by hw/pixel_planes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/link/frame_words.h"
#include "hw/machines/link_timing.h"
#include "hw/machines/machine.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::link {

/// The host's end of a link. Its memory holds the frame's words and the first word of each instruction. A request names
/// the instruction to continue with; the first word is on the link Link::latency clocks after the edge at which the
/// request arrived. A word is on the link for Link::word_clocks clocks and enters the FIFO at the end of the last of
/// these, or at the first later edge at which the FIFO has room; then the next word follows. A request that arrives
/// during transmission aborts it: the word on the link is lost.
class LinkSource final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<std::uint64_t> requests{"requests"};  ///< capacity 1
  sc_core::sc_fifo_out<isa::LinkWord> words{"words"};       ///< capacity Link::fifo_depth

  /// `period`: clock period.
  LinkSource(sc_core::sc_module_name name, const sc_core::sc_time& period, const machines::Link& link);

  /// Loads a frame into the host's memory. No word is sent before a request. The account begins with the clock in which
  /// the request for the beginning of the frame is transmitted.
  void load(FrameWords frame);

  /// Loads a frame in the middle of its transmission: word `word_index` of the frame is on the link for another
  /// `clocks_left` clocks; 0 if this word waits for room.
  void resume(FrameWords frame, std::size_t word_index, std::uint32_t clocks_left);

  // State for waves.
  [[nodiscard]] std::string_view state() const;
  [[nodiscard]] std::optional<std::size_t> word() const;  ///< index in the frame of the word on the link

  /// Account of the frame's completed clocks.
  [[nodiscard]] machines::LinkAccount account() const;

 private:
  enum class State : std::uint8_t { waiting, latent, sending, blocked, done };

  /// The counter in `account` for clocks in the given state.
  static std::uint64_t& state_clocks(State state, machines::LinkAccount& account);
  void end_of_elaboration() override;
  void on_clock() override;
  [[nodiscard]] std::uint64_t edges() const;
  void continue_from(std::uint64_t instruction_index);
  void advance(std::uint64_t clocks);
  void begin_word();
  void store_word();
  void sleep();

  const sc_core::sc_time period_;
  const machines::Link link_;
  FrameWords frame_;
  State state_ = State::waiting;
  std::size_t next_ = 0;    ///< current or next word on the link
  std::uint32_t left_ = 0;  ///< remaining clocks of the latency or of the word on the link
  machines::LinkAccount account_;
  std::uint64_t counted_at_ = 0;  ///< edge up to which account_ counts
  sc_core::sc_event_or_list room_or_request_;
};

}  // namespace csgsim::link
