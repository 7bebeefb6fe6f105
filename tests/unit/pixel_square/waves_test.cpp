// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/division/encoding.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"
#include "hw/pixel_square/pixel_square.h"
#include "hw/pixel_square/taps.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/kernel.h"
#include "hw/wave/tap.h"
#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"
#include "tests/unit/pixel_square/bench.h"

// Tests of the waves of the whole machine: each clock shows the state after the edge that starts it.

using namespace csgsim;
using namespace isa;

namespace {

/// Samples the taps of a machine in the middle of each clock, as waves do.
class Sampler final : public sc_core::sc_module {
 public:
  Sampler(sc_core::sc_module_name name, const machines::Machine& machine)
      : sc_core::sc_module(name), period_(systemc::period_of(machine)) {
    SC_HAS_PROCESS(Sampler);
    SC_METHOD(look);
  }

  void begin(std::vector<wave::Tap> taps) { taps_ = std::move(taps); }

  /// The values of each tap, clock by clock; `-` while a tap is undefined.
  std::map<std::string, std::vector<std::string>> seen;

 private:
  static std::string shown_by(const wave::Tap& tap) {
    if (tap.show == wave::Show::text) return tap.text().empty() ? "-" : tap.text();
    const wave::Number number = tap.number();
    return number ? std::to_string(*number) : "-";
  }

  void look() {
    if (sc_core::sc_time_stamp() == sc_core::SC_ZERO_TIME) return next_trigger(period_ + period_ / 2);
    for (const wave::Tap& tap : taps_) seen[tap.name].push_back(shown_by(tap));
    next_trigger(period_);
  }

  const sc_core::sc_time period_;
  std::vector<wave::Tap> taps_;
};

struct Board {
  Board(const machines::Machine& described, isa::Program drawn, std::vector<wave::Pixel> pixels)
      : machine(described),
        program(std::move(drawn)),
        hardware(std::make_unique<pixel_square::PixelSquareMachine>("pixel_square", machine,
                                                                    systemc::EvaluatorForm::computed)),
        sampler("sampler", machine) {
    wave::Request request;
    request.pixels = std::move(pixels);
    taps = hardware->taps(program, request);
    sampler.begin(taps);
  }

  std::uint64_t run() {
    systemc::RunListener no_listener;
    return hardware->run(program, no_listener).clocks;
  }

  /// Returns a tap's values in the first clocks as runs with their lengths: `2 idle, 6 drawing`.
  [[nodiscard]] std::string shown(const std::string& name, std::size_t clocks = ~std::size_t{0}) const {
    const std::vector<std::string>& seen = sampler.seen.at(name);
    const std::size_t end = std::min(clocks, seen.size());
    std::string text;
    for (std::size_t i = 0; i < end;) {
      std::size_t next = i;
      while (next < end && seen[next] == seen[i]) ++next;
      text += (text.empty() ? "" : ", ") + std::to_string(next - i) + " " + seen[i];
      i = next;
    }
    return text;
  }

  /// Returns the successive values without their lengths.
  [[nodiscard]] std::string changes(const std::string& name) const {
    std::vector<std::string> all = sampler.seen.at(name);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::string text;
    for (const std::string& one : all) text += (text.empty() ? "" : " ") + one;
    return text;
  }

  [[nodiscard]] const wave::Tap& tap(const std::string& name) const {
    const auto found = std::ranges::find(taps, name, &wave::Tap::name);
    REQUIRE(found != taps.end());
    return *found;
  }

  /// Names of the machine's taps except those inside renderers and pixels.
  [[nodiscard]] std::vector<std::string> outer_names() const {
    std::vector<std::string> names;
    for (const wave::Tap& one : taps)
      if (!one.name.starts_with("renderer_") && !one.name.starts_with("pixel_")) names.push_back(one.name);
    return names;
  }

