#include <nlohmann/json.hpp>

#include "hw/machines/description.h"
#include "hw/machines/timeline.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
#include "tests/kinds/raster.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

const std::string description = R"(
name = "one"
description = "one processor"
kind = "raster"
[array.width]
value = 24
unit = "pixels"
provenance = "assumed"
source = "small"
[array.height]
value = 18
unit = "pixels"
provenance = "assumed"
source = "small"
[array.memory_bits]
value = 72
unit = "bits"
provenance = "assumed"
source = "enough"
[clock.frequency]
value = 1000000
unit = "Hz"
provenance = "assumed"
source = "slow"
[processor.pixel_clocks]
value = 2
unit = "clocks"
provenance = "assumed"
source = "a read and a write"
)";

machines::Machine described(const std::string& text) {
  const machines::Kind* const kinds[] = {&raster::kind};
  return machines::read_description(text, "one.toml", kinds);
}

isa::Program program_for(const machines::Machine& machine) {
  testing::Setup setup;
  setup.camera = testing::camera({42, -38, 41}, {10, 5.5, 2}, view::Projection::orthographic);
  setup.sampling.width = machine.picture.width;
  setup.sampling.height = machine.picture.height;
  setup.has_global_or = false;
  return testing::compile_file(testing::model_path("thesis_fig_2_3"), setup).program;
}

struct Drawn {
  observe::Frame frame;
  engine::RunResult result;
  nlohmann::json stats;
};

Drawn draw(engine::Engine& engine, const isa::Program& program, const machines::Machine& machine) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  engine::Observer* const observers[] = {&frame, &stats};
  engine::RunResult result = engine.run(program, observers);
  const auto json = observe::to_json({program, machine, std::string(engine.level()), result, stats.stats(), 0});
  return {frame.frame(), std::move(result), json};
}

}  // namespace

TEST_CASE("a kind defined in a single folder has equal pictures and clocks at both levels") {
  const machines::Machine machine = described(description);
  CHECK(machine.picture == machines::Size{24, 18});
  const isa::Program program = program_for(machine);
  const auto hardware = raster::make_machine(machine);
  const Drawn counted = draw(*cycle::make_clocked_engine(machine, *hardware), program, machine);
  const Drawn worked_out = draw(*engine::make_functional_engine(machine), program, machine);
  const observe::Frame whole = testing::draw(program);
  CHECK(counted.frame.colour == whole.colour);
  CHECK(counted.frame.depth == whole.depth);
  CHECK(counted.frame.owner == whole.owner);
  CHECK(counted.result.clocks == program.segments.front().instructions.size() * 24 * 18 * 2);
  CHECK(worked_out.result.clocks == counted.result.clocks);
  CHECK_THROWS_WITH_AS(machines::timeline(program, machine),
                       "machines of the kind raster provide no instruction timeline; use another --machine",
                       InputError);
  CHECK(worked_out.result.account == counted.result.account);
  CHECK(counted.stats["machine"]["kind"] == "raster");
  CHECK(counted.stats["account"]["parts"]["processor"]["working"] == counted.result.clocks);
}

TEST_CASE("a parameter may be ideal only if its kind's schema allows it") {
  std::string text = description;
  text.replace(text.find("value = 2\n"), 9, "value = \"ideal\"");
  const machines::Machine machine = described(text);
  CHECK(machines::ideal_parameters(machine) == std::vector<std::string>{"processor.pixel_clocks"});
  CHECK(engine::make_functional_engine(machine)->run(program_for(machine), {}).clocks == 0);
  CHECK(machines::ideal_parameters(described(description)).empty());
  text = description;
  text.replace(text.find("value = 24"), 10, "value = \"ideal\"");
  CHECK_THROWS_WITH_AS(described(text), "one.toml:6:9: array.width is 'ideal'; write a whole number of pixels",
                       InputError);
}
