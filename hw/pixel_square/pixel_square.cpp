#include "hw/pixel_square/pixel_square.h"

#include <algorithm>
#include <numeric>

#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

namespace {

/// Makes each member of a vector of FIFOs.
template <class Word>
auto fifo_maker(int depth) {
  return [depth](const char* name, std::size_t /*index*/) { return new sc_core::sc_fifo<Word>(name, depth); };
}

int depth_of(const machines::Machine& machine) { return static_cast<int>(machine.pixel_square.fifo_depth); }

}  // namespace

PixelSquareMachine::PixelSquareMachine(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      clock_("clock", kernel::period_of(machine), 0.5, kernel::period_of(machine)),
      model_("model", depth_of(machine)),
      instructions_("instructions", machine.pixel_square.renderers, fifo_maker<InstructionWord>(depth_of(machine))),
      colours_("colours", machine.pixel_square.renderers, fifo_maker<ColourWord>(depth_of(machine))),
      clears_("clears", depth_of(machine)),
      finished_("finished", machine.pixel_square.renderers),
      host_("host", machine.pixel_square.host_word_clocks),
      divider_("divider", machine.pixel_square),
      renderers_("renderers", machine.pixel_square.renderers,
                 [&](const char* renderer, std::size_t /*index*/) { return new Renderer(renderer, machine); }),
      frame_buffer_("frame_buffer", machine.picture, machine.pixel_square.renderers) {
  SC_HAS_PROCESS(PixelSquareMachine);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  host_.clock(clock_);
  host_.model(model_);

  divider_.clock(clock_);
  divider_.model(model_);
  divider_.links(instructions_);
  divider_.finished(finished_);
  divider_.clears(clears_);

  for (std::size_t i = 0; i < renderers_.size(); ++i) {
    renderers_[i].clock(clock_);
    renderers_[i].link(instructions_[i]);
    renderers_[i].colours(colours_[i]);
    renderers_[i].finished(finished_[i]);
    renderers_[i].retirement(retirement_);
  }

  frame_buffer_.clock(clock_);
  frame_buffer_.colours(colours_);
  frame_buffer_.clears(clears_);
  frame_buffer_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << frames_;
}

/// Gives control back to who started the simulation, when all that belongs to this edge has happened.
void PixelSquareMachine::on_done() { sc_core::sc_pause(); }

RunReport PixelSquareMachine::run(const isa::Program& program, RunListener& listener) {
  if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(sc_core::SC_ZERO_TIME);
  begin(program, listener);
  if (!program.segments.empty()) sc_core::sc_start();
  retirement_.rethrow();
  const machines::SquareClocks& counted = frame_buffer_.account();
  return {.clocks = std::accumulate(counted.begin(), counted.end(), std::uint64_t{0}), .account = account()};
}

void PixelSquareMachine::begin(const isa::Program& program, RunListener& listener) {
  const isa::Field colour = isa::field_of(program, isa::FieldRole::colour);
  const std::uint64_t model_words = program.segments.empty() ? 0 : program.model.primitives + program.model.halfspaces;
  retirement_.begin(listener);
  host_.begin(model_words);
  divider_.begin({.segments = program.segments, .model_words = model_words, .primitives = program.model.primitives});
  std::for_each(renderers_.begin(), renderers_.end(), [&](Renderer& renderer) { renderer.begin(colour); });
  frame_buffer_.begin(
      {.squares = program.segments.size(), .colour_bits = colour.width, .background = program.compile.background});
}

machines::SquareAccount PixelSquareMachine::account() const {
  machines::SquareAccount account;
  account.squares_skipped = divider_.squares_skipped();
  account.host = host_.account();
  account.divider = divider_.account();
  account.frame_buffer = frame_buffer_.account();
  std::for_each(renderers_.begin(), renderers_.end(), [&](const Renderer& renderer) {
    account.renderers.push_back(renderer.account());
    account.renderer_squares.push_back(renderer.squares());
    account.squares_drawn += renderer.squares();
  });
  return account;
}

}  // namespace csgsim::pixel_square
