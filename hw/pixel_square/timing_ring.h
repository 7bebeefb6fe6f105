#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_processors.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// The ring, as edges see it.
class RingTiming {
 public:
  RingTiming(const machines::Machine& machine, ProcessorsTiming& processors, std::vector<RendererTiming>& renderers,
             Agenda& agenda);

  /// What it does at an edge: in every last clock of a channel's word it carries what waits.
  void carry(Time now);

  /// What it has brought to the frame buffer: colours of each renderer, and behind these headers of each processor.
  [[nodiscard]] std::vector<Fifo<TimedPortWord>>& carried() { return carried_; }

  [[nodiscard]] RingAccount account(Time end);

 private:
  /// What became of a source at an edge.
  enum class Found : std::uint8_t { stuck, later, carried };

  Found carry_from(std::size_t source, Time now);
  Found carry_from_processor(std::size_t number, Time now);
  Found carry_from_renderer(std::size_t number, Time now);
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
  Numbers sources_;                  ///< with words: processors, and behind them renderers
  std::size_t turn_ = 0;             ///< source that is asked first
  std::size_t to_frame_buffer_ = 0;  ///< words carried there at it
  std::uint64_t words_ = 0;
  std::uint64_t full_steps_ = 0;
};

}  // namespace csgsim::pixel_square
