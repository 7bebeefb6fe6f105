// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/pixel_planes.h"
#include "hw/systemc/wave_recorder.h"
#include "hw/wave/vcd_writer.h"
#include "sim/cycle/clocked_engine.h"
#include "tests/lockstep/lockstep.h"
#include "tests/support/test.h"

namespace {

using csgsim::isa::Field;
using csgsim::isa::Instruction;
using csgsim::isa::Opcode;
using csgsim::isa::Program;
using csgsim::isa::Segment;
using csgsim::pixel_planes::PixelPlanes;
using csgsim::systemc::PixelView;
using csgsim::systemc::Retired;
using csgsim::systemc::RunListener;

constexpr csgsim::isa::ArrayShape shape_8x8{8, 8, 32};
constexpr unsigned latency_8x8 = 6;

// The link brings one command per clock and has no latency.
/// Clocks before the first step of a frame's first instruction: the request, the word of the SegmentStart on the link,
/// in the FIFO and in the receiver, and the clock that clears the pixels.
constexpr unsigned lead = 5;
/// Clocks from an answer that causes a jump to the next instruction's first step: the same without clearing.
constexpr unsigned jump = 4;

/// Records the clock edges at which instructions retire, counted from the first edge of the frame.
class Stopwatch final : public RunListener {
 public:
  explicit Stopwatch(const PixelPlanes& machine) : machine_(machine), start_(sc_core::sc_time_stamp()) {}

  void after_instruction(const Retired& retired, const PixelView& /*pixels*/) override {
    edges.push_back(edges_since_start());
    clocks.push_back(retired.clocks);
    enabled.push_back(retired.enabled_pixels);
  }

  /// The frame begins one period after the machine was started.
  [[nodiscard]] double edges_since_start() const { return (sc_core::sc_time_stamp() - start_) / machine_.period() - 1; }

  std::vector<double> edges;
  std::vector<std::uint64_t> clocks;
  std::vector<std::uint64_t> enabled;

 private:
  const PixelPlanes& machine_;
  sc_core::sc_time start_;
};

Segment segment_of(std::vector<Instruction> instructions, std::uint32_t width = 8, std::uint32_t height = 8) {
  return {.region = {0, 0, width, height}, .instructions = std::move(instructions)};
}

/// A Program without fields, so that nothing is scanned out.
Program program_of(std::vector<Segment> segments) {
  Program program;
  program.shape = {1, 1, 8};
  for (const Segment& segment : segments) {
    program.shape.width = std::max(program.shape.width, segment.region.width);
    program.shape.height = std::max(program.shape.height, segment.region.height);
  }
  program.segments = std::move(segments);
  return program;
}

/// The same Program with its colours in that field.
Program shown(Program program, Field colour) {
  program.colour = colour;
  return program;
}

Instruction constant(Field field, std::uint64_t value) {
  return {.opcode = Opcode::set_constant, .fields = {field}, .constant = value};
}

/// t := x + 8 * y
Instruction pixel_number(Field field) {
  return {.opcode = Opcode::load_linear, .fields = {field}, .linear = {.a = 1, .b = 8, .width = 8}};
}

Instruction skip(std::uint64_t count) { return {.opcode = Opcode::skip_if_none, .constant = count}; }

csgsim::machines::Machine machine_8x8() { return csgsim::test::machine_of(shape_8x8, 1); }

/// Draws frames of two kinds, one that takes longer than the display of a row and one that does not, and compares the
/// intervals between frames with those predicted for an endless sequence of the same frame.
void check_sequences(csgsim::pixel_planes::ScanOutPort port, std::uint32_t pixels, std::uint32_t buffers) {
  csgsim::machines::Machine figures = csgsim::test::machine_of({16, 4, 32}, 1);
  auto& own = csgsim::machines::kind_figures<csgsim::pixel_planes::Figures>(figures);
  own.scan_out_port = port;
  own.scan_out_pixels = pixels;
  own.scan_out_buffers = buffers;
  figures.link = {.width = 32, .word_clocks = 1, .fifo_depth = 4, .latency = 2};
  PixelPlanes machine("machine", figures);
  for (const std::size_t count : {1U, 40U}) {
    std::vector<Instruction> instructions(count, {.opcode = Opcode::enable_all});
    instructions.push_back(
        {.opcode = Opcode::load_linear, .fields = {Field{3, 7}}, .linear = {.a = 1, .b = 16, .width = 8}});
    const Program program = shown(program_of({segment_of(instructions, 16, 4)}), {3, 7});
    RunListener nobody;
    const auto alone = machine.run(program, nobody);
    constexpr std::size_t frames = 6;
    const std::vector<Program> programs(frames, program);
    const std::vector<RunListener*> listeners(frames, &nobody);
    const auto reports = machine.run_sequence(programs, listeners);
    const auto worked_out = csgsim::machines::time_frame(program, figures);
    CHECK(alone.clocks == worked_out.clocks);
    CHECK(alone.shown_clocks == worked_out.shown_clocks);
    REQUIRE(reports.size() == frames);
    for (std::size_t i = 0; i < frames; ++i) {
      CAPTURE(i);
      // The refresh words of the previous frame slow all frames after the first if there are two buffers.
      if (i == 0 || buffers == 1) CHECK(reports[i].clocks == worked_out.clocks);
      CHECK(reports[i].picture == alone.picture);
      // The first frame finds an idle scan-out; a few more frames pass until the intervals settle.
      if (i >= (buffers == 1 ? 1 : 3)) CHECK(reports[i].interval_clocks == worked_out.interval_clocks);
    }
    CHECK(alone.picture[17] == 17);
  }
}

}  // namespace

