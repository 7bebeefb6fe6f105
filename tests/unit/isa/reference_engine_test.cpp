#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"
#include "sim/engine/engine.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::engine;
using namespace csgsim::reference;

namespace {

using isa::Opcode;

machines::Machine machine_of(isa::ArrayShape shape) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = shape;
  return machine;
}

/// Two segments: the first fills a field with 5 and queries the global OR; the second queries before and after it
/// enables a column.
isa::Program two_segments() {
  isa::Program program;
  program.shape = {8, 4, 16};
  const isa::Instruction ask{Opcode::global_or, {}, {}, 0, {}};
  const isa::Instruction enable_all{Opcode::enable_all, {}, {}, 0, {}};
  program.segments = {{{0, 0, 8, 4}, {enable_all, {Opcode::set_constant, {{{0, 8}}}, {}, 5, {}}, ask}},
                      {{2, 1, 3, 2}, {ask, enable_all, {Opcode::edge_not_negative, {}, {1, 0, -2, 3, 0}, 0, {}}, ask}}};
  return program;
}

struct Record {
  std::uint32_t segment;
  std::uint32_t index;
  std::uint64_t clocks;
  std::uint64_t enabled;
  bool operator==(const Record&) const = default;
};

class Recorder final : public Observer {
 public:
  void after_instruction(const Step& step, const PixelState&) override {
    steps.push_back({step.segment, step.index, step.clocks, step.enabled_pixels});
  }
  void after_segment(std::uint32_t segment, const PixelState& state) override {
    segments.push_back(segment);
    std::vector<std::uint32_t> values(static_cast<std::size_t>(state.region().width) * state.region().height);
    state.read_field({0, 8}, values);
    first_values.push_back(values.front());
  }

  std::vector<Record> steps;
  std::vector<std::uint32_t> segments;
  std::vector<std::uint32_t> first_values;
};

/// Clocks of the controller in the given activities.
std::uint64_t clocks_of(const RunResult& result, const std::vector<std::string_view>& activities) {
  std::uint64_t clocks = 0;
  for (const machines::ActivityClocks& one : result.account.parts.at(0).clocks) {
    if (std::find(activities.begin(), activities.end(), one.activity) != activities.end()) clocks += one.clocks;
  }
  return clocks;
}

TEST_CASE("a reference run takes each instruction's clocks and the latency once") {
  const auto machine = machine_of({8, 4, 16});
  const RunResult result = make_reference_engine(machine)->run(two_segments(), {});
  // Latency is 3 + 2 levels; a query takes 1 + 5.
  CHECK(result.latency_clocks == 5);
  CHECK(clocks_of(result, {"issuing", "answering"}) == (1 + 8 + 6) + (6 + 1 + 3 + 6));
  CHECK(clocks_of(result, {"draining"}) == 5);
  CHECK(result.shown_clocks == result.clocks);
  CHECK(result.overflows == 0);
}

TEST_CASE("answers report whether any pixel of the segment is enabled") {
  const RunResult result = make_reference_engine(machine_of({8, 4, 16}))->run(two_segments(), {});
  CHECK(result.answers == std::vector<bool>{true, false, true});
}

TEST_CASE("each observer receives every instruction and the pixels enabled before it") {
  Recorder first;
  Recorder second;
  const std::array<Observer*, 2> observers{&first, &second};
  make_reference_engine(machine_of({8, 4, 16}))->run(two_segments(), observers);
  const std::vector<Record> expected{{0, 0, 1, 0}, {0, 1, 8, 32}, {0, 2, 6, 32}, {1, 0, 6, 0},
                                     {1, 1, 1, 0}, {1, 2, 3, 6},  {1, 3, 6, 2}};
  CHECK(first.steps == expected);
  CHECK(second.steps == expected);
  CHECK(first.segments == std::vector<std::uint32_t>{0, 1});
}

TEST_CASE("a segment starts with cleared memory") {
  Recorder recorder;
  const std::array<Observer*, 1> observers{&recorder};
  make_reference_engine(machine_of({8, 4, 16}))->run(two_segments(), observers);
  CHECK(recorder.first_values == std::vector<std::uint32_t>{5, 0});
}

TEST_CASE("overflows accumulate over segments") {
  isa::Program program = two_segments();
  const isa::Instruction narrow{Opcode::edge_negative, {}, {0, 0, 2, 2, 0}, 0, {}};
  program.segments[0].instructions.push_back(narrow);
  program.segments[1].instructions.push_back(narrow);
  CHECK(make_reference_engine(machine_of({8, 4, 16}))->run(program, {}).overflows == 32 + 2);
}

isa::Instruction skip(std::uint64_t count) { return {Opcode::skip_if_none, {}, {}, count, {}}; }

