#include "hw/pixel_square/timing_frame_buffer.h"

namespace csgsim::pixel_square {

FrameBufferTiming::FrameBufferTiming(std::size_t squares, std::vector<RendererTiming>& renderers,
                                     Fifo<TimedPortWord>& clears, Agenda& agenda)
    : squares_(squares), renderers_(renderers), clears_(clears), agenda_(agenda) {}

void FrameBufferTiming::store(Time now) {
  const std::size_t ports = renderers_.size() + 1;
  bool word_follows = false;
  for (std::size_t i = 0; i < ports; ++i) {
    const std::size_t port = (turn_ + i) % ports;
    if (is_sender(port) && clear_left_ > 0) return clear(now);
    if (fifo(port).has_word(now)) return take(port, now);
    word_follows = word_follows || fifo(port).word_follows();
  }
  if (word_follows) agenda_.put(PartNumbers{renderers_.size()}.frame_buffer(), now + 1);
}

void FrameBufferTiming::take(std::size_t port, Time now) {
  const TimedPortWord word = fifo(port).read(now);
  if (is_sender(port)) clear_left_ = word.clear_clocks;
  const bool colours_follow = is_sender(port) && clear_left_ > 0;
  served(port, word.last && !colours_follow, now);
}

void FrameBufferTiming::clear(Time now) { served(renderers_.size(), --clear_left_ == 0, now); }

void FrameBufferTiming::served(std::size_t port, bool square_ends, Time now) {
  turn_ = (port + 1) % (renderers_.size() + 1);
  clocks_.wait(SquareActivity::waiting_for_renderer, now);
  clocks_.work(1);
  if (square_ends && ++stored_ == squares_) end_ = now;
  agenda_.put(PartNumbers{renderers_.size()}.frame_buffer(), now + 1);
}

}  // namespace csgsim::pixel_square
