#include "hw/isa/facts.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "tests/cli/cli.h"
#include "tests/waves/engine_state.h"
#include "tests/waves/vcd.h"

using namespace csgsim;

namespace {

using namespace csgsim::testing::cli;
using csgsim::test::EngineState;
using csgsim::test::Vcd;

/// A machine whose pixels may be at different instructions, and the other parts shown in its wave.
struct Case {
  std::string machine;
  std::string top;
  std::vector<std::string> parts;
};

const std::vector<Case> cases{
    {"scan-line",
     "scan_line",
     {"host.line", "link.fill", "entry.packet", "entry.text", "refresh.colour", "pixel_12_8.beat", "pixel_12_8.sum"}},
    {"scan-line+chains.count=3", "scan_line", {"link_2.activity", "entry_0.instruction", "refresh_1.line"}},
    {"pixel-square",
     "pixel_square",
     {"host.state", "model.fill", "divider.square", "renderer_0.controller.text", "renderer_0.root.a",
      "renderer_0.pixels.function", "renderer_0.port_fill", "frame_buffer.square", "pixel_12_8.carry"}},
    {"pixel-planes-5", "pixel_square", {"renderer_1.state", "pixel_12_8.renderer", "pixel_12_8.stored"}},
    {"multi-processor",
     "multi_processor",
     {"display.segment", "bus.master", "barrier.gathered", "node_3_3.subsegment", "pixel_12_8.image"}},
};

/// Compares the wave of pixel 12,8 with the reference, from shortly before its first instruction on.
void check_wave(const Case& one) {
  constexpr std::uint64_t clocks = 600;
  const Folder folder;
  const std::string file = folder / "p.csgt";
  const Outcome compiled =
      run("compile " + model("basics_csg") + " --view-all --size 24x16 --machine " + one.machine + " -o " + file);
  REQUIRE_MESSAGE(compiled.code == 0, compiled.err);
  const isa::Program program = isa::load_program(file);
  machines::Machine machine = kinds::load(one.machine);
  machines::adopt_shape(machine, program);
  const EngineState state(program, machine, 12, 8);
  const std::uint64_t begin = state.first_clock() - 20;
  const std::uint64_t end = std::min(begin + clocks, state.last_clock());
  const Outcome recorded = run(fmt::format("wave {} --machine {} --pixel 12,8 --window {}:{} -o {}", file, one.machine,
                                           begin, end, folder / "w.vcd"));
  REQUIRE_MESSAGE(recorded.code == 0, recorded.err);
  const Vcd vcd(content(folder / "w.vcd"));
  const std::uint64_t period = 1'000'000'000'000 / machine.clock_hz;
  for (const std::string& part : one.parts) CHECK_NOTHROW((void)vcd.at(one.top + "." + part, vcd.last_time()));
  std::size_t compared = 0;
  for (std::uint64_t clock = begin; clock < end; ++clock) {
    const auto shown = [&, time = (clock + 1) * period](const std::string& name) {
      return vcd.number_at(one.top + ".pixel_12_8." + name, time);
    };
    CAPTURE(clock);
    REQUIRE(shown("instruction") == state.instruction_at(clock));
    const auto enable = state.enable_at(clock);
    if (enable) REQUIRE(shown("enable") == static_cast<std::uint64_t>(*enable));
    for (const isa::NamedField& named : program.facts->fields) {
      CAPTURE(named.name);
      const auto expected = state.field_at(named.field, clock);
      if (expected) REQUIRE(shown(named.name) == expected);
      if (expected) ++compared;
    }
  }
  CHECK(compared > 100);
}

}  // namespace

TEST_CASE("a wave of any machine shows its parts and the reference's values in every clock") {
  for (const Case& one : cases) {
    CAPTURE(one.machine);
    check_wave(one);
  }
}

TEST_CASE("a wave of tree levels is rejected for a machine without trees") {
  const Folder folder;
  const std::string file = folder / "p.csgt";
  require_success(run("compile " + model("basics_csg") + " --view-all --size 8x4 --machine scan-line -o " + file));
  const Outcome outcome =
      run("wave " + file + " --machine scan-line --pixel 1,1 --probe tree.x:1 -o " + (folder / "w.vcd"));
  CHECK(outcome.code == 1);
  CHECK(outcome.err.find("this machine has no multiplier trees; remove the tree levels") != std::string::npos);
  const Outcome stepped =
      run("wave " + file + " --machine scan-line --pixel 1,1 --evaluator stepped -o " + (folder / "w.vcd"));
  CHECK(stepped.code == 1);
  CHECK(stepped.err.find("a machine of kind scan-line has no multiplier trees that can be stepped") !=
        std::string::npos);
}

TEST_CASE("the wave of a multi-processor may end before the model has arrived") {
  const Folder folder;
  const Outcome outcome =
      run("wave " + model("basics_csg") +
          " --view-all --size 24x16 --machine multi-processor --pixel 12,8 --window 0:200 -o " + (folder / "w.vcd"));
  CHECK_MESSAGE(outcome.code == 0, outcome.err);
}
