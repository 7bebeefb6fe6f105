// lockstep_squares KEY=NUMBER...: draws random Programs on the clocked pixel-square machine with those figures and
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
#include "tests/lockstep/lockstep.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

using machines::SquareAccount;
using machines::SquareClocks;

struct Settings {
  machines::Machine machine;
  unsigned programs = 40;
  unsigned instructions = 12;  ///< of a square at most
};

Settings read_settings(int count, char** arguments) {
  Settings settings;
  machines::Machine& machine = settings.machine;
  machine.name = "squares";
  machine.kind = machines::Kind::pixel_square;
  machine.array = {8, 8, 40};
  machine.picture = {20, 20};
  machine.clock_hz = 10'000'000;
  machines::PixelSquare& figures = machine.pixel_square;
  std::uint32_t order = 0;
  const std::map<std::string, std::uint32_t*> known{{"picture_width", &machine.picture.width},
                                                    {"picture_height", &machine.picture.height},
                                                    {"width", &machine.array.width},
                                                    {"height", &machine.array.height},
                                                    {"bits", &machine.array.memory_bits},
                                                    {"reads", &machine.memory_reads},
                                                    {"depth", &figures.fifo_depth},
                                                    {"renderers", &figures.renderers},
                                                    {"buffers", &figures.buffers},
                                                    {"port", &figures.port_bits},
                                                    {"host", &figures.host_word_clocks},
                                                    {"primitive", &figures.primitive_clocks},
                                                    {"halfspace", &figures.halfspace_clocks},
                                                    {"order", &order},
                                                    {"programs", &settings.programs},
                                                    {"instructions", &settings.instructions}};
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::size_t equals = argument.find('=');
    const auto setting = known.find(argument.substr(0, equals));
    if (equals == argument.npos || setting == known.end()) throw std::invalid_argument("what is " + argument + "?");
    *setting->second = static_cast<std::uint32_t>(std::stoul(argument.substr(equals + 1)));
  }
  figures.order = static_cast<machines::SquareOrder>(order);
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
    std::vector<std::uint32_t> values(std::size_t{region.width} * region.height, program_.compile.background);
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

std::uint64_t sum(const SquareClocks& clocks) {
  return std::accumulate(clocks.begin(), clocks.end(), std::uint64_t{0});
}

/// Every clock of the frame is accounted for, in every part.
bool adds_up(const sim::RunResult& result) {
  const auto& account = std::get<SquareAccount>(result.account);
  bool whole = sum(account.host) == result.clocks && sum(account.divider) == result.clocks &&
               sum(account.frame_buffer) == result.clocks;
  for (const SquareClocks& one : account.renderers) whole = whole && sum(one) == result.clocks;
  return whole;
}

std::string show(const sim::RunResult& result) {
  const auto& account = std::get<SquareAccount>(result.account);
  std::string text = fmt::format("{} clocks, {} squares drawn, {} skipped", result.clocks, account.squares_drawn,
                                 account.squares_skipped);
  const auto add = [&](std::string_view part, const SquareClocks& clocks) {
    text += fmt::format("\n  {}:", part);
    for (std::size_t i = 0; i < clocks.size(); ++i) {
      text += fmt::format(" {} {}", machines::square_activities[i].name, clocks[i]);
    }
  };
  add("host", account.host);
  add("divider", account.divider);
  for (const SquareClocks& one : account.renderers) add("renderer", one);
  add("frame buffer", account.frame_buffer);
  return text;
}

bool agree(const Settings& settings) {
  const machines::Machine& machine = settings.machine;
  const auto reference = sim::make_reference_engine(machine);
  const auto functional = sim::make_functional_engine(machine);
  const auto cycle = sim::make_cycle_engine(machine);
  return rc::check("the clocked pixel-square machine leaves the bits, picture, clocks and account worked out", [&] {
    const isa::Program program = *arbitrary_program_in_parts(machine, settings.instructions);
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
