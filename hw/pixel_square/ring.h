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

/// Carries commands from graphics processors to renderers, headers of squares to clear and colours to the frame buffer:
/// in the last of every `ring.word_clocks` clocks of a frame as many words as it has channels, of those that wait for
/// it at most one of a source and one for a renderer, and for the frame buffer as many as that has banks. Sources, the
/// processors and after them the renderers, are looked at from the one after the source that was served last; passed
/// over are those without a word, or without room at its target.
class Ring final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_in<RingWord>> processors;
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> targets;  ///< of each: a renderer, or the frame buffer behind them
  sc_core::sc_vector<sc_core::sc_fifo_in<PortWord>> renderers;    ///< their colours
  sc_core::sc_vector<sc_core::sc_fifo_out<isa::LinkWord>> links;  ///< to the renderers
  sc_core::sc_vector<sc_core::sc_fifo_out<PortWord>> colours;     ///< to the frame buffer, one a renderer
  sc_core::sc_vector<sc_core::sc_fifo_out<PortWord>> clears;      ///< to the frame buffer, one a processor

  Ring(sc_core::sc_module_name name, const machines::Machine& machine);

  /// A frame begins, with the next clock.
  void begin();

  [[nodiscard]] RingAccount account(std::uint64_t clocks) const {
    return {whole(clocks_, SquareActivity::waiting_for_divider, clocks), words_, full_clocks_};
  }
  /// For waves: words that have been carried in the frame; whether some channel carries one.
  [[nodiscard]] std::uint64_t words() const { return words_; }
  [[nodiscard]] bool is_carrying() const { return edges() < busy_until_; }

 private:
  void end_of_elaboration() override;
  void on_clock() override;
  [[nodiscard]] std::uint64_t edges() const;
  [[nodiscard]] bool has_words();
  void carry();
  bool carry_from(std::size_t source);
  bool carry_command(std::size_t processor, std::size_t renderer);
  bool carry_header(std::size_t processor);
  bool carry_colours(std::size_t renderer);

  const sc_core::sc_time period_;
  const std::size_t channels_;
  const std::uint64_t word_clocks_;
  const std::size_t banks_;
  std::uint64_t begun_at_ = 0;         ///< edge
  std::size_t turn_ = 0;               ///< source that is asked first
  std::vector<bool> taken_;            ///< renderers, in the clock at hand
  std::size_t frame_buffer_left_ = 0;  ///< words that the frame buffer takes in it besides
  SquareClocks clocks_;
  std::uint64_t words_ = 0;
  std::uint64_t full_clocks_ = 0;
  std::uint64_t busy_until_ = 0;             ///< edge
  sc_core::sc_event_or_list words_written_;  ///< at any source, or a frame has begun
  sc_core::sc_event begun_;
};

}  // namespace csgsim::pixel_square
