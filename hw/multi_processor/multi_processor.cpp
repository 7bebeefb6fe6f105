#include "hw/multi_processor/multi_processor.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "hw/division/division_check.h"
#include "hw/multi_processor/kind.h"
#include "hw/multi_processor/taps.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/maker.h"
#include "hw/wave/segments.h"

namespace csgsim::multi_processor {

namespace {

std::uint32_t nodes_of(const machines::Machine& machine) { return machine.array.width * machine.array.height; }

}  // namespace

MultiProcessor::MultiProcessor(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      machine_(machine),
      time_(machine),
      requests_("requests", nodes_of(machine) + 1),
      arrivals_("arrivals", nodes_of(machine)),
      host_("host", machine),
      display_("display_processor", machine),
      bus_("control_bus", machine, nodes_of(machine) + 1),
      barrier_("barrier", machine),
      nodes_("nodes", nodes_of(machine),
             [&](const char* node, std::size_t number) {
               return new Node(node, machine, static_cast<std::uint32_t>(number));
             }),
      room_("room_line", nodes_of(machine)),
      watch_("stage_watch", machine),
      collector_("collector", machine, names_) {
  SC_HAS_PROCESS(MultiProcessor);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  bind_masters();
  bus_.requests(requests_);
  bus_.lines(lines_);

  barrier_.arrivals(arrivals_);
  barrier_.gathered(gathered_);
  barrier_.released(released_);

  watch_.bus(lines_);
  watch_.gathered(gathered_);
  watch_.released(released_);
  collector_.retirement(retirement_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << frames_;
}

void MultiProcessor::bind_masters() {
  host_.word(host_word_);
  display_.host(host_word_);
  display_.bus(lines_);
  display_.request(requests_[display_master]);
  display_.released(released_);
  display_.frames(frames_);

  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].bus(lines_);
    nodes_[i].request(requests_[master_of(i)]);
    nodes_[i].arrival(arrivals_[i]);
    nodes_[i].released(released_);
    nodes_[i].room(room_);
    nodes_[i].collector(collector_);
  }
}

/// Returns control to the caller of run() after all events of this clock.
void MultiProcessor::on_done() { sc_core::sc_pause(); }

systemc::RunReport MultiProcessor::run(const isa::Program& program, systemc::RunListener& listener) {
  systemc::elaborate();
  division::check_division(program);
  const std::uint64_t start_clock = time_.now();
  const std::uint64_t before = frames_.read();
  begin(program, listener);
  systemc::run();
  retirement_.rethrow();
  if (frames_.read() == before && !systemc::is_stopped())
    throw std::logic_error("the multi-processor is deadlocked in the middle of a frame");
  return {.clocks = time_.now() - start_clock,
          .answers = {},
          .account = account(frame_counts(), machine_.array),
          .picture = picture_of(program)};
}

void MultiProcessor::begin(const isa::Program& program, systemc::RunListener& listener) {
  retirement_.begin(listener);
  names_.begin(program.segments);
  bus_.begin();
  watch_.begin();
  std::for_each(nodes_.begin(), nodes_.end(), [](Node& node) { node.begin(); });
  host_.begin(program.display_model);
  display_.begin();
}

FrameAccount MultiProcessor::frame_counts() const {
  FrameAccount counted = display_.frame_counts();
  watch_.store_stages(counted.stages);
  counted.bus = bus_.account();
  std::for_each(nodes_.begin(), nodes_.end(), [&](const Node& node) { node.add_counts(counted); });
  return counted;
}

/// Returns no pixels if the run was stopped before the model reached the nodes.
std::vector<std::uint32_t> MultiProcessor::picture_of(const isa::Program& program) const {
  if (program.colour.width == 0 || !nodes_[0].has_image()) return {};
  std::vector<std::uint32_t> picture;
  for (std::uint32_t y = 0; y < program.shape.height; ++y) {
    for (std::uint32_t x = 0; x < program.shape.width; ++x) {
      const std::size_t row = y % machine_.array.height;
      picture.push_back(nodes_[row * machine_.array.width + x % machine_.array.width].colour(x, y));
    }
  }
  return picture;
}

std::vector<wave::Tap> MultiProcessor::taps(const isa::Program& program, const wave::Request& request) const {
  wave::check_no_tree_levels(request);
  std::vector<wave::Tap> taps{
      wave::number("host.words", 32, [this] { return wave::Number(host_word_.read().number); })};
  const auto add = [&](std::vector<wave::Tap> more) { wave::add(std::move(more), taps); };
  add(display_taps(display_));
  add(bus_taps(bus_, lines_, machine_.array));
  taps.push_back(wave::number("barrier.gathered", 32, [this] { return wave::Number(gathered_.read()); }));
  taps.push_back(wave::number("barrier.released", 32, [this] { return wave::Number(released_.read()); }));
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) add(node_taps(node_name(i, machine_.array), nodes_[i]));
  for (const wave::Pixel pixel : request.pixels) {
    const std::size_t row = pixel.y % machine_.array.height;
    add(pixel_taps(pixel, nodes_[row * machine_.array.width + pixel.x % machine_.array.width], program, machine_));
  }
  return taps;
}

}  // namespace csgsim::multi_processor

namespace csgsim::systemc {

extern const Maker multi_processor_maker{
    .kind = &multi_processor::kind, .make = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
      return std::make_unique<multi_processor::MultiProcessor>("multi_processor", machine);
    }};

}  // namespace csgsim::systemc
