#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/pieces.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "sim/observe/bound.h"
#include "sim/observe/knobs.h"
#include "sim/observe/primitive_costs.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

const std::string all_machines[] = {"pixel-planes-4",
                                    "scan-line",
                                    "pixel-square",
                                    "pixel-planes-5",
                                    "multi-processor",
                                    "digital-bit-serial-ddr4",
                                    "pixel-planes-4+scan_out.buffers=2+array.memory_bits=128",
                                    "pixel-square+divider.kind=host+renderers.count=3"};

/// Accumulates clocks by the primitive and the effect that each instruction names.
class Ledger : public engine::Observer {
 public:
  explicit Ledger(const isa::Facts& facts) : facts_(facts) {}
  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
    const isa::Origin& origin = step.instruction.origin;
    all += step.clocks;
    if (origin.effect != isa::no_effect && origin.effect > 0) {
      effects[facts_.compile.effects[origin.effect]] += step.clocks;
    } else if (origin.primitive == isa::no_primitive) {
      unattributed += step.clocks;
    } else {
      primitives[isa::primitive_of(facts_, origin.primitive)] += step.clocks;
    }
  }

  std::uint64_t all = 0;
  std::uint64_t unattributed = 0;
  std::map<std::uint32_t, std::uint64_t> primitives;
  std::map<std::string, std::uint64_t> effects;

 private:
  const isa::Facts& facts_;
};

struct Drawn {
  machines::Machine machine;
  isa::Program program;
  engine::RunResult result;
  observe::Stats stats;
  Ledger ledger;
};

Drawn draw(const std::string& machine_name, const std::string& model, const emit::Options& options = {}) {
  testing::Setup setup;
  setup.sampling.width = 60;
  setup.sampling.height = 44;
  setup.machine = machine_name;
  setup.options = options;
  Drawn drawn{kinds::load(machine_name),
              testing::compile_default_view(testing::model_path(model), setup, view::Projection::orthographic).program,
              {},
              {},
              Ledger(*drawn.program.facts)};
  machines::set_picture_size(drawn.machine, {60, 44});
  observe::StatsObserver stats(drawn.program);
  const std::array<engine::Observer*, 2> observers{&stats, &drawn.ledger};
  drawn.result = engine::make_functional_engine(drawn.machine)->run(drawn.program, observers);
  drawn.stats = stats.stats();
  return drawn;
}

/// Order of changes, the best first.
std::pair<std::uint64_t, std::uint64_t> order_of(const observe::FrameClocks& clocks) {
  return {clocks.hosted, clocks.interval};
}

std::uint64_t activity(const engine::RunResult& result, const char* name) {
  return machines::clocks_of(result.account, "controller", name);
}

}  // namespace

TEST_CASE("primitives and effects and the rest add up to all clocks of a frame") {
  for (const std::string& machine : all_machines) {
    for (const std::string model : {"thesis_fig_2_3", "old_example011", "carburettor"}) {
      CAPTURE(machine);
      CAPTURE(model);
      const Drawn drawn = draw(machine, model);
      const observe::ClockShares shares = observe::clock_shares(drawn.program, drawn.result, drawn.stats);
      std::uint64_t sum = shares.other_clocks + shares.rest;
      for (const observe::PrimitiveCost& one : shares.most_expensive) {
        CHECK(one.clocks == drawn.ledger.primitives.at(one.primitive));
        sum += one.clocks;
      }
      CHECK(shares.effects.empty());
      CHECK(sum == shares.whole);
      CHECK(shares.whole == drawn.ledger.all + drawn.result.latency_clocks);
      CHECK(shares.rest == drawn.ledger.unattributed + drawn.result.latency_clocks);
      CHECK(shares.most_expensive.size() + shares.other_primitives == drawn.ledger.primitives.size());
      if (machine == "pixel-planes-4") {
        CHECK(shares.whole + activity(drawn.result, "clearing") + activity(drawn.result, "starved") +
                  activity(drawn.result, "jumping") ==
              drawn.result.clocks);
      }
    }
  }
}

