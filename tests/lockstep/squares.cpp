// lockstep_squares KEY=NUMBER...: draws random Programs, or with divider=1 random models, on the clocked pixel-square
// machine with those figures and
// holds them against the reference's bits, the functional engine's picture, clocks and account. One machine a process,
// as SystemC elaborates once. RC_PARAMS overrides the seed and the number of Programs.

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "hw/isa/validate.h"
#include "hw/machines/regions.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "tests/lockstep/divided_program.h"
#include "tests/lockstep/lockstep.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

struct Settings {
  machines::Machine machine = machines::blank(pixel_square::kind);
  unsigned programs = 40;
  unsigned instructions = 12;  ///< of a square at most
};

Settings read_settings(int count, char** arguments) {
  Settings settings;
  machines::Machine& machine = settings.machine;
  machine.name = "squares";
  machine.array = {8, 8, 40};
  machine.picture = {20, 20};
  machine.clock_hz = 10'000'000;
  machine.link = {.width = 32, .word_clocks = 1, .fifo_depth = 64, .latency = 0};
  auto& figures = machines::own<pixel_square::Figures>(machine);
  figures.model_bits = 10'000'000;
  figures.halfspaces = 1'000'000;
  figures.nodes = 1'000'000;
  figures.store_words = 10'000'000;
  std::uint32_t order = 0;
  std::uint32_t divider = 0;
  const std::map<std::string, std::uint32_t*> known{{"picture_width", &machine.picture.width},
                                                    {"picture_height", &machine.picture.height},
                                                    {"width", &machine.array.width},
                                                    {"height", &machine.array.height},
                                                    {"bits", &machine.array.memory_bits},
                                                    {"reads", &machine.memory_reads},
                                                    {"clear", &machine.clear_clocks},
                                                    {"link_width", &machine.link.width},
                                                    {"word", &machine.link.word_clocks},
                                                    {"depth", &machine.link.fifo_depth},
                                                    {"latency", &machine.link.latency},
                                                    {"port_depth", &figures.port_fifo_depth},
                                                    {"move", &figures.move_bits},
                                                    {"renderers", &figures.renderers},
                                                    {"buffers", &figures.buffers},
                                                    {"port", &figures.port_bits},
                                                    {"order", &order},
                                                    {"divider", &divider},
                                                    {"levels", &figures.levels},
                                                    {"group", &figures.group_side},
                                                    {"list", &figures.list_entries},
                                                    {"box", &figures.box_clocks},
                                                    {"halfspace", &figures.halfspace_clocks},
                                                    {"cell", &figures.cell_clocks},
                                                    {"node", &figures.node_clocks},
                                                    {"programs", &settings.programs},
                                                    {"instructions", &settings.instructions}};
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::size_t equals = argument.find('=');
    const auto setting = known.find(argument.substr(0, equals));
    if (equals == argument.npos || setting == known.end()) throw std::invalid_argument("what is " + argument + "?");
    *setting->second = static_cast<std::uint32_t>(std::stoul(argument.substr(equals + 1)));
  }
  figures.divider = static_cast<pixel_square::DividerKind>(divider);
  figures.order = static_cast<pixel_square::SquareOrder>(order);
  return settings;
}

/// The colours that the pixels hold at the end of each segment; the background where none worked.
class Picture final : public sim::Observer {
 public:
  explicit Picture(const isa::Program& program)
      : program_(program),
        colour_(isa::field_of(program, isa::FieldRole::colour)),
        colours(std::size_t{program.shape.width} * program.shape.height) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }

  void after_segment(std::uint32_t segment, const sim::PixelState& state) override {
    const isa::Region region = state.region();
    std::vector<std::uint32_t> values(std::size_t{region.width} * region.height, program_.background);
    if (!program_.segments[segment].instructions.empty()) state.read_field(colour_, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t y = region.y + i / region.width;
      colours[y * program_.shape.width + region.x + i % region.width] = values[i];
    }
  }

 private:
  const isa::Program& program_;
  isa::Field colour_;

 public:
  std::vector<std::uint32_t> colours;
};

/// Every clock of the frame is accounted for, in every part.
bool adds_up(const sim::RunResult& result) {
  return std::all_of(result.account.parts.begin(), result.account.parts.end(), [&](const machines::PartAccount& part) {
    std::uint64_t sum = 0;
    for (const machines::ActivityClocks& one : part.clocks) sum += one.clocks;
    return sum == result.clocks;
  });
}

std::string show(const sim::RunResult& result) {
  std::string text = fmt::format("{} clocks", result.clocks);
  for (const machines::Count& count : result.account.counts) text += fmt::format(", {} {}", count.value, count.name);
  for (const machines::PartAccount& part : result.account.parts) {
    text += fmt::format("\n  {}:", part.part);
    for (const machines::ActivityClocks& one : part.clocks) text += fmt::format(" {} {}", one.activity, one.clocks);
  }
  return text;
}

bool agree(const Settings& settings) {
  const machines::Machine& machine = settings.machine;
  const auto reference = sim::make_reference_engine(machine);
  const auto functional = sim::make_functional_engine(machine);
  const auto cycle = sim::make_cycle_engine(machine);
  return rc::check("the clocked pixel-square machine leaves the bits, picture, clocks and account worked out", [&] {
    const isa::Program program = machines::division(machine)
                                     ? any_divided_program(machine)
                                     : *arbitrary_program_in_parts(machine, settings.instructions);
    isa::validate(program);
    const sim::RunResult counted = check_lockstep(*reference, *cycle, program, machine).engine;
    Picture picture(program);
    sim::Observer* const observers[] = {&picture};
    const sim::RunResult expected = functional->run(program, observers);
    if (counted.clocks != expected.clocks || counted.account != expected.account) {
      RC_FAIL("counted " + show(counted) + "\nworked out " + show(expected));
    }
    RC_ASSERT(adds_up(counted));
    RC_ASSERT(counted.overflows == expected.overflows);
    if (isa::field_of(program, isa::FieldRole::colour).width == 0) {
      RC_ASSERT(counted.scanned_out.empty());
    } else {
      RC_ASSERT(counted.scanned_out == picture.colours);
    }
  });
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    const csgsim::test::Settings settings = csgsim::test::read_settings(argc, argv);
    ::setenv("RC_PARAMS", fmt::format("max_success={} noshrink=0", settings.programs).c_str(), 0);
    return csgsim::test::agree(settings) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}