  machines::Machine machine;
  isa::Program program;
  std::unique_ptr<systemc::ClockedMachine> hardware;
  Sampler sampler;
  std::vector<wave::Tap> taps;
};

/// Colours of x + 2y in a square.
constexpr Instruction ramp{
    .opcode = Opcode::load_linear, .fields = {isa::Field{0, 3}}, .linear = {.a = 1, .b = 2, .c = 0, .width = 4}};

/// A picture of 4 x 2: the left square is drawn, the right one is empty.
isa::Program half_drawn() {
  isa::Program program;
  program.shape = {4, 2, 8};
  program.colour = {0, 3};
  program.background = 6;
  program.segments = {{.region = {0, 0, 2, 2}, .instructions = {{.opcode = Opcode::enable_all}, ramp}},
                      {.region = {2, 0, 2, 2}, .instructions = {}}};
  return program;
}

/// A link that carries every command in one word.
constexpr machines::Link wide{.width = 256, .word_clocks = 1, .fifo_depth = 8, .latency = 2};

constexpr pixel_square::Figures two_renderers{.renderers = 2, .buffers = 2, .port_bits = 32, .port_fifo_depth = 8};

machines::Machine dividing_machine(std::uint32_t dividers) {
  machines::Machine machine = testing::square_machine({.buffers = 2,
                                                       .port_bits = 32,
                                                       .port_fifo_depth = 8,
                                                       .divider = pixel_square::DividerKind::corners,
                                                       .dividers = dividers,
                                                       .model_bits = 10'000,
                                                       .record_bits = 80,
                                                       .halfspaces = 100,
                                                       .nodes = 100,
                                                       .store_words = 100,
                                                       .halfspace_clocks = 4,
                                                       .node_clocks = 9,
                                                       .linear_clocks = 0},
                                                      wide);
  machine.array = {8, 16, 16};
  machine.picture = {16, 16};
  return machine;
}

/// The slab in the left half of the picture, as a divider computes it; the right half is empty.
isa::Program slab_program(const machines::Machine& machine) {
  testing::ModelDivider divider(testing::one_slab());
  isa::Program program;
  program.shape = {16, 16, 16};
  program.colour = {8, 3};
  program.background = divider.model.background;
  for (const isa::LinkWord& byte : division::to_link(division::encode(divider.model), 8))
    program.display_model.push_back(static_cast<std::uint8_t>(byte.number(0, 8)));
  for (const isa::Region& region : machines::regions(machine))
    program.segments.push_back({.region = region, .instructions = divider.divide(region).instructions});
  return program;
}

void check_number(const Board& board, const std::string& name, unsigned width) {
  CAPTURE(name);
  CHECK(board.tap(name).show == wave::Show::number);
  CHECK(board.tap(name).width == width);
}

}  // namespace

