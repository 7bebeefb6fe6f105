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

/// Processors that divide the model. Each takes the next square, requests a renderer, and sends the square's commands
/// to its port of the ring, one word per clock while there is room; for an empty square it sends a header to the frame
/// buffer. The processor keeps the renderer, and takes no other square, until the ring has taken all of these words.
/// Each processor sends the commands that it compiled while the previous frame was drawn (hw/host).
///
/// A processor requests a renderer before its first word. It is assigned the renderer with the fewest unfinished
/// squares among those that no other processor keeps; ties go to the lowest number. A released renderer is available
/// from the next edge on. If several processors request at the same edge, the lowest number is served first.
class GraphicsProcessors final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_fifo_out<RingWord>> words;  ///< one per processor
  /// Destination of each processor's words: a renderer, or the frame buffer (number of renderers).
  sc_core::sc_vector<sc_core::sc_out<std::uint64_t>> targets;
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> finished;  ///< squares finished by each renderer
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  GraphicsProcessors(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Starts at the next edge. The segments must outlive the frame.
  void begin(std::span<const isa::Segment> segments);

  [[nodiscard]] std::size_t count() const { return processors_.size(); }
  [[nodiscard]] std::uint64_t squares_skipped() const { return skipped_; }
  /// Clocks by activity of a processor in a frame of `clocks` clocks.
  [[nodiscard]] SquareClocks account(std::size_t processor, std::uint64_t clocks) const {
    return complete_clocks(processors_[processor].clocks, SquareActivity::done, clocks);
  }
  [[nodiscard]] const SenderStatus& status(std::size_t processor) const { return processors_[processor].status; }

 private:
  struct Processor {
    std::optional<std::size_t> square;    ///< square in progress
    bool is_clear = false;                ///< whether the square is empty
    std::vector<isa::LinkWord> commands;  ///< commands of the square, as link words
    std::size_t sent = 0;                 ///< number of these words, or of the header's, already sent
    bool all_sent = false;                ///< whether all words are sent but some still wait for the ring
    std::optional<std::size_t> renderer;  ///< renderer that the processor keeps
    /// Activity of the last clock, and of the clocks since then in which the processor slept.
    SquareActivity activity{};
    SquareClocks clocks;
    SenderStatus status;
  };

  void end_of_elaboration() override;
  void on_clock() override;
  [[nodiscard]] bool all_stalled() const;
  [[nodiscard]] bool all_done() const;
  void release_renderer(std::size_t processor_index);
  SquareActivity act_processor(std::size_t processor_index);
  bool try_take_square(Processor& processor);
  bool try_request_renderer(Processor& processor);
  void send_word(std::size_t processor_index);
  [[nodiscard]] RingWord next_word(const Processor& processor) const;
  void record_activity(std::size_t processor_index, SquareActivity activity);

  const sc_core::sc_time period_;
  const std::uint32_t word_bits_;
  const std::uint32_t latency_;
  const std::size_t fifo_depth_;  ///< depth of a port of the ring
  std::span<const isa::Segment> segments_;
  std::size_t next_ = 0;  ///< first square that no processor has taken
  std::uint32_t latency_left_ = 0;
  std::vector<Processor> processors_;
  std::vector<bool> reserved_;           ///< renderers kept by a processor
  std::vector<std::uint64_t> assigned_;  ///< squares assigned to each renderer
  std::uint64_t skipped_ = 0;
  std::uint64_t acted_at_ = 0;             ///< clock edge
  sc_core::sc_event_or_list words_taken_;  ///< a word was taken from any processor, or a frame has begun
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
