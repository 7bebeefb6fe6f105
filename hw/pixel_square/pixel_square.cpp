#include "hw/pixel_square/pixel_square.h"

#include <algorithm>
#include <string>
#include <utility>

#include "hw/machines/regions.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/pixel_square/renderer_taps.h"
#include "hw/pixel_square/storage_check.h"
#include "hw/pixel_square/taps.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/maker.h"
#include "hw/wave/pixel_taps.h"
#include "hw/wave/segments.h"

namespace csgsim::pixel_square {

namespace {

/// Returns a function that creates the members of a vector of FIFOs.
template <class Word>
auto fifo_maker(int depth) {
  return [depth](const char* name, std::size_t /*index*/) { return new sc_core::sc_fifo<Word>(name, depth); };
}

int link_depth(const machines::Machine& machine) { return static_cast<int>(machine.link.fifo_depth); }

int port_depth(const machines::Machine& machine) {
  return static_cast<int>(machines::kind_figures<Figures>(machine).port_fifo_depth);
}

/// Number of units that send headers of squares to clear.
std::size_t clearing_parts(const Figures& figures) { return has_ring(figures) ? figures.processors : 1; }

}  // namespace

PixelSquareMachine::RingParts::RingParts(const machines::Machine& machine)
    : words("processor_words", machines::kind_figures<Figures>(machine).processors,
            fifo_maker<RingWord>(port_depth(machine))),
      targets("targets", words.size()),
      colours("carried_colours", machines::kind_figures<Figures>(machine).renderers,
              fifo_maker<PortWord>(port_depth(machine))),
      ring("ring", machine) {}

PixelSquareMachine::PixelSquareMachine(sc_core::sc_module_name name, const machines::Machine& machine,
                                       systemc::EvaluatorForm form)
    : sc_core::sc_module(name),
      machine_(machine),
      clock_("clock", systemc::period_of(machine)),
      instructions_("instructions", machines::kind_figures<Figures>(machine).renderers,
                    fifo_maker<isa::LinkWord>(link_depth(machine))),
      colours_("colours", machines::kind_figures<Figures>(machine).renderers,
               fifo_maker<PortWord>(port_depth(machine))),
      clears_("clears", clearing_parts(machines::kind_figures<Figures>(machine)),
              fifo_maker<PortWord>(port_depth(machine))),
      finished_("finished", machines::kind_figures<Figures>(machine).renderers),
      renderers_("renderers", machines::kind_figures<Figures>(machine).renderers,
                 [&](const char* renderer, std::size_t /*index*/) { return new Renderer(renderer, machine, form); }),
      frame_buffer_("frame_buffer", machine) {
  SC_HAS_PROCESS(PixelSquareMachine);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  bind_front(machine);

  for (std::size_t i = 0; i < renderers_.size(); ++i) {
    renderers_[i].clock(clock_);
    renderers_[i].link(instructions_[i]);
    renderers_[i].colours(colours_[i]);
    renderers_[i].finished(finished_[i]);
    renderers_[i].retirement(retirement_);
  }

  frame_buffer_.clock(clock_);
  frame_buffer_.colours(ring_ ? ring_->colours : colours_);
  frame_buffer_.clears(clears_);
  frame_buffer_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << frames_;
}

void PixelSquareMachine::bind_front(const machines::Machine& machine) {
  switch (machines::kind_figures<Figures>(machine).divider) {
    case DividerKind::host: front_.host = std::make_unique<HostSender>("host", machine); return bind_sender();
    case DividerKind::corners: bind_divider(machine); return bind_sender();
    case DividerKind::processors: return bind_ring(machine);
  }
}

void PixelSquareMachine::bind_divider(const machines::Machine& machine) {
  front_.model = std::make_unique<sc_core::sc_fifo<isa::LinkWord>>("model", link_depth(machine));
  front_.source = std::make_unique<ModelSource>("host", machine.link);
  front_.source->clock(clock_);
  front_.source->words(*front_.model);
  front_.receiver = std::make_unique<ModelReceiver>("receiver", machine);
  front_.receiver->clock(clock_);
  front_.receiver->model(*front_.model);
  for (std::uint32_t i = 0; i < machines::kind_figures<Figures>(machine).dividers; ++i)
    front_.dividers.push_back(
        std::make_unique<CornerDivider>(("divider_" + std::to_string(i)).c_str(), machine, *front_.receiver));
  front_.sender = std::make_unique<StoreSender>("sender", machine);
}

void PixelSquareMachine::bind_sender() {
  sender().clock(clock_);
  sender().links(instructions_);
  sender().finished(finished_);
  sender().clears(clears_[0]);
  sender().retirement(retirement_);
}

void PixelSquareMachine::bind_ring(const machines::Machine& machine) {
  ring_ = std::make_unique<RingParts>(machine);
  front_.processors = std::make_unique<GraphicsProcessors>("processors", machine);
  front_.processors->clock(clock_);
  front_.processors->words(ring_->words);
  front_.processors->targets(ring_->targets);
  front_.processors->finished(finished_);
  front_.processors->retirement(retirement_);
  Ring& ring = ring_->ring;
  ring.clock(clock_);
  ring.processors(ring_->words);
  ring.targets(ring_->targets);
  ring.renderers(colours_);
  ring.links(instructions_);
  ring.colours(ring_->colours);
  ring.clears(clears_);
}

void PixelSquareMachine::begin_front(const isa::Program& program) {
  if (front_.host) return front_.host->begin(program.segments);
  if (front_.processors) {
    ring_->ring.begin();
    return front_.processors->begin(program.segments);
  }
  const isa::FrameHeader header = isa::frame_header(program);
  front_.source->begin(program.display_model);
  front_.receiver->begin(program.display_model.size());
  begin_dividers({header.shape.width, header.shape.height});
}

/// Assigns groups of squares, or single squares at one level, to the dividers round-robin.
void PixelSquareMachine::begin_dividers(const machines::Size& picture) {
  machines::Machine drawing = machine_;
  drawing.picture = picture;
  squares_ = machines::regions(drawing);
  std::vector<std::vector<std::size_t>> own(front_.dividers.size());
  std::vector<Store*> stores;
  std::size_t turn = 0;
  for (std::size_t square = 0; square < squares_.size(); ++square) {
    const CornerDivider& any = *front_.dividers.front();
    if (square > 0 && !any.are_in_same_group(squares_[square - 1], squares_[square])) turn = (turn + 1) % own.size();
    own[turn].push_back(square);
    stores.push_back(&front_.dividers[turn]->store());
  }
  for (std::size_t i = 0; i < own.size(); ++i) front_.dividers[i]->begin(picture, squares_, std::move(own[i]));
  front_.sender->begin(squares_, std::move(stores));
}

/// Returns control to the caller of run() after all events of this edge.
void PixelSquareMachine::on_done() { sc_core::sc_pause(); }

systemc::RunReport PixelSquareMachine::run(const isa::Program& program, systemc::RunListener& listener) {
  systemc::elaborate();
  check_division(program, machine_);
  const std::uint64_t start_clock = edges();
  begin(program, listener);
  if (!program.segments.empty()) systemc::run();
  retirement_.rethrow();
  const std::uint64_t clocks = edges() - start_clock;
  std::uint64_t skipped = 0;
  std::for_each(renderers_.begin(), renderers_.end(), [&](const Renderer& one) { skipped += one.skipped(); });
  return {.clocks = clocks,
          .skipped = skipped,
          .answers = {},
          .account = account(frame_account(clocks)),
          .picture = picture_of(program)};
}

std::vector<std::uint32_t> PixelSquareMachine::picture_of(const isa::Program& program) const {
  if (program.colour.width == 0) return {};
  return {frame_buffer_.picture().begin(), frame_buffer_.picture().end()};
}

void PixelSquareMachine::begin(const isa::Program& program, systemc::RunListener& listener) {
  const isa::FrameHeader header = isa::frame_header(program);
  retirement_.begin(listener);
  names_.begin(program.segments);
  begin_front(program);
  std::for_each(renderers_.begin(), renderers_.end(),
                [&](Renderer& renderer) { renderer.begin(header.colour, names_); });
  frame_buffer_.begin({.picture = {header.shape.width, header.shape.height},
                       .squares = program.segments.size(),
                       .colour_bits = header.colour.width,
                       .background = header.background});
}

/// Clock edges since the machine was built.
std::uint64_t PixelSquareMachine::edges() const { return systemc::edges(clock_.period()); }

SquareAccount PixelSquareMachine::frame_account(std::uint64_t clocks) const {
  SquareAccount account;
  account.squares_skipped = front_.processors ? front_.processors->squares_skipped() : sender().squares_skipped();
  if (front_.host) account.host = front_.host->account(clocks);
  if (front_.source) account.host = front_.source->account(clocks);
  if (front_.processors) {
    for (std::size_t i = 0; i < front_.processors->count(); ++i)
      account.processors.push_back(front_.processors->account(i, clocks));
    account.ring = ring_->ring.account(clocks);
  }
  for (const auto& divider : front_.dividers) account.dividers.push_back(divider->account(clocks));
  if (front_.sender) account.sender = front_.sender->account(clocks);
  account.frame_buffer = frame_buffer_.account(clocks);
  std::for_each(renderers_.begin(), renderers_.end(), [&](const Renderer& renderer) {
    account.renderers.push_back(renderer.account(clocks));
    account.renderer_squares.push_back(renderer.squares());
    account.squares_drawn += renderer.squares();
  });
  return account;
}

std::vector<wave::Tap> PixelSquareMachine::taps(const isa::Program& program, const wave::Request& request) const {
  std::vector<wave::Tap> taps = front_taps(program);
  const auto add = [&](std::vector<wave::Tap> more) { wave::add(std::move(more), taps); };
  for (std::size_t i = 0; i < renderers_.size(); ++i) {
    const std::string part = "renderer_" + std::to_string(i);
    taps.push_back(fill_tap(part + ".link_fill", instructions_[i]));
    taps.push_back(fill_tap(part + ".port_fill", colours_[i]));
    add(renderer_taps(part, renderers_[i].parts(), program, names_));
  }
  add(frame_buffer_taps(frame_buffer_, program, names_));
  for (const wave::Pixel pixel : request.pixels) add(pixel_taps(pixel, program, request));
  return taps;
}

std::vector<wave::Tap> PixelSquareMachine::front_taps(const isa::Program& program) const {
  std::vector<wave::Tap> taps;
  if (front_.source) {
    taps.push_back(wave::text("host.state", [this] { return std::string(front_.source->state()); }));
    taps.push_back(wave::number("host.words", 32, [this] { return wave::Number(front_.source->words_sent()); }));
    taps.push_back(fill_tap("model.fill", *front_.model));
  }
  for (std::size_t i = 0; i < front_.dividers.size(); ++i) {
    const std::string part = front_.dividers.size() == 1 ? "divider" : "divider_" + std::to_string(i);
    wave::add(divider_taps(part, *front_.dividers[i], program), taps);
  }
  if (front_.processors) {
    wave::add(processor_taps(program), taps);
    return taps;
  }
  wave::add(sender_taps(front_.host ? "host" : "sender", sender().status(), program), taps);
  taps.push_back(fill_tap("clears.fill", clears_[0]));
  return taps;
}

std::vector<wave::Tap> PixelSquareMachine::processor_taps(const isa::Program& program) const {
  std::vector<wave::Tap> taps;
  for (std::size_t i = 0; i < front_.processors->count(); ++i) {
    const std::string part = "processor_" + std::to_string(i);
    wave::add(sender_taps(part, front_.processors->status(i), program), taps);
    taps.push_back(fill_tap(part + ".ring_fill", ring_->words[i]));
  }
  taps.push_back(wave::text("ring.state", [this] { return std::string(ring_->ring.is_carrying() ? "working" : ""); }));
  taps.push_back(wave::number("ring.words", 32, [this] { return wave::Number(ring_->ring.words()); }));
  return taps;
}

std::vector<wave::Tap> PixelSquareMachine::pixel_taps(wave::Pixel pixel, const isa::Program& program,
                                                      const wave::Request& request) const {
  const std::uint32_t segment = wave::segment_of(pixel, program);
  std::vector<std::vector<wave::Tap>> each;
  std::for_each(renderers_.begin(), renderers_.end(), [&](const Renderer& renderer) {
    each.push_back(
        pixel_square::pixel_taps(pixel, segment, renderer.parts(), program, request.tree_levels, machine_.alu_bits));
  });
  std::vector<wave::Tap> taps = merge_taps(std::move(each));
  const std::string part = wave::pixel_part_name(pixel);
  taps.push_back(wave::number(part + ".renderer", 8, [this, segment]() -> wave::Number {
    for (std::size_t i = 0; i < renderers_.size(); ++i) {
      if (holds_segment(renderers_[i].parts(), segment)) return i;
    }
    return std::nullopt;
  }));
  const std::size_t place = std::size_t{pixel.y} * program.shape.width + pixel.x;
  taps.push_back(wave::hexadecimal(part + ".stored", 32,
                                   [this, place]() -> wave::Number { return frame_buffer_.picture()[place]; }));
  return taps;
}

}  // namespace csgsim::pixel_square

namespace csgsim::systemc {

extern const Maker pixel_square_maker{
    .kind = &pixel_square::kind,
    .make = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<pixel_square::PixelSquareMachine>("pixel_square", machine, EvaluatorForm::computed);
    },
    .make_stepped = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<pixel_square::PixelSquareMachine>("pixel_square", machine, EvaluatorForm::stepped);
    }};

}  // namespace csgsim::systemc