TEST_CASE("waves of a host-divided machine show the host's words and the parts they pass") {
  machines::Machine machine = testing::square_machine(two_renderers, wide);
  machine.clear_clocks = 3;
  Board board(machine, half_drawn(), {{1, 1}, {2, 0}});
  CHECK(board.outer_names() == std::vector<std::string>{"host.state", "host.square", "host.renderer", "clears.fill",
                                                        "frame_buffer.state", "frame_buffer.port",
                                                        "frame_buffer.square", "frame_buffer.squares",
                                                        "frame_buffer.refreshed_row"});
  // Clocks 0 and 1 are the link's latency. Four words of commands leave with the edges that start clocks 2 to 5, two of
  // header with the next two; each is taken a clock later. The third word of background is stored with clock 9.
  constexpr std::uint64_t clocks = 19;
  CHECK(board.run() == clocks);
  CHECK(board.shown("host.state") == "2 waiting_for_host, 6 sending, 10 done");
  CHECK(board.shown("host.square") == "6 0,0, 2 2,0, 10 -");
  CHECK(board.shown("host.renderer") == "2 -, 4 0, 12 -");
  CHECK(board.shown("clears.fill") == "6 0, 2 1, 10 0");
  // Control words of clocks 3, 4 and 5 clear the memory, and the receiver can take instructions with the last of these.
  // The first instruction is issued with clock 6, the other with 7 to 10, and the end with 11; the end arrives two
  // levels later, at the edge that starts clock 14. The receiver holds a command until it executes.
  CHECK(board.shown("renderer_0.link_fill") == "2 0, 3 1, 2 2, 1 1, 10 0");
  CHECK(board.shown("renderer_0.state") == "3 idle, 2 clearing, 6 drawing, 3 draining, 4 idle");
  CHECK(board.shown("renderer_0.square") == "3 -, 11 0,0, 4 -");
  CHECK(board.shown("renderer_0.controller.instruction") == "6 -, 1 0, 4 1, 7 -");
  CHECK(board.shown("renderer_0.pixels.instruction") == "8 -, 1 0, 4 1, 5 -");
  // Two words of header and one of colours leave from the next clock on; the last is stored when the frame ends.
  CHECK(board.shown("renderer_0.port_fill") == "15 0, 3 1");
  for (const std::string name : {".link_fill", ".port_fill"}) CHECK(board.shown("renderer_1" + name) == "18 0");
  CHECK(board.shown("renderer_1.state") == "18 idle");
  CHECK(board.shown("renderer_1.square") == "18 -");
  // The third port carries the clears. The square is unknown at the first word of a header.
  CHECK(board.shown("frame_buffer.state") == "7 -, 3 working, 6 -, 2 working");
  CHECK(board.shown("frame_buffer.port") == "7 -, 3 2, 6 -, 2 0");
  CHECK(board.shown("frame_buffer.square") == "8 -, 2 2,0, 7 -, 1 0,0");
  CHECK(board.shown("frame_buffer.squares") == "9 0, 9 1");
  CHECK(board.shown("frame_buffer.refreshed_row") == "18 -");
  // A pixel is shown from the clock in which its memory has been cleared: three clocks and two levels later.
  CHECK(board.shown("pixel_1_1.renderer") == "8 -, 10 0");
  CHECK(board.shown("pixel_1_1.instruction") == "8 -, 1 0, 4 1, 5 -");
  CHECK(board.shown("pixel_1_1.enable") == "8 -, 1 0, 9 1");
  CHECK(board.shown("pixel_1_1.stored") == "18 0");
  CHECK(board.shown("pixel_2_0.renderer") == "18 -");
  CHECK(board.shown("pixel_2_0.stored") == "9 0, 9 6");
  CHECK(board.tap("pixel_1_1.stored").show == wave::Show::hexadecimal);
  CHECK(board.tap("pixel_1_1.stored").width == 32);
  for (const std::string name : {"host.renderer", "frame_buffer.port", "pixel_1_1.renderer"})
    check_number(board, name, 8);
  for (const std::string name : {"clears.fill", "renderer_0.link_fill", "renderer_1.port_fill", "frame_buffer.squares",
                                 "frame_buffer.refreshed_row"})
    check_number(board, name, 32);

  // A second frame repeats the first over its picture.
  const auto first = board.sampler.seen;
  board.sampler.seen.clear();
  CHECK(board.run() == clocks);
  for (const auto& one : first) {
    const std::string& name = one.first;
    if (name.starts_with("pixel_") || name.find(".pixels.") != std::string::npos) continue;
    CAPTURE(name);
    std::vector<std::string> again = board.sampler.seen.at(name);
    again.erase(again.begin());  // the clock between the frames
    CHECK(again == one.second);
  }
  // The clock before it shows no values of the first frame remain.
  CHECK(board.shown("host.state") == "1 -, 2 waiting_for_host, 6 sending, 10 done");
  CHECK(board.shown("frame_buffer.state") == "8 -, 3 working, 6 -, 2 working");
  CHECK(board.shown("frame_buffer.squares") == "10 0, 9 1");
  CHECK(board.shown("pixel_1_1.stored") == "19 3");
  CHECK(board.shown("pixel_2_0.stored") == "19 6");
  CHECK(board.shown("pixel_1_1.renderer") == "9 -, 10 0");
}

