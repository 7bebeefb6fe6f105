#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/pixel_square/timing_renderer.h"
#include "hw/pixel_square/timing_screen.h"

namespace csgsim::pixel_square {

/// Edge-level model of the frame buffer.
class FrameBufferTiming {
 public:
  /// `ports`: the renderers' colour ports, followed by the ports for headers of squares to clear.
  FrameBufferTiming(const isa::Program& program, const machines::Machine& machine,
                    std::vector<Fifo<TimedPortWord>*> ports, Agenda& agenda);

  /// Lets the frame buffer act at an edge: it serves the ports round-robin.
  void store(Time now);

  /// Edge at which the last square was complete; 0 before that edge.
  [[nodiscard]] Time end() const { return end_; }
  [[nodiscard]] SquareClocks clocks(Time end);

 private:
  /// Whether a square that was received through the port is being cleared.
  [[nodiscard]] bool is_clearing(std::size_t port) const {
    return port >= renderers_ && clears_[port - renderers_].words_left() > 0;
  }
  [[nodiscard]] std::optional<TimedPortWord> next_port_word(std::size_t port, Time now);
  [[nodiscard]] bool has_pending(std::size_t port) const { return is_clearing(port) || ports_[port]->has_word_next(); }
  [[nodiscard]] LeavingSquare background_square(std::size_t square) const;
  bool try_claim_bank(const TimedPortWord& word);
  void accept_word(std::size_t port, const TimedPortWord& word, Time now);

  const isa::Program& program_;
  const machines::Machine& machine_;
  const std::uint32_t banks_;
  const std::size_t renderers_;
  std::vector<Fifo<TimedPortWord>*> ports_;
  Agenda& agenda_;
  ScreenTiming screen_;
  PartClocks clocks_;
  IndexSet ready_ports_;               ///< ports with something to store
  std::size_t turn_ = 0;               ///< port that is polled first
  std::vector<LeavingSquare> clears_;  ///< squares being cleared, one per port after the renderers'
  std::vector<std::uint32_t> taken_;   ///< banks claimed in the current clock
  std::uint64_t shared_ = 0;           ///< clocks in which the screen took a turn and a word was stored
  std::uint64_t stored_ = 0;
  Time end_ = 0;
};

}  // namespace csgsim::pixel_square