TEST_CASE("the ten most expensive primitives are listed with their places in the file") {
  const Drawn drawn = draw("pixel-planes-4", "carburettor");
  const observe::ClockShares shares = observe::clock_shares(drawn.program, drawn.result, drawn.stats);
  REQUIRE(shares.most_expensive.size() == 10);
  for (std::size_t i = 1; i < 10; ++i) CHECK(shares.most_expensive[i].clocks <= shares.most_expensive[i - 1].clocks);
  std::multiset<std::uint64_t> clocks;
  for (const auto& [primitive, count] : drawn.ledger.primitives) clocks.insert(count);
  CHECK(*clocks.rbegin() == shares.most_expensive.front().clocks);
  for (const observe::PrimitiveCost& one : shares.most_expensive) {
    CHECK(one.name.ends_with("@" + one.source));
    CHECK(one.source.find(':') != std::string::npos);
  }
  CHECK(observe::source_position("mesh") == "");
}

TEST_CASE("the half-spaces left by pruning count once across all squares") {
  const Drawn whole = draw("pixel-planes-4", "thesis_fig_2_3");
  std::uint64_t halfspaces = 0;
  const observe::ClockShares shares = observe::clock_shares(whole.program, whole.result, whole.stats);
  for (const observe::PrimitiveCost& one : shares.most_expensive) halfspaces += one.halfspaces;
  CHECK(halfspaces == whole.program.segments.front().facts->kept_halfspaces);
  const Drawn squares = draw("pixel-square", "thesis_fig_2_3");
  for (const observe::PrimitiveCost& one :
       observe::clock_shares(squares.program, squares.result, squares.stats).most_expensive) {
    const auto same = std::ranges::find(shares.most_expensive, one.primitive, &observe::PrimitiveCost::primitive);
    REQUIRE(same != shares.most_expensive.end());
    CHECK(one.halfspaces > 0);
    CHECK(one.halfspaces <= same->halfspaces);
  }
}

TEST_CASE("the part that bounds a frame is reported as its bottleneck") {
  const auto bound = [](const std::string& machine, const std::string& model = "carburettor") {
    const Drawn drawn = draw(machine, model);
    const auto found = observe::find_bottleneck(drawn.result, drawn.machine);
    REQUIRE(found);
    CHECK(found->share > 0);
    CHECK(found->share <= 1);
    CHECK(found->by_host == (drawn.result.host_clocks > drawn.result.interval_clocks));
    CHECK((found->sentence.find("The host needs ") != std::string::npos) == found->by_host);
    CHECK(found->sentence.find(found->part) != std::string::npos);
    return found->part;
  };
  CHECK(bound("pixel-planes-4") == "array");
  CHECK(bound("pixel-planes-4+link.width=1") == "link from the host");
  CHECK(bound("scan-line+link.width=2") == "link from the host");
  CHECK(bound("scan-line+host.active_clocks=20000") == "host");
  CHECK(bound("pixel-square+divider.halfspace_clocks=9000") == "divider");
  CHECK(bound("pixel-square+divider.count=2+divider.halfspace_clocks=9000").starts_with("divider "));
  CHECK(bound("pixel-square+divider.kind=host+alu.bits=1") == "renderer 0");
  CHECK(bound("pixel-square+port.width=1", "thesis_fig_2_3") == "frame buffer");
  CHECK(bound("pixel-planes-5+ring.channels=1+ring.width=1") == "ring");
  CHECK(bound("pixel-planes-5+alu.bits=1+ring.word_clocks=1").starts_with("renderer "));
  CHECK(bound("multi-processor+host.link_word_clocks=1000000") == "link from the host");
  CHECK(bound("multi-processor+display.transform_clocks=1000000") == "display processor");
  CHECK(bound("multi-processor+display.transform_clocks=0+display.halfspace_clocks=0+display.cell_clocks=0")
            .starts_with("node "));
}

TEST_CASE("the gain that advice states for a parameter equals that of the changed machine") {
  for (const std::string& name : all_machines) {
    CAPTURE(name);
    const Drawn drawn = draw(name, "carburettor");
    const std::vector<observe::Knob> knobs = observe::parameter_knobs(drawn.program, drawn.machine, drawn.result, name);
    CHECK(!knobs.empty());
    CHECK(knobs.size() <= observe::parameters_to_try(drawn.machine));
    const observe::FrameClocks before = observe::frame_clocks(engine::timing_of(drawn.result));
    observe::FrameClocks previous;
    for (const observe::Knob& knob : knobs) {
      CAPTURE(knob.option);
      CHECK(knob.before == before);
      CHECK(order_of(knob.after) < order_of(before));
      CHECK(order_of(knob.after) >= order_of(previous));
      previous = knob.after;
      REQUIRE(knob.option.starts_with("--machine "));
      machines::Machine machine = kinds::load(knob.option.substr(10));
      machines::set_picture_size(machine, {60, 44});
      const engine::RunResult result = engine::make_functional_engine(machine)->run(drawn.program, {});
      CHECK(observe::frame_clocks(engine::timing_of(result)) == knob.after);
    }
  }
}