TEST_CASE("a pixel's wave shows the renderer that draws its square") {
  isa::Program program = half_drawn();
  for (isa::Segment& segment : program.segments) segment.instructions = {{.opcode = Opcode::enable_all}};
  machines::Link link = wide;
  link.latency = 0;
  Board board(testing::square_machine(two_renderers, link), program, {{0, 0}, {3, 1}});
  board.run();
  // Words of the first square leave with clocks 0, 1, 2: its instruction is issued with clock 2 and reaches the pixels
  // two levels later. The second square follows three clocks later, in the other renderer.
  CHECK(board.shown("host.renderer", 7) == "3 0, 3 1, 1 -");
  CHECK(board.shown("renderer_0.controller.instruction", 9) == "2 -, 1 0, 6 -");
  CHECK(board.shown("renderer_1.controller.instruction", 9) == "5 -, 1 1, 3 -");
  CHECK(board.shown("renderer_0.controller.text", 9) == "2 -, 1 enable_all, 6 -");
  CHECK(board.shown("renderer_1.pixels.instruction", 9) == "7 -, 1 1, 1 -");
  CHECK(board.shown("pixel_0_0.instruction", 9) == "4 -, 1 0, 4 -");
  CHECK(board.shown("pixel_3_1.instruction", 9) == "7 -, 1 1, 1 -");
  CHECK(board.shown("pixel_0_0.text", 9) == "4 -, 1 enable_all, 4 -");
  CHECK(board.shown("pixel_3_1.text", 9) == "7 -, 1 enable_all, 1 -");
  CHECK(board.shown("pixel_0_0.renderer", 9) == "4 -, 5 0");
  CHECK(board.shown("pixel_3_1.renderer", 9) == "7 -, 2 1");
  CHECK(board.shown("pixel_3_1.enable", 9) == "7 -, 1 0, 1 1");
  CHECK(board.shown("renderer_1.square", 7) == "4 -, 3 2,0");
}

TEST_CASE("waves of a machine with a ring show processors and waiting words and transfers") {
  pixel_square::Figures figures = two_renderers;
  figures.divider = pixel_square::DividerKind::processors;
  figures.processors = 2;
  figures.ring_bits = 32;
  figures.ring_word_clocks = 2;
  Board board(testing::square_machine(figures, wide), half_drawn(), {{1, 1}});
  CHECK(board.outer_names() ==
        std::vector<std::string>{"processor_0.state", "processor_0.square", "processor_0.renderer",
                                 "processor_0.ring_fill", "processor_1.state", "processor_1.square",
                                 "processor_1.renderer", "processor_1.ring_fill", "ring.state", "ring.words",
                                 "frame_buffer.state", "frame_buffer.port", "frame_buffer.square",
                                 "frame_buffer.squares", "frame_buffer.refreshed_row"});
  board.run();
  // SegmentStart has three words, the linear instruction of 6 + 18 + 12 + 12 bits has two, each other command one: the
  // first processor sends seven with the edges that start clocks 2 to 8, the second a header of two. The ring carries
  // words with clocks 3, 5, ..., 15; a processor is free in the clock after its last word is carried.
  CHECK(board.shown("processor_0.state", 17) == "2 waiting_for_host, 7 sending, 7 waiting_for_ring, 1 done");
  CHECK(board.shown("processor_0.square", 17) == "2 -, 14 0,0, 1 -");
  CHECK(board.shown("processor_0.renderer", 17) == "2 -, 14 0, 1 -");
  CHECK(board.shown("processor_0.ring_fill", 17) == "2 0, 2 1, 2 2, 2 3, 1 4, 2 3, 2 2, 2 1, 2 0");
  CHECK(board.shown("processor_1.state", 17) == "2 waiting_for_host, 2 sending, 2 waiting_for_ring, 11 done");
  CHECK(board.shown("processor_1.square", 17) == "2 -, 4 2,0, 11 -");
  CHECK(board.shown("processor_1.renderer", 17) == "17 -");
  CHECK(board.shown("processor_1.ring_fill", 17) == "2 0, 3 1, 12 0");
  CHECK(board.shown("ring.words", 17) == "3 0, 2 2, 2 4, 2 5, 2 6, 2 7, 2 8, 2 9");
  // During the last of a transfer's two clocks the next word is carried; a pause follows the seventh.
  CHECK(board.shown("ring.state", 18) == "3 -, 14 working, 1 -");
  // The processors' ports follow those of the two renderers.
  CHECK(board.shown("frame_buffer.port", 10) == "4 -, 1 3, 1 -, 2 3, 2 -");
  CHECK(board.shown("frame_buffer.square", 10) == "6 -, 2 2,0, 2 -");
  CHECK(board.shown("frame_buffer.squares", 10) == "7 0, 3 1");
  for (const std::string name : {"processor_0.renderer", "processor_1.renderer"}) check_number(board, name, 8);
  for (const std::string name : {"processor_0.ring_fill", "processor_1.ring_fill", "ring.words"})
    check_number(board, name, 32);
}

