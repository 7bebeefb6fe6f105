#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/port_word.h"
#include "hw/pixel_square/ring_word.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::pixel_square {

/// Carries commands from graphics processors to renderers, and headers of squares to clear and colours to the frame
/// buffer. It carries words in the last clock of each period of `ring.word_clocks` clocks: at most one word per
/// channel, at most one from each source and to each renderer, and at most one to the frame buffer per bank. The
/// sources (the processors, then the renderers) are polled round-robin, starting after the source that was served last;
/// sources without a word, or whose destination is full, are skipped.
class Ring final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_in<RingWord>> processors;
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> targets;      ///< destination of each processor: a renderer, or the
                                                                  ///< frame buffer (number of renderers)
  sc_core::sc_vector<sc_core::sc_fifo_in<PortWord>> renderers;    ///< colours of each renderer
  sc_core::sc_vector<sc_core::sc_fifo_out<isa::LinkWord>> links;  ///< outputs to the renderers
  sc_core::sc_vector<sc_core::sc_fifo_out<PortWord>> colours;     ///< outputs to the frame buffer, one per renderer
  sc_core::sc_vector<sc_core::sc_fifo_out<PortWord>> clears;      ///< outputs to the frame buffer, one per processor

  Ring(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Begins a frame with the next clock.
  void begin();

  /// Counts in a frame of `clocks` clocks.
  [[nodiscard]] RingAccount account(std::uint64_t clocks) const {
    return {complete_clocks(clocks_, SquareActivity::waiting_for_divider, clocks), words_, full_clocks_};
  }
  /// State for waves: number of words carried in the frame, and whether some channel carries a word.
  [[nodiscard]] std::uint64_t words() const { return words_; }
  [[nodiscard]] bool is_carrying() const { return edges() < busy_until_; }

 private:
  void end_of_elaboration() override;
  void on_clock() override;
  [[nodiscard]] std::uint64_t edges() const;
  [[nodiscard]] bool has_words();
  void carry();
  bool try_carry_from(std::size_t source);
  bool try_carry_command(std::size_t processor, std::size_t renderer);
  bool try_carry_header(std::size_t processor);
  bool try_carry_colours(std::size_t renderer);

  const sc_core::sc_time period_;
  const std::size_t channels_;
  const std::uint64_t word_clocks_;
  const std::size_t banks_;
  std::uint64_t begun_at_ = 0;         ///< clock edge
  std::size_t turn_ = 0;               ///< source that is polled first
  std::vector<bool> taken_;            ///< renderers that have received a word in this clock
  std::size_t frame_buffer_left_ = 0;  ///< words that the frame buffer can still accept in this clock
  SquareClocks clocks_;
  std::uint64_t words_ = 0;
  std::uint64_t full_clocks_ = 0;
  std::uint64_t busy_until_ = 0;             ///< clock edge
  sc_core::sc_event_or_list words_written_;  ///< a word was written at any source, or a frame has begun
  sc_core::sc_event begun_;
};

}  // namespace csgsim::pixel_square