TEST_CASE("an instruction retires `latency` clocks after its last step without a bubble") {
  PixelPlanes machine("machine", machine_8x8());
  const Program program =
      program_of({segment_of({{.opcode = Opcode::enable_all},
                              constant({0, 4}, 5),
                              {.opcode = Opcode::enable_invert},
                              {.opcode = Opcode::edge_negative, .linear = {.c = -1, .width = 9}}})});
  Stopwatch watch(machine);
  const auto report = machine.run(program, watch);
  CHECK(watch.clocks == std::vector<std::uint64_t>{1, 4, 1, 9});
  CHECK(watch.edges == std::vector<double>{lead + latency_8x8 + 1, lead + latency_8x8 + 5, lead + latency_8x8 + 6,
                                           lead + latency_8x8 + 15});
  CHECK(watch.enabled == std::vector<std::uint64_t>{0, 64, 64, 0});
  CHECK(report.clocks == lead + 15 + latency_8x8);
  CHECK(report.latency_clocks == latency_8x8);
  CHECK(watch.edges_since_start() == static_cast<double>(report.clocks));
}

TEST_CASE("a global-OR query takes one clock plus the latency before the controller resumes") {
  PixelPlanes machine("machine", machine_8x8());
  const Program program = program_of({segment_of({{.opcode = Opcode::enable_all},
                                                  {.opcode = Opcode::global_or},
                                                  {.opcode = Opcode::enable_invert},
                                                  {.opcode = Opcode::global_or},
                                                  {.opcode = Opcode::global_or}})});
  Stopwatch watch(machine);
  const auto report = machine.run(program, watch);
  constexpr std::uint64_t query = 1 + latency_8x8;
  CHECK(report.answers == std::vector<bool>{true, false, false});
  CHECK(watch.clocks == std::vector<std::uint64_t>{1, query, 1, query, query});
  CHECK(watch.edges == std::vector<double>{lead + 7, lead + 8, lead + 15, lead + 16, lead + 23});
  CHECK(report.clocks == lead + 2 + 3 * query + latency_8x8);
}

TEST_CASE("a jump takes the clocks of the link for any number of skipped instructions") {
  PixelPlanes machine("machine", machine_8x8());
  constexpr std::uint64_t query = 1 + latency_8x8;
  for (const std::uint64_t count : {1U, 2U, 14U, 15U, 16U, 17U, 33U, 1000U}) {
    CAPTURE(count);
    std::vector<Instruction> instructions{{.opcode = Opcode::enable_all}, {.opcode = Opcode::enable_invert}};
    instructions.push_back(skip(count));
    instructions.insert(instructions.end(), count, {.opcode = Opcode::enable_all});
    instructions.push_back({.opcode = Opcode::global_or});
    instructions.push_back({.opcode = Opcode::enable_all});
    const Program program = program_of({segment_of(instructions)});
    Stopwatch watch(machine);
    const auto report = machine.run(program, watch);
    CHECK(watch.clocks == std::vector<std::uint64_t>{1, 1, query, query, 1});
    CHECK(watch.edges == std::vector<double>{lead + 7, lead + 8, lead + 9, lead + jump + 16, lead + jump + 23});
    CHECK(report.answers == std::vector<bool>{false});
    CHECK(report.skipped == count);
    CHECK(report.clocks == lead + jump + 3 + 2 * query + latency_8x8);
  }
}

