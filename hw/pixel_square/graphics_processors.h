#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/ring_word.h"
#include "hw/pixel_square/sender.h"
#include "hw/systemc/clocked_module.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_square {

/// Processors that divide the model. Each takes the next square that no other has taken, asks for a renderer, and puts
/// the square's commands on its place of the ring, a word a clock as long as there is room; of a square in which
/// nothing is seen, a header for the frame buffer. It keeps the renderer, and takes no other square, until all of this
/// is gone.
///
/// What it sends it has compiled while the frame before was drawn (hw/host). It asks for a renderer before its first
/// word, and gets, of the renderers that no other processor keeps, the one with the
/// fewest squares that it has not finished, the first of those. A renderer that is let go can be had at the next edge.
/// Of processors that want the same at one edge the first gets it.
class GraphicsProcessors final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_out<RingWord>> words;  ///< one a processor
  /// Of each: where its words go, a renderer, or behind the last the frame buffer.
  sc_core::sc_vector<sc_core::sc_out<std::uint64_t>> targets;
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> finished;  ///< squares that each renderer has finished
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  GraphicsProcessors(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Starts at the next edge. The segments have to live until the frame is drawn.
  void begin(std::span<const isa::Segment> segments);

  [[nodiscard]] std::size_t count() const { return processors_.size(); }
  [[nodiscard]] std::uint64_t squares_skipped() const { return skipped_; }
  /// Of a processor, in a frame of so many clocks.
  [[nodiscard]] SquareClocks account(std::size_t processor, std::uint64_t clocks) const {
    return whole(processors_[processor].clocks, SquareActivity::done, clocks);
  }
  [[nodiscard]] const SenderStatus& status(std::size_t processor) const { return processors_[processor].status; }

 private:
  struct Processor {
    std::optional<std::size_t> square;    ///< at hand
    bool is_clear = false;                ///< nothing is seen there
    std::vector<isa::LinkWord> commands;  ///< of it, in words
    std::size_t sent = 0;                 ///< words of these, or of its header
    bool all_sent = false;                ///< but some wait for the ring
    std::optional<std::size_t> renderer;  ///< that it keeps
    SquareActivity activity{};            ///< in the clock that ended last, and in those slept since
    SquareClocks clocks;
    SenderStatus status;
  };

  void end_of_elaboration() override;
  void on_clock() override;
  [[nodiscard]] bool all_wait() const;
  [[nodiscard]] bool are_done() const;
  void let_go(std::size_t number);
  SquareActivity act(std::size_t number);
  bool take_square(Processor& processor);
  bool ask_for_renderer(Processor& processor);
  void send(std::size_t number);
  [[nodiscard]] RingWord next_word(const Processor& processor) const;
  void note(std::size_t number, SquareActivity activity);

  const sc_core::sc_time period_;
  const std::uint32_t word_bits_;
  const std::uint32_t latency_;
  const std::size_t fifo_depth_;  ///< of a place of the ring
  std::span<const isa::Segment> segments_;
  std::size_t next_ = 0;  ///< square that nobody has taken
  std::uint32_t latency_left_ = 0;
  std::vector<Processor> processors_;
  std::vector<bool> kept_;             ///< renderers
  std::vector<std::uint64_t> handed_;  ///< squares that each renderer has got
  std::uint64_t skipped_ = 0;
  std::uint64_t acted_at_ = 0;             ///< edge
  sc_core::sc_event_or_list words_taken_;  ///< by the ring, of any of them; or a frame has begun
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
