#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_processors.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// Edge-level model of the ring.
class RingTiming {
 public:
  RingTiming(const machines::Machine& machine, ProcessorsTiming& processors, std::vector<RendererTiming>& renderers,
             Agenda& agenda);

  /// Lets the ring act at an edge: it carries waiting words in the last clock of each word period.
  void carry(Time now);

  /// FIFOs to the frame buffer: colours of each renderer, followed by headers of each processor.
  [[nodiscard]] std::vector<Fifo<TimedPortWord>>& carried() { return carried_; }

  [[nodiscard]] RingAccount account(Time end);

 private:
  /// Result of polling a source at an edge.
  enum class Outcome : std::uint8_t {
    stuck,    ///< no word can be carried until another unit acts
    later,    ///< a word can be carried at a later edge, even if no other unit acts
    carried,  ///< a word was carried
  };

  Outcome carry_from(std::size_t source, Time now);
  Outcome carry_from_processor(std::size_t index, Time now);
  Outcome carry_from_renderer(std::size_t index, Time now);
  [[nodiscard]] Time step_after(Time now) const { return (now / word_clocks_ + 1) * word_clocks_; }

  const Time word_clocks_;
  const std::size_t banks_;
  ProcessorsTiming& processors_;
  std::vector<RendererTiming>& renderers_;
  Agenda& agenda_;
  const std::size_t part_;
  std::size_t channels_;
  std::vector<Fifo<TimedPortWord>> carried_;
  PartClocks clocks_;
  IndexSet sources_;                 ///< sources that hold words: processors, then renderers
  std::size_t turn_ = 0;             ///< source that is polled first
  std::size_t to_frame_buffer_ = 0;  ///< words carried to the frame buffer at this edge
  std::uint64_t words_ = 0;
  std::uint64_t full_steps_ = 0;
};

}  // namespace csgsim::pixel_square
