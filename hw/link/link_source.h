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

/// The host's end of a link. Its memory, which is the host's own, holds the frame's words and where each instruction
/// begins. A request names the instruction to go on from; the first word is on the link Link::latency clocks after the
/// edge at which the request has come. A word is on the link for Link::word_clocks clocks and goes into the FIFO at the
/// end of the last, or at the first edge after that which finds room; then the next word follows. A request that comes
/// while words are sent ends that: the word on the link is lost.
class LinkSource final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<std::uint64_t> requests{"requests"};  ///< a place for one
  sc_core::sc_fifo_out<isa::LinkWord> words{"words"};       ///< Link::fifo_depth places

  /// `period`: of the clock.
  LinkSource(sc_core::sc_module_name name, const sc_core::sc_time& period, const machines::Link& link);

  /// Puts a frame into the host's memory. Nothing of it is sent before a request. The account begins with the clock in
  /// which that for the frame's beginning is on its way.
  void load(FrameWords frame);

  /// The same in the middle of the frame: that word is on the link, for so many more clocks; 0 if it waits for room.
  void resume(FrameWords frame, std::size_t word, std::uint32_t clocks_left);

  // For waves.
  [[nodiscard]] std::string_view state() const;
  [[nodiscard]] std::optional<std::size_t> word() const;  ///< that is on the link, counted from the frame's first

  /// Of the frame's clocks that are over.
  [[nodiscard]] machines::LinkAccount account() const;

 private:
  enum class State : std::uint8_t { waiting, latent, sending, blocked, done };

  /// The count of clocks in which it is at that.
  static std::uint64_t& clocks_of(State state, machines::LinkAccount& account);
  void end_of_elaboration() override;
  void on_clock() override;
  [[nodiscard]] std::uint64_t edges() const;
  void go_on_from(std::uint64_t instruction);
  void go_on(std::uint64_t clocks);
  void begin_word();
  void store_word();
  void sleep();

  const sc_core::sc_time period_;
  const machines::Link link_;
  FrameWords frame_;
  State state_ = State::waiting;
  std::size_t next_ = 0;    ///< the word on the link, or that will be
  std::uint32_t left_ = 0;  ///< clocks of the latency, or of the word on the link
  machines::LinkAccount account_;
  std::uint64_t counted_at_ = 0;  ///< edge to which clocks are in the account
  sc_core::sc_event_or_list room_or_request_;
};

}  // namespace csgsim::link
