#pragma once

#include <cstdint>
#include <vector>

#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// The frame buffer, as edges see it.
class FrameBufferTiming {
 public:
  /// For a frame of so many squares, which come from the renderers or are cleared.
  FrameBufferTiming(std::size_t squares, std::vector<RendererTiming>& renderers, Fifo<TimedPortWord>& clears,
                    Agenda& agenda);

  /// What it does at an edge: renderers and, as the last, the sender take turns.
  void store(Time now);

  /// Edge at which the last square was whole; 0 before.
  [[nodiscard]] Time end() const { return end_; }
  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.whole(end); }

 private:
  [[nodiscard]] bool is_sender(std::size_t port) const { return port == renderers_.size(); }
  [[nodiscard]] Fifo<TimedPortWord>& fifo(std::size_t port) {
    return is_sender(port) ? clears_ : renderers_[port].colours();
  }
  void take(std::size_t port, Time now);
  void clear(Time now);
  void served(std::size_t port, bool square_ends, Time now);

  const std::size_t squares_;
  std::vector<RendererTiming>& renderers_;
  Fifo<TimedPortWord>& clears_;
  Agenda& agenda_;
  PartClocks clocks_;
  std::size_t turn_ = 0;          ///< port that is asked first
  std::uint64_t clear_left_ = 0;  ///< words of background
  std::uint64_t stored_ = 0;
  Time end_ = 0;
};

}  // namespace csgsim::pixel_square
