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
  /// For the frame's squares, which come from the renderers or are cleared.
  FrameBufferTiming(const isa::Program& program, const machines::Machine& machine,
                    std::vector<RendererTiming>& renderers, Fifo<TimedPortWord>& clears, Agenda& agenda);

  /// What it does at an edge: renderers and, as the last, the sender take turns.
  void store(Time now);

  /// Edge at which the last square was whole; 0 before.
  [[nodiscard]] Time end() const { return end_; }
  [[nodiscard]] SquareClocks clocks(Time end);

 private:
  [[nodiscard]] bool is_sender(std::size_t port) const { return port == renderers_.size(); }
  [[nodiscard]] Fifo<TimedPortWord>& fifo(std::size_t port) {
    return is_sender(port) ? clears_ : renderers_[port].colours();
  }
  [[nodiscard]] std::optional<TimedPortWord> waiting(std::size_t port, Time now);
  [[nodiscard]] LeavingSquare background_of(std::size_t square) const;
  bool take_bank(const TimedPortWord& word);
  void take(std::size_t port, const TimedPortWord& word, Time now);

  const isa::Program& program_;
  const machines::Machine& machine_;
  const std::uint32_t banks_;
  std::vector<RendererTiming>& renderers_;
  Fifo<TimedPortWord>& clears_;
  Agenda& agenda_;
  const ScreenTiming screen_;
  PartClocks clocks_;
  std::size_t turn_ = 0;              ///< port that is asked first
  LeavingSquare clear_;               ///< a square that is being cleared
  std::vector<std::uint32_t> taken_;  ///< banks, in the clock at hand
  std::uint64_t shared_ = 0;          ///< clocks in which the screen took a turn, and a word was stored
  std::uint64_t stored_ = 0;
  Time end_ = 0;
};

}  // namespace csgsim::pixel_square
