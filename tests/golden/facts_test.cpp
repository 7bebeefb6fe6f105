#include "hw/isa/facts.h"

#include "hw/isa/host_counts.h"
#include "hw/isa/program_file.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "places.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"
#include "tests/support/bare_text.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::vector<std::string> traces() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(CSGSIM_SOURCE_DIR) + "/traces"))
    if (entry.path().extension() == ".csgt") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

struct Ran {
  engine::RunResult result;
  observe::Cost total;
  std::vector<std::uint32_t> colours;
};

Ran run(const isa::Program& program, const machines::Machine& machine) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  Ran ran{engine::make_functional_engine(machine)->run(program, observers), {}, {}};
  ran.total = stats.stats().total;
  ran.colours = frame.frame().colour;
  return ran;
}

}  // namespace

TEST_CASE("facts and comments change neither counts nor picture of any golden Program") {
  REQUIRE(traces().size() >= 7);
  std::vector<std::string_view> kinds;
  for (const std::string& path : traces()) {
    CAPTURE(path);
    const isa::Program whole = isa::load_program(path);
    const isa::Program bare = isa::parse(testing::bare_text(whole), "bare");
    CHECK(*bare.facts == isa::Facts{});
    REQUIRE(bare.segments.size() == whole.segments.size());
    for (const isa::Segment& segment : bare.segments) {
      CHECK(*segment.facts == isa::SegmentFacts{});
      CHECK(std::ranges::all_of(segment.instructions,
                                [](const isa::Instruction& one) { return one.origin == isa::Origin{}; }));
    }
    machines::Machine machine = kinds::load(whole.machine);
    machines::adopt_shape(machine, whole);
    kinds.push_back(machine.kind->name);
    const Ran with = run(whole, machine);
    const Ran without = run(bare, machine);
    CHECK(with.result.clocks == without.result.clocks);
    CHECK(with.result.shown_clocks == without.result.shown_clocks);
    CHECK(with.result.interval_clocks == without.result.interval_clocks);
    CHECK(with.result.latency_clocks == without.result.latency_clocks);
    CHECK(with.result.skipped == without.result.skipped);
    CHECK(with.result.answers == without.result.answers);
    CHECK((with.result.account == without.result.account));
    CHECK((with.total == without.total));
    CHECK(with.colours == without.colours);
  }
  for (const std::string_view kind : {"frame-buffer", "scan-line", "pixel-square", "multi-processor"})
    CHECK(std::ranges::count(kinds, kind) >= 1);
}
