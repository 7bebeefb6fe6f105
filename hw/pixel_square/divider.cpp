#include "hw/pixel_square/divider.h"

namespace csgsim::pixel_square {

using machines::SquareActivity;

Divider::Divider(sc_core::sc_module_name name, const machines::PixelSquare& figures)
    : sc_core::sc_module(name),
      links("links", figures.renderers),
      finished("finished", figures.renderers),
      primitive_clocks_(figures.primitive_clocks),
      halfspace_clocks_(figures.halfspace_clocks),
      handed_(figures.renderers) {
  SC_HAS_PROCESS(Divider);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void Divider::begin(const Division& division) {
  division_ = division;
  skipped_ = 0;
  counter_.clear();
  begin_square(0);
}

void Divider::begin_square(std::size_t square) {
  square_ = square;
  index_ = 0;
  target_.reset();
  if (square_ == division_.segments.size()) return;
  tests_left_ = division_.primitives * primitive_clocks_ + division_.segments[square_].halfspaces * halfspace_clocks_;
}

void Divider::on_clock() { counter_.count(act()); }

SquareActivity Divider::act() {
  if (division_.model_words > 0) return take_model();
  if (square_ == division_.segments.size()) return SquareActivity::done;
  if (tests_left_ > 0) {
    --tests_left_;
    return SquareActivity::working;
  }
  return division_.segments[square_].instructions.empty() ? clear() : send();
}

SquareActivity Divider::take_model() {
  ModelWord word;
  if (!model.nb_read(word)) return SquareActivity::waiting_for_host;
  --division_.model_words;
  return SquareActivity::working;
}

SquareActivity Divider::clear() {
  if (!clears.nb_write({division_.segments[square_].region})) return SquareActivity::waiting_for_frame_buffer;
  ++skipped_;
  begin_square(square_ + 1);
  return SquareActivity::working;
}

SquareActivity Divider::send() {
  if (!target_) {
    target_ = least_busy();
    ++handed_[*target_];
  }
  const isa::Segment& segment = division_.segments[square_];
  const bool end = index_ == segment.instructions.size();
  const InstructionWord word{.square = {static_cast<std::uint32_t>(square_), segment.region},
                             .instruction = end ? nullptr : &segment.instructions[index_]};
  if (!links[*target_].nb_write(word)) return SquareActivity::waiting_for_renderer;
  ++index_;
  if (end) begin_square(square_ + 1);
  return SquareActivity::working;
}

std::size_t Divider::least_busy() const {
  std::size_t best = 0;
  const auto unfinished = [&](std::size_t renderer) { return handed_[renderer] - finished[renderer].read(); };
  for (std::size_t renderer = 1; renderer < handed_.size(); ++renderer) {
    if (unfinished(renderer) < unfinished(best)) best = renderer;
  }
  return best;
}

}  // namespace csgsim::pixel_square