TEST_CASE("waves of a dividing machine show model progress and the store and the sender") {
  const machines::Machine machine = dividing_machine(1);
  Board board(machine, slab_program(machine), {{15, 15}});
  CHECK(board.outer_names() ==
        std::vector<std::string>{"host.state", "host.words", "model.fill", "divider.state", "divider.square",
                                 "divider.store_fill", "sender.state", "sender.square", "sender.renderer",
                                 "clears.fill", "frame_buffer.state", "frame_buffer.port", "frame_buffer.square",
                                 "frame_buffer.squares", "frame_buffer.refreshed_row"});
  board.run();
  REQUIRE(board.program.display_model.size() > 32);
  REQUIRE(board.program.display_model.size() <= 64);
  // Two words of 256 bits; the last is taken with the edge that starts clock 4. The tree has one node, which takes nine
  // clocks to test.
  CHECK(board.shown("host.state", 9) == "2 waiting_for_host, 2 sending, 5 done");
  CHECK(board.shown("host.words", 9) == "2 0, 1 1, 6 2");
  CHECK(board.shown("model.fill", 9) == "2 0, 2 1, 5 0");
  CHECK(board.shown("divider.state", 14) == "4 receiving, 10 testing");
  CHECK(board.shown("divider.square", 14) == "13 -, 1 0,0");
  CHECK(board.changes("divider.state") == "receiving testing writing testing done");
  CHECK(board.changes("divider.square") == "- 0,0 8,0 -");
  CHECK(board.changes("sender.state") == "waiting_for_divider sending done");
  CHECK(board.changes("sender.square") == "0,0 8,0 -");
  CHECK(board.changes("sender.renderer") == "- 0 -");
  CHECK(board.changes("clears.fill") == "0 1 0");
  // SegmentStart, the instructions and SegmentEnd of the first square fill the store word by word and leave it
  // likewise. The empty second square is one word, which arrives while another leaves.
  const std::size_t words = board.program.segments[0].instructions.size() + 2;
  std::string fill;
  for (std::size_t i = 0; i < words; ++i) fill += std::to_string(i) + " ";
  for (std::size_t i = words; i > 0; --i) fill += std::to_string(i) + " ";
  fill += "0";
  CHECK(board.changes("divider.store_fill") == fill);
  CHECK(board.changes("pixel_15_15.stored") == "0 6");
  for (const std::string name : {"host.words", "model.fill", "divider.store_fill"}) check_number(board, name, 32);
  check_number(board, "sender.renderer", 8);
}

TEST_CASE("waves show each of several dividers by its number") {
  const machines::Machine machine = dividing_machine(2);
  Board board(machine, slab_program(machine), {});
  board.run();
  CHECK(board.changes("divider_0.square") == "- 0,0 -");
  CHECK(board.changes("divider_1.square") == "- 8,0 -");
  CHECK(board.changes("divider_1.store_fill") == "0 1 0");
}

TEST_CASE("a dividing machine rejects a Program that differs from its own computation") {
  const machines::Machine machine = dividing_machine(1);
  Board board(machine, slab_program(machine), {});
  board.program.segments[0].instructions.pop_back();
  CHECK_THROWS_AS(board.run(), InputError);
  CHECK_THROWS_AS(SC_REPORT_WARNING("test", "a warning"), sc_core::sc_report);
}