TEST_CASE("advice tries every processor as host and states the gain with the host") {
  const Drawn drawn = draw("pixel-planes-4+host.processor=mc68000+host.count=1", "carburettor");
  const std::vector<observe::Knob> knobs =
      observe::parameter_knobs(drawn.program, drawn.machine, drawn.result, "pixel-planes-4");
  REQUIRE(!knobs.empty());
  CHECK(knobs.front().option.starts_with("--machine pixel-planes-4+host.processor="));
  CHECK(knobs.front().option.find("ideal") == std::string::npos);
  for (const std::string_view processor : machines::host_processor_names) {
    if (processor == "ideal" || processor == "mc68000") continue;
    CAPTURE(processor);
    machines::Machine machine = kinds::load(fmt::format("pixel-planes-4+host.processor={}", processor));
    machines::set_picture_size(machine, {60, 44});
    const engine::RunResult result = engine::make_functional_engine(machine)->run(drawn.program, {});
    CHECK(observe::frame_clocks(engine::timing_of(result)).hosted >= knobs.front().after.hosted);
  }
  CHECK(std::ranges::count_if(knobs, [](const observe::Knob& knob) {
          return knob.option.find("host.processor=") != std::string::npos;
        }) == 1);
}

TEST_CASE("a change's worth is the time it saves with the host or else without it") {
  CHECK(observe::worth({400'000, 400'000}, {300'000, 300'000}, 10'000'000) ==
        "30 ms per frame instead of 40 ms (25.0 % less)");
  CHECK(observe::worth({400'000, 8'000'000}, {410'000, 2'000'000}, 10'000'000) ==
        "200 ms per frame with the host instead of 800 ms (75.0 % less)");
  CHECK(observe::worth({400'000, 8'000'000}, {300'000, 8'000'000}, 10'000'000) ==
        "30 ms per frame without the host instead of 40 ms (25.0 % less)");
  std::vector<observe::Knob> knobs(4);
  for (observe::Knob& knob : knobs) knob.before = {10, 100};
  knobs[0].after = {9, 100};
  knobs[1].after = {20, 30};
  knobs[2].after = {10, 100};
  knobs[3].after = {5, 101};
  const std::vector<observe::Knob> helpful = observe::helpful_knobs(knobs);
  REQUIRE(helpful.size() == 2);
  CHECK(helpful[0].after == observe::FrameClocks{20, 30});
  CHECK(helpful[1].after == observe::FrameClocks{9, 100});
  CHECK(observe::best_knob(knobs).size() == 1);
  CHECK(observe::best_knob({knobs[2]}).empty());
}

TEST_CASE("the frame rate with the host is that of the slower of machine and host") {
  CHECK(machines::frame_rates(10'000'000, 400'000, 0) == machines::FrameRates{25, 25});
  CHECK(machines::frame_rates(10'000'000, 400'000, 400'000) == machines::FrameRates{25, 25});
  CHECK(machines::frame_rates(10'000'000, 400'000, 2'000'000) == machines::FrameRates{25, 5});
  CHECK(machines::frame_rates(10'000'000, 0, 0) == machines::FrameRates{0, 0});
  CHECK(machines::frame_rates(10'000'000, 0, 2'000'000) == machines::FrameRates{0, 5});
}

TEST_CASE("advice replaces a parameter that the machine's name already changes") {
  const std::string name = "scan-line+link.width=4+cells.ports=2";
  const Drawn drawn = draw(name, "thesis_fig_2_3");
  const std::vector<observe::Knob> knobs = observe::parameter_knobs(drawn.program, drawn.machine, drawn.result, name);
  REQUIRE(!knobs.empty());
  CHECK(std::ranges::count(knobs, "--machine scan-line+cells.ports=2+link.width=8", &observe::Knob::option) == 1);
}
