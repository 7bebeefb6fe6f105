// rtl_NAME random SEQUENCES INSTRUCTIONS [KEY=NUMBER...]
//   Runs SEQUENCES sequences of random Programs, with at most INSTRUCTIONS per segment, on the machine in SystemC and
//   on the Verilog, in lockstep. latency= and word= are clocks of the link. RC_PARAMS overrides seed and number.
// rtl_NAME models MODEL...
//   Draws test models on both.
// rtl_NAME faults SEQUENCES INSTRUCTIONS NUMBER...
//   Every planted fault except those NUMBERs must be detected within SEQUENCES random sequences.
// rtl_NAME host SEED LATENCY WORD_CLOCKS
//   Writes the input files of host_test.v for a random Program that sends queries, skips and shows a picture; prints
//   its parameters. The clocks are those of the SystemC machine.
// rtl_NAME speed PRIMITIVES
//   Measures both on the benchmarks' typical mix, per pixel and clock; the fastest of some runs.

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/typical_mix.h"
#include "tests/rtl/commands.h"
#include "tests/rtl/lockstep.h"
#include "tests/rtl/random_frames.h"

namespace csgsim::rtl {

namespace {

constexpr std::uint8_t planted_faults = 27;  ///< number of faults in hw/rtl/faults.vh

/// The machine with parameters of the host: latency= and word= are clocks of the link.
machines::Machine machine_with(const Words& words) {
  machines::Machine machine = machine_of_parameters();
  set_figures(words, {{"latency", &machine.link.latency}, {"word", &machine.link.word_clocks}});
  return machine;
}

testing::Setup setup_of(const machines::Machine& machine) {
  testing::Setup setup;
  setup.sampling.width = machine.array.width;
  setup.sampling.height = machine.array.height;
  setup.memory_bits = machine.array.memory_bits;
  return setup;
}

/// Runs a frame on the Verilog alone. Returns its clocks.
std::uint64_t run_verilog(Machine& machine, const link::FrameWords& words, const machines::Link& link) {
  HostLink host(link);
  host.load(words);
  Inputs inputs{.frame = true};
  do {
    host.drive(machine.outputs(), inputs);
    machine.edge_for_host(inputs);
    inputs = {};
  } while (!machine.outputs().done);
  return machine.outputs().clocks;
}

/// Nanoseconds of processor time per pixel and clock; the fastest of some runs.
template <class Run>
double pixel_clock_ns(const char* what, const isa::ArrayShape& shape, Run run) {
  constexpr int runs = 3;
  double best = std::numeric_limits<double>::infinity();
  std::uint64_t clocks = 0;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t begin = std::clock();
    clocks = run();
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  const double rate = static_cast<double>(clocks) / best;
  const double each = 1e9 / rate / shape.width / shape.height;
  fmt::print("{:<20} {:>9} clocks {:>12.0f} clocks/s {:>10.4f} ns a pixel and clock\n", what, clocks, rate, each);
  return each;
}

int speed(const Words& words) {
  const machines::Machine figures = machine_of_parameters();
  const auto primitives = static_cast<unsigned>(std::stoul(words.at(1)));
  const isa::Program program = bench::typical_mix(figures.array, primitives);
  const link::FrameWords frame = link::frame_words(program, figures.link.width);
  Machine verilog;
  pixel_planes::PixelPlanes machine("machine", figures);
  systemc::RunListener nobody;
  const double by_verilog =
      pixel_clock_ns("Verilator", figures.array, [&] { return run_verilog(verilog, frame, figures.link); });
  const double by_machine =
      pixel_clock_ns("clocked machine", figures.array, [&] { return machine.run(program, nobody).clocks; });
  fmt::print("the clocked machine is {:.0f} x as fast\n", by_verilog / by_machine);
  return 0;
}

/// Whether the Program sends queries, skips, and shows a picture.
bool uses_every_feature(const isa::Program& program, const systemc::RunReport& report) {
  return !report.answers.empty() && report.skipped > 0 && !report.picture.empty() && program.segments.size() == 1;
}

int host(const Words& words) {
  machines::Machine figures = machine_of_parameters();
  figures.link.latency = static_cast<std::uint32_t>(std::stoul(words.at(2)));
  figures.link.word_clocks = static_cast<std::uint32_t>(std::stoul(words.at(3)));
  pixel_planes::PixelPlanes machine("machine", figures);
  systemc::RunListener nobody;
  constexpr int size = 50;
  constexpr std::size_t instructions = 40;
  const auto any_frames = arbitrary_frames(figures, instructions);
  for (std::uint64_t seed = std::stoul(words.at(1));; ++seed) {
    const isa::Program program = any_frames(rc::Random(seed), size).value().front();
    const systemc::RunReport report = machine.run(program, nobody);
    if (!uses_every_feature(program, report)) continue;
    const link::FrameWords frame = link::frame_words(program, figures.link.width);
    std::ofstream all_words("words.hex");
    for (const isa::LinkWord& word : frame.words) all_words << fmt::format("{:08x}\n", word.number(0, 32));
    std::ofstream begins("begins.hex");
    for (const std::size_t begin : frame.begins) begins << fmt::format("{:x}\n", begin);
    std::ofstream answers("answers.hex");
    for (const bool answer : report.answers) answers << (answer ? "1\n" : "0\n");
    answers << "0\n";
    std::ofstream picture("picture.hex");
    for (const std::uint32_t colour : report.picture) picture << fmt::format("{:x}\n", colour);
    fmt::print("WORDS={} INSTRUCTIONS={} ANSWERS={} CLOCKS={} LATENCY={} WORD_CLOCKS={}\n", frame.words.size(),
               frame.begins.size() - 1, report.answers.size(), report.clocks, figures.link.latency,
               figures.link.word_clocks);
    return 0;
  }
}

int run(const Words& words) {
  if (words.at(0) == "host") return host(words);
  if (words.at(0) == "speed") return speed(words);
  const machines::Machine machine = machine_of_parameters();
  if (words.at(0) == "random") return random_frames<Lockstep>(machine_with(words), arbitrary_frames, words);
  if (words.at(0) == "models") return models<Lockstep>(machine, setup_of(machine), words);
  if (words.at(0) == "faults") return faults<Lockstep>(machine, arbitrary_frames, planted_faults, words);
  throw std::invalid_argument("unknown test: " + words.at(0));
}

}  // namespace

}  // namespace csgsim::rtl

int main(int count, char** words) { return csgsim::rtl::exit_code(count, words, csgsim::rtl::run); }
