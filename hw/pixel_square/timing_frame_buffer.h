#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/pixel_square/timing_renderer.h"
#include "hw/pixel_square/timing_screen.h"

namespace csgsim::pixel_square {

/// The frame buffer, as edges see it.
class FrameBufferTiming {
 public:
  /// For the frame's squares: its ports, those through which the renderers' colours come, and, behind these, those
  /// through which headers of squares to clear do.
  FrameBufferTiming(const isa::Program& program, const machines::Machine& machine,
                    std::vector<Fifo<TimedPortWord>*> ports, Agenda& agenda);

  /// What it does at an edge: the ports take turns.
  void store(Time now);

  /// Edge at which the last square was whole; 0 before.
  [[nodiscard]] Time end() const { return end_; }
  [[nodiscard]] SquareClocks clocks(Time end);

 private:
  /// While a square that has come through it is being cleared.
  [[nodiscard]] bool clears_now(std::size_t port) const {
    return port >= renderers_ && clears_[port - renderers_].words_left() > 0;
  }
  [[nodiscard]] std::optional<TimedPortWord> waiting(std::size_t port, Time now);
  [[nodiscard]] bool has_something(std::size_t port) const { return clears_now(port) || ports_[port]->word_follows(); }
  [[nodiscard]] LeavingSquare background_of(std::size_t square) const;
  bool take_bank(const TimedPortWord& word);
  void take(std::size_t port, const TimedPortWord& word, Time now);

  const isa::Program& program_;
  const machines::Machine& machine_;
  const std::uint32_t banks_;
  const std::size_t renderers_;
  std::vector<Fifo<TimedPortWord>*> ports_;
  Agenda& agenda_;
  ScreenTiming screen_;
  PartClocks clocks_;
  Numbers giving_;                     ///< ports that have something to be stored
  std::size_t turn_ = 0;               ///< port that is asked first
  std::vector<LeavingSquare> clears_;  ///< squares that are being cleared, one a port behind the renderers'
  std::vector<std::uint32_t> taken_;   ///< banks, in the clock at hand
  std::uint64_t shared_ = 0;           ///< clocks in which the screen took a turn, and a word was stored
  std::uint64_t stored_ = 0;
  Time end_ = 0;
};

}  // namespace csgsim::pixel_square