TEST_CASE("skip_if_none skips nothing and sends no answer if a pixel is enabled") {
  PixelPlanes machine("machine", machine_8x8());
  const Program program = program_of({segment_of({{.opcode = Opcode::enable_all},
                                                  skip(2),
                                                  {.opcode = Opcode::enable_invert},
                                                  {.opcode = Opcode::enable_invert}})});
  Stopwatch watch(machine);
  const auto report = machine.run(program, watch);
  CHECK(watch.edges == std::vector<double>{lead + 7, lead + 8, lead + 15, lead + 16});
  CHECK(watch.enabled == std::vector<std::uint64_t>{0, 64, 64, 0});
  CHECK(report.answers.empty());
  CHECK(report.skipped == 0);
}

TEST_CASE("a skip can reach the end of its segment or of the Program") {
  struct Segments final : RunListener {
    void after_instruction(const Retired& retired, const PixelView& /*pixels*/) override {
      seen.push_back({retired.segment, retired.index});
    }
    void after_segment(std::uint32_t segment, const PixelView& /*pixels*/) override { ends.push_back(segment); }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;
    std::vector<std::uint32_t> ends;
  };
  PixelPlanes machine("machine", machine_8x8());
  const Instruction all{.opcode = Opcode::enable_all};
  const Program program = program_of(
      {segment_of({skip(2), all, all}), segment_of({}), segment_of({all, skip(1), {.opcode = Opcode::global_or}}, 3, 5),
       segment_of({skip(1), all}), segment_of({skip(20), all, all, all, all, all, all, all, all, all, all,
                                               all,      all, all, all, all, all, all, all, all, all})});
  constexpr std::uint64_t query = 1 + latency_8x8;
  for (int run = 0; run < 2; ++run) {
    Segments listener;
    const auto report = machine.run(program, listener);
    CHECK(listener.seen ==
          std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 0}, {2, 0}, {2, 1}, {2, 2}, {3, 0}, {4, 0}});
    CHECK(listener.ends == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
    CHECK(report.answers == std::vector<bool>{true});
    CHECK(report.skipped == 2 + 1 + 20);
    constexpr std::uint64_t clears = 4;  // in addition to the first
    CHECK(report.clocks == lead + clears + 1 + 5 * query + 3 * jump + latency_8x8);
  }
}

TEST_CASE("a global-OR query takes one clock without tree levels") {
  PixelPlanes machine("machine", csgsim::test::machine_of({1, 1, 8}, 1));
  const Instruction all{.opcode = Opcode::enable_all};
  const Instruction invert{.opcode = Opcode::enable_invert};
  const Program program =
      program_of({segment_of({skip(1), all, skip(1), all, all, skip(1), invert, invert, skip(2), all, all}, 1, 1)});
  Stopwatch watch(machine);
  const auto report = machine.run(program, watch);
  CHECK(watch.enabled == std::vector<std::uint64_t>{0, 0, 0, 1, 1, 0, 1, 1, 1});
  constexpr unsigned after = lead + 2 * jump;
  CHECK(watch.edges == std::vector<double>{lead + 1, lead + jump + 2, after + 3, after + 4, after + 5, after + 6,
                                           after + 7, after + 8, after + 9});
  CHECK(report.skipped == 2);
  CHECK(report.clocks == after + 9);
}

TEST_CASE("a step completes at the end of the same clock without tree levels") {
  PixelPlanes machine("machine", csgsim::test::machine_of({1, 1, 8}, 1));
  const Program program = program_of({segment_of({{.opcode = Opcode::enable_all},
                                                  {.opcode = Opcode::global_or},
                                                  {.opcode = Opcode::global_or},
                                                  {.opcode = Opcode::edge_negative, .linear = {.c = 3, .width = 3}},
                                                  {.opcode = Opcode::global_or}},
                                                 1, 1)});
  Stopwatch watch(machine);
  const auto report = machine.run(program, watch);
  CHECK(report.answers == std::vector<bool>{true, true, false});
  CHECK(watch.edges == std::vector<double>{lead + 1, lead + 2, lead + 3, lead + 6, lead + 7});
  CHECK(report.clocks == lead + 7);
}