const isa::Instruction all{Opcode::enable_all, {}, {}, 0, {}};
const isa::Instruction invert{Opcode::enable_invert, {}, {}, 0, {}};
const isa::Instruction ask{Opcode::global_or, {}, {}, 0, {}};

/// Runs segments on 8 x 4 pixels with a latency of 5 clocks.
RunResult run(const std::vector<std::vector<isa::Instruction>>& segments, Recorder& recorder) {
  isa::Program program;
  program.shape = {8, 4, 16};
  for (const std::vector<isa::Instruction>& instructions : segments)
    program.segments.push_back({{0, 0, 8, 4}, instructions});
  isa::validate(program);
  const std::array<Observer*, 1> observers{&recorder};
  return make_reference_engine(machine_of(program.shape))->run(program, observers);
}

TEST_CASE("a skip without enabled pixels omits its instructions at no cost") {
  Recorder recorder;
  const RunResult result = run({{skip(2), all, all, ask, all}}, recorder);
  CHECK(recorder.steps == std::vector<Record>{{0, 0, 6, 0}, {0, 3, 6, 0}, {0, 4, 1, 0}});
  CHECK(clocks_of(result, {"issuing", "answering"}) == 6 + 6 + 1);
  CHECK(clocks_of(result, {"draining"}) == 5);
  CHECK(result.skipped == 2);
  CHECK(result.answers == std::vector<bool>{false});
}

TEST_CASE("a skip with an enabled pixel omits nothing") {
  Recorder recorder;
  const isa::Instruction last_column{Opcode::edge_not_negative, {}, {1, 0, -7, 4, 0}, 0, {}};
  const isa::Instruction last_row{Opcode::edge_not_negative, {}, {0, 1, -3, 3, 0}, 0, {}};
  const RunResult result = run({{all, last_column, last_row, skip(1), all, ask}}, recorder);
  CHECK(recorder.steps ==
        std::vector<Record>{{0, 0, 1, 0}, {0, 1, 4, 32}, {0, 2, 3, 4}, {0, 3, 6, 1}, {0, 4, 1, 1}, {0, 5, 6, 32}});
  CHECK(result.skipped == 0);
  CHECK(result.answers == std::vector<bool>{true});
}

TEST_CASE("a skip to the end of a segment continues with the next segment") {
  Recorder recorder;
  const RunResult result = run({{skip(2), all, ask}, {all, ask}, {skip(1), all}}, recorder);
  CHECK(recorder.steps == std::vector<Record>{{0, 0, 6, 0}, {1, 0, 1, 0}, {1, 1, 6, 32}, {2, 0, 6, 0}});
  CHECK(recorder.segments == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(result.skipped == 3);
  CHECK(result.answers == std::vector<bool>{true});
}

TEST_CASE("a skip_if_none takes effect only if it is not skipped itself") {
  Recorder skipped;
  CHECK(run({{skip(1), skip(2), all, ask}}, skipped).answers == std::vector<bool>{true});
  Recorder reached;
  const RunResult result = run({{skip(1), all, skip(1), all, ask, all, skip(1), invert, ask}}, reached);
  CHECK(result.answers == std::vector<bool>{false, false});
  CHECK(result.skipped == 2);
}

TEST_CASE("skipped instructions count no overflow") {
  const isa::Instruction narrow{Opcode::edge_negative, {}, {0, 0, 2, 2, 0}, 0, {}};
  Recorder recorder;
  CHECK(run({{skip(2), all, narrow, all, narrow}}, recorder).overflows == 32);
}

TEST_CASE("a query on a machine without global OR is rejected before the run") {
  machines::Machine machine = machine_of({8, 4, 16});
  machines::kind_figures<pixel_planes::Figures>(machine).has_global_or = false;
  machine.name = "deaf";
  isa::Program program = two_segments();
  Recorder recorder;
  const std::array<Observer*, 1> observers{&recorder};
  CHECK_THROWS_WITH_AS(make_reference_engine(machine)->run(program, observers),
                       "segment 0, instruction 2: global_or needs a global OR, which the machine deaf does not have; "
                       "compile the model for this machine, or use one with global_or.present = 1",
                       InputError);
  CHECK(recorder.steps.empty());
  program.segments = {{{0, 0, 8, 4}, {all, skip(1), all}}};
  CHECK_THROWS_AS(make_reference_engine(machine)->run(program, {}), InputError);
  program.segments = {{{0, 0, 8, 4}, {all, all}}};
  CHECK_NOTHROW(make_reference_engine(machine)->run(program, {}));
}

TEST_CASE("the reference engine reports the level `reference`") {
  CHECK(make_reference_engine(machine_of({1, 1, 1}))->level() == "reference");
}

}  // namespace