TEST_CASE("a Program without instructions takes a clear per segment and the latency") {
  struct Segments final : RunListener {
    void after_segment(std::uint32_t segment, const PixelView& /*pixels*/) override { seen.push_back(segment); }
    std::vector<std::uint32_t> seen;
  } listener;
  PixelPlanes machine("machine", machine_8x8());
  const Program program = program_of({segment_of({}), segment_of({}), segment_of({})});
  CHECK(machine.run(program, listener).clocks == lead + 2 + latency_8x8);
  CHECK(listener.seen == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(machine.run(program, listener).clocks == lead + 2 + latency_8x8);
}

TEST_CASE("scan-out shows each pixel's colour and overlaps latching with shifting") {
  PixelPlanes machine("machine", machine_8x8());
  RunListener nobody;
  const Program program = program_of({segment_of({{.opcode = Opcode::enable_all}, pixel_number({3, 6})})});
  std::vector<std::uint32_t> expected(64);
  for (std::uint32_t i = 0; i < 64; ++i) expected[i] = i;
  const auto narrow = machine.run(shown(program, {3, 6}), nobody);
  CHECK(narrow.picture == expected);
  CHECK(narrow.shown_clocks == narrow.clocks + 6 + 8 * 8);
  const auto wide = machine.run(shown(program, {3, 20}), nobody);
  CHECK(wide.picture == expected);
  CHECK(wide.shown_clocks == wide.clocks + 20 * 8 + 8);
}

TEST_CASE("frame intervals equal the prediction with a separate scan-out port") {
  check_sequences(csgsim::pixel_planes::ScanOutPort::own, 1, 1);
}

TEST_CASE("frame intervals equal the prediction with a shared port") {
  check_sequences(csgsim::pixel_planes::ScanOutPort::shared, 2, 1);
}

TEST_CASE("frame intervals of two buffers equal the prediction with a separate port") {
  check_sequences(csgsim::pixel_planes::ScanOutPort::own, 1, 2);
}

TEST_CASE("frame intervals of two buffers equal the prediction with a shared port") {
  check_sequences(csgsim::pixel_planes::ScanOutPort::shared, 2, 2);
}

TEST_CASE("each of consecutive Programs starts with cleared pixels") {
  PixelPlanes machine("machine", machine_8x8());
  RunListener nobody;
  const Program first =
      shown(program_of({segment_of({{.opcode = Opcode::enable_all}, constant({0, 8}, 0xff)})}), {0, 8});
  const Program second = shown(program_of({segment_of({{.opcode = Opcode::global_or}})}), {0, 8});
  const auto filled = machine.run(first, nobody);
  CHECK(filled.clocks == lead + 9 + latency_8x8);
  CHECK(filled.picture == std::vector<std::uint32_t>(64, 0xff));
  const auto empty = machine.run(second, nobody);
  CHECK(empty.answers == std::vector<bool>{false});
  CHECK(empty.picture == std::vector<std::uint32_t>(64, 0));
}

TEST_CASE("run() rethrows a listener's exception and the machine remains usable") {
  struct Thrower final : RunListener {
    void after_instruction(const Retired&, const PixelView&) override { throw std::runtime_error("enough"); }
  } thrower;
  PixelPlanes machine("machine", machine_8x8());
  const Program program = program_of({segment_of({{.opcode = Opcode::enable_all}, {.opcode = Opcode::global_or}})});
  CHECK_THROWS_WITH_AS(machine.run(program, thrower), "enough", std::runtime_error);
  Stopwatch watch(machine);
  CHECK(machine.run(program, watch).answers == std::vector<bool>{true});
  CHECK(watch.edges == std::vector<double>{lead + latency_8x8 + 1, lead + latency_8x8 + 2});
}

TEST_CASE("a SystemC warning becomes an exception") {
  PixelPlanes machine("machine", machine_8x8());
  CHECK_THROWS_AS(SC_REPORT_WARNING("csgsim", "a test"), sc_core::sc_report);
}

TEST_CASE("rejects a second array in one process but accepts the same array again") {
  const auto first = csgsim::engine::make_cycle_engine(machine_8x8());
  CHECK(first->level() == "cycle");
  CHECK_NOTHROW(csgsim::engine::make_cycle_engine(machine_8x8()));
  CHECK_THROWS_AS(csgsim::engine::make_cycle_engine(csgsim::test::machine_of({16, 8, 32}, 1)), std::logic_error);
  CHECK_THROWS_AS(csgsim::cycle::clocked_hardware(machine_8x8(), csgsim::systemc::EvaluatorForm::stepped),
                  std::logic_error);
}

TEST_CASE("the engine scans out the colour field after the Program") {
  csgsim::isa::Program program;
  program.shape = shape_8x8;
  program.segments = {segment_of({{.opcode = Opcode::enable_all}})};
  const auto engine = csgsim::engine::make_cycle_engine(machine_8x8());
  CHECK(engine->run(program, {}).shown_clocks == lead + 1 + latency_8x8);
  program.colour = {8, 24};
  const auto result = engine->run(program, {});
  CHECK(result.shown_clocks == result.clocks + 24 * 8 + 8);
  CHECK(result.interval_clocks == 24 * 8 + 1 + result.clocks);  // the next frame takes longer than the display of a row
  CHECK(result.clocks == lead + 1 + latency_8x8);
}

/// The VCD dump of a run, with the recorder next to the machine.
class Dump {
 public:
  explicit Dump(const PixelPlanes& machine) : machine_(machine), recorder_("recorder", machine.period()) {}

  void begin(const Program& program, std::vector<csgsim::wave::Window> windows,
             std::vector<csgsim::wave::Pixel> pixels) {
    text.clear();
    csgsim::wave::Request request{
        .windows = std::move(windows), .pixels = std::move(pixels), .tree_levels = {}, .write = {}};
    recorder_.arm(std::make_unique<csgsim::wave::VcdWriter>("top", machine_.taps(program, request), 100'000,
                                                            [this](std::string_view piece) { text += piece; }),
                  request.windows, 0, false);
  }
  bool finish() { return recorder_.finish(); }

  std::string text;

 private:
  const PixelPlanes& machine_;
  csgsim::systemc::WaveRecorder recorder_;
};

TEST_CASE("a wave records a window of a run and nothing outside it") {
  PixelPlanes machine("machine", machine_8x8());
  Dump dump(machine);
  RunListener nobody;
  Program program = program_of(
      {segment_of({{.opcode = Opcode::enable_all}, pixel_number({3, 6}), {.opcode = Opcode::enable_invert}})});
  program.facts->fields = {{"the z", {3, 6}, {}}};
  dump.begin(program, {{5, 12}}, {{3, 2}, {7, 7}});
  machine.run(program, nobody);
  CHECK(dump.finish());
  for (const char* name : {"clock", "text", "purpose", "tree_bit", "carry", "enable", "the_z", "pixel_3_2"}) {
    CAPTURE(name);
    CHECK(dump.text.find(name) != std::string::npos);
  }
  CHECK(dump.text.find("\n#500000\n") == std::string::npos);   // clock 4
  CHECK(dump.text.find("\n#600000\n") != std::string::npos);   // clock 5
  CHECK(dump.text.find("\n#1200000\n") != std::string::npos);  // clock 11
  CHECK(dump.text.find("\n#1350000\n") == std::string::npos);  // middle of clock 12

  dump.begin(program, {{1000, 1001}}, {});
  machine.run(program, nobody);
  CHECK_FALSE(dump.finish());
  CHECK(dump.text.find("\n#") == std::string::npos);
}

TEST_CASE("a wave has unknown values between two windows") {
  PixelPlanes machine("machine", machine_8x8());
  Dump dump(machine);
  RunListener nobody;
  const Program program = program_of({segment_of({{.opcode = Opcode::enable_all}, {.opcode = Opcode::enable_invert}})});
  dump.begin(program, {{1, 3}, {6, 8}}, {});
  machine.run(program, nobody);
  CHECK(dump.finish());
  CHECK(dump.text.find("#400000\n$dumpoff\nx!\n") != std::string::npos);
  CHECK(dump.text.find("#700000\n$dumpon\n1!\n") != std::string::npos);
  CHECK(dump.text.find("#500000\n") == std::string::npos);
}

TEST_CASE("a wave is sampled in the middle of each clock") {
  const sc_core::sc_time period(100, sc_core::SC_NS);
  csgsim::systemc::WaveRecorder recorder("recorder", period);
  std::vector<sc_core::sc_time> sampled;
  const auto tap = csgsim::wave::bit("one", [&sampled] {
    sampled.push_back(sc_core::sc_time_stamp());
    return 1;
  });
  const auto ignored = [](std::string_view) {};
  recorder.arm(std::make_unique<csgsim::wave::VcdWriter>("top", std::vector{tap}, 100'000, ignored), {{2, 4}}, 0,
               false);
  sc_core::sc_start(10 * period);
  CHECK(recorder.finish());
  CHECK(sampled == std::vector{3.5 * period, 4.5 * period});  // clock 0 begins one period after the start
}

TEST_CASE("after a jump the wave shows the next instruction once the host has resumed") {
  PixelPlanes machine("machine", machine_8x8());
  Dump dump(machine);
  RunListener nobody;
  const Instruction all{.opcode = Opcode::enable_all};
  const Program program = program_of({segment_of({skip(2), all, all, {.opcode = Opcode::enable_invert}, all})});
  dump.begin(program, {{4, 20}}, {});
  machine.run(program, nobody);
  CHECK(dump.finish());
  const auto between = [&](const char* from, const char* to) {
    const std::size_t begin = dump.text.find(from);
    return dump.text.substr(begin, dump.text.find(to) - begin);
  };
  // controller.instruction: the query from clock 5 on, its answer at clock 12, the fourth and the fifth instruction
  // at clocks 16 and 17; each clock begins one period later.
  const std::size_t name = dump.text.find(" instruction [31:0]");
  const std::string code = dump.text.substr(dump.text.rfind(' ', name - 1) + 1, 1) + "\n";
  CHECK(between("\n#600000\n", "\n#1700000\n").find("\nb11 " + code) == std::string::npos);
  CHECK(between("\n#1700000\n", "\n#1800000\n").find("\nb11 " + code) != std::string::npos);
  CHECK(between("\n#1800000\n", "\n#1900000\n").find("\nb100 " + code) != std::string::npos);
}

TEST_CASE("a wave's window ends with the Program and nonexistent pixels are rejected") {
  PixelPlanes machine("machine", machine_8x8());
  Dump dump(machine);
  Stopwatch watch(machine);
  Program program = program_of({segment_of({{.opcode = Opcode::enable_all}, constant({0, 4}, 5)})});
  program.facts->fields = {{"k", {0, 4}, {}}};
  dump.begin(program, {{0, 1000}}, {{0, 0}});
  machine.run(program, watch);
  CHECK(dump.finish());
  CHECK(dump.text.find("b101 ") != std::string::npos);
  using csgsim::wave::TreeLevel;
  CHECK_THROWS_AS((void)machine.taps(program, {{}, {{8, 0}}, {}, {}}), csgsim::InputError);
  CHECK_THROWS_AS((void)machine.taps(program, {{}, {{0, 0}}, {{TreeLevel::Axis::x, 4}}, {}}), csgsim::InputError);
  CHECK_NOTHROW((void)machine.taps(program, {{}, {{0, 0}}, {{TreeLevel::Axis::x, 3}}, {}}));
}

TEST_CASE("a wave continues after drawing while the picture is shown") {
  PixelPlanes machine("machine", machine_8x8());
  Dump dump(machine);
  RunListener nobody;
  const Program program =
      shown(program_of({segment_of({{.opcode = Opcode::enable_all}, pixel_number({3, 6})})}), {3, 6});
  dump.begin(program, {{0, 1000}}, {});
  const auto report = machine.run(program, nobody);
  CHECK(dump.finish());
  for (const char* name : {"picture_finished", "picture_latched", "refreshes_asked", "video"}) {
    CAPTURE(name);
    CHECK(dump.text.find(name) != std::string::npos);
  }
  CHECK(dump.text.find("b111110 ") != std::string::npos);  // the colour of the second-last pixel, 62
  CHECK(dump.text.find("\n#" + std::to_string((report.shown_clocks - 1) * 100'000)) != std::string::npos);
  CHECK(dump.text.find("\n#" + std::to_string((report.shown_clocks + 3) * 100'000)) == std::string::npos);
}
