#include "sim/checkpoint/snapshot.h"

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "sim/checkpoint/file.h"
#include "tests/lockstep/divided_program.h"
#include "tests/support/planes_machine.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using csgsim::testing::error_of;
using testing::planes;

namespace {

/// Complete result of a run.
struct Outcome {
  engine::RunResult result;
  observe::Frame frame;
  observe::Stats stats;
};

bool same(const Outcome& one, const Outcome& other) {
  const engine::RunResult& a = one.result;
  const engine::RunResult& b = other.result;
  return a.clocks == b.clocks && a.latency_clocks == b.latency_clocks && a.shown_clocks == b.shown_clocks &&
         a.interval_clocks == b.interval_clocks && a.overflows == b.overflows && a.skipped == b.skipped &&
         a.answers == b.answers && a.account == b.account && one.frame == other.frame && one.stats == other.stats;
}

/// A run with its observers.
struct ObservedRun {
  ObservedRun(engine::Engine& engine, const isa::Program& program)
      : run(engine.begin(program)), frame(program), stats(program) {}

  void advance(std::uint64_t number) {
    const std::array<engine::Observer*, 2> observers{&frame, &stats};
    run->advance(number, observers);
  }

  std::unique_ptr<engine::Run> run;
  observe::FrameObserver frame;
  observe::StatsObserver stats;
};

Outcome uninterrupted(engine::Engine& engine, const isa::Program& program) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const engine::RunResult result = engine.run(program, observers);
  return {result, frame.frame(), stats.stats()};
}

/// Stops at random places; after each, another level may resume from the bytes of a checkpoint.
Outcome interrupted(std::span<const std::unique_ptr<engine::Engine>> engines, const isa::Program& program,
                    const machines::Machine& machine) {
  const auto any_engine = [&]() -> engine::Engine& {
    return *engines[*rc::gen::inRange<std::size_t>(0, engines.size())];
  };
  const std::uint64_t count = engine::Numbers(program).count();
  const checkpoint::RunIdentity identity = checkpoint::identity_of(program, machine);
  ObservedRun first(any_engine(), program);
  std::unique_ptr<ObservedRun> last;
  ObservedRun* current = &first;
  std::uint64_t at = 0;
  for (int stops = *rc::gen::inRange(0, 4); stops > 0; --stops) {
    at = *rc::gen::inRange<std::uint64_t>(at, count + 1);
    current->advance(at);
    const checkpoint::Snapshot taken =
        checkpoint::take_snapshot(identity, *current->run, current->frame, current->stats);
    const checkpoint::Snapshot read = checkpoint::decode(checkpoint::encode(taken), "test", program, machine);
    RC_ASSERT(read == taken);
    last = std::make_unique<ObservedRun>(any_engine(), program);
    current = last.get();
    checkpoint::resume(read, *current->run, current->frame, current->stats);
    RC_ASSERT(current->run->save() == taken.run);
  }
  current->advance(engine::Run::end);
  RC_ASSERT(current->run->is_finished());
  return {current->run->result(), current->frame.frame(), current->stats.stats()};
}

bool survives_interruptions(const machines::Machine& machine, const rc::Gen<isa::Program>& programs) {
  const std::array<std::unique_ptr<engine::Engine>, 3> engines{engine::make_functional_engine(machine),
                                                               engine::make_functional_engine(machine, 3),
                                                               engine::make_reference_engine(machine)};
  return rc::check([&] {
    const isa::Program program = *programs;
    const Outcome expected = uninterrupted(*engines.back(), program);
    RC_ASSERT(same(interrupted(engines, program, machine), expected));
  });
}

/// A 70 x 4 picture with some pixels enabled and a number in memory.
isa::Program small_program() {
  isa::Program program;
  program.shape = {70, 4, 16};
  program.colour = {8, 6};
  program.facts->fields = {{"Z2", {0, 8}, isa::FieldRole::depth}, {"colour", {8, 6}, isa::FieldRole::colour}};
  program.facts->primitives = {"a"};
  const isa::Linear ramp{.a = 1, .b = 2, .c = 0, .width = 12};
  program.segments.push_back(
      {.region = {0, 0, 70, 4},
       .instructions = {{.opcode = isa::Opcode::enable_all},
                        {.opcode = isa::Opcode::load_linear, .fields = {isa::Field{0, 8}}, .linear = ramp},
                        {.opcode = isa::Opcode::skip_if_none, .constant = 1},
                        {.opcode = isa::Opcode::global_or},
                        {.opcode = isa::Opcode::edge_negative, .linear = {.a = -1, .c = 5, .width = 9}},
                        {.opcode = isa::Opcode::set_constant, .fields = {isa::Field{8, 6}}, .constant = 33}}});
  return program;
}

/// A wall with a pane in front of half of it, drawn twice; the pane's depth is overwritten in between.
isa::Program glass_program() {
  isa::Program program = isa::parse(
      ".array width=70 height=4 memory_bits=40\n.frame colour_base=16 colour_bits=6\n"
      ".field Z2 [0+:8] depth\n.field Z1 [8+:8] candidate_depth\n.field colour [16+:6] colour\n"
      ".field transparency.nearest_depth [24+:8] effect\n"
      ".primitive \"wall\"\n.primitive \"pane\"\n.segment width=70 height=4\n"
      "enable_all; setup\nset_constant Z2, 255; setup\n"
      "edge_negative x + y - 60 (w9); render p0\nload_linear Z1, x + 90 (w10); render p0\n"
      "field_lt Z1, Z2; merge p0\ncopy Z2, Z1; merge p0\n"
      "enable_all; effect\ncopy transparency.nearest_depth, Z2; effect\n"
      "edge_not_negative x - 30 (w9); render p1\nload_linear Z1, x + 2*y + 9 (w10); render p1\n"
      "field_lt Z1, transparency.nearest_depth; merge p1\ncopy transparency.nearest_depth, Z1; merge p1\n"
      "enable_all; effect\nfield_lt transparency.nearest_depth, Z2; effect\n"
      "set_constant transparency.nearest_depth, 3; effect\n",
      "glass");
  program.facts->compile.effects = {"flat", "transparency"};
  auto& instructions = program.segments.front().instructions;
  for (std::size_t i = 6; i < instructions.size(); ++i) instructions[i].origin.effect = 1;
  return program;
}

checkpoint::Snapshot snapshot_at(std::uint64_t number, const isa::Program& program, const machines::Machine& machine) {
  const auto engine = engine::make_functional_engine(machine);
  ObservedRun watched(*engine, program);
  watched.advance(number);
  return checkpoint::take_snapshot(checkpoint::identity_of(program, machine), *watched.run, watched.frame,
                                   watched.stats);
}

}  // namespace

TEST_CASE("a run stopped anywhere and resumed at any level ends as if uninterrupted") {
  for (const isa::ArrayShape shape : {isa::ArrayShape{8, 8, 72}, {70, 5, 33}, {1, 9, 24}})
    CHECK(survives_interruptions(planes(shape), test::arbitrary_program(shape, 40, 2)));
}

TEST_CASE("a run in parts of the picture survives interruptions") {
  for (const char* name : {"scan-line", "pixel-square+divider.kind=host"}) {
    machines::Machine machine = kinds::load(name);
    machines::set_picture_size(machine, {20, 9});
    machine.array.memory_bits = 40;
    CHECK(survives_interruptions(machine, test::arbitrary_program_in_parts(machine, 8)));
  }
}

TEST_CASE("a run with picture-dependent clocks survives interruptions") {
  machines::Machine machine =
      kinds::load("multi-processor+subdivision.levels=1+nodes.columns=2+nodes.rows=2+node.branch_clocks=500");
  machines::set_picture_size(machine, {20, 9});
  machine.array.memory_bits = 200;
  REQUIRE(machine.kind->depends_on_pixels(machine));
  CHECK(survives_interruptions(machine, rc::gen::exec([&] { return test::any_divided_program(machine); })));
}

TEST_CASE("a run with transparent panes survives interruptions") {
  const isa::Program program = glass_program();
  const machines::Machine machine = planes(program.shape);
  CHECK(survives_interruptions(machine, rc::gen::just(program)));
  const auto engine = engine::make_functional_engine(machine, 3);
  const observe::Frame frame = uninterrupted(*engine, program).frame;
  const auto at = [](std::uint32_t x, std::uint32_t y) { return std::size_t{y} * 70 + x; };
  CHECK(frame.owner[at(10, 1)] == 0);
  CHECK(frame.depth[at(10, 1)] == 100);
  CHECK(frame.owner[at(40, 1)] == 1);
  CHECK(frame.depth[at(40, 1)] == 51);
  CHECK(frame.opaque_owner[at(40, 1)] == 0);
  CHECK(frame.opaque_depth[at(40, 1)] == 130);
  CHECK(frame.owner[at(65, 1)] == 1);
  CHECK(frame.opaque_owner[at(65, 1)] == observe::no_owner);
  CHECK(frame.opaque_depth[at(65, 1)] == 255);
}

TEST_CASE("a run stops before the requested instruction and keeps a segment's pixels") {
  isa::Program program = small_program();
  program.segments.push_back(program.segments.front());
  const machines::Machine machine = planes(program.shape);
  for (const auto& engine : {engine::make_functional_engine(machine), engine::make_reference_engine(machine)}) {
    const auto run = engine->begin(program);
    run->advance(2, {});
    CHECK(run->place() == engine::Place{0, 2});
    CHECK(run->value({0, 8}, 9, 3) == 15);
    CHECK(run->is_enabled(9, 3));
    run->advance(6, {});
    CHECK(run->place() == engine::Place{0, 6});
    CHECK_FALSE(run->is_enabled(5, 0));
    CHECK(run->is_enabled(6, 0));
    CHECK(run->value({8, 6}, 6, 0) == 33);
    run->advance(7, {});
    CHECK(run->place() == engine::Place{1, 1});
    CHECK(run->value({8, 6}, 6, 0) == 0);
    CHECK_FALSE(run->is_finished());
    run->advance(12, {});
    CHECK(run->is_finished());
    CHECK(run->result().answers == std::vector<bool>{true, true});
  }
}

TEST_CASE("a run resumed between squares and their instruction restores the squares") {
  isa::Program program;
  program.shape = {90, 5, 16};
  program.segments.push_back(
      {{0, 0, 90, 5},
       {{.opcode = isa::Opcode::enable_all},
        {.opcode = isa::Opcode::squares, .linear = {.a = 1, .c = 2, .width = 17}},
        {.opcode = isa::Opcode::load_linear, .fields = {isa::Field{0, 16}}, .linear = {.width = 17}},
        {.opcode = isa::Opcode::linear_plus, .fields = {isa::Field{0, 16}}, .linear = {.width = 17}}}});
  isa::validate(program);
  const machines::Machine machine = planes(program.shape);
  for (const auto& first : {engine::make_functional_engine(machine), engine::make_reference_engine(machine)}) {
    const auto stopped = first->begin(program);
    stopped->advance(2, {});
    for (const auto& second : {engine::make_functional_engine(machine), engine::make_reference_engine(machine)}) {
      const auto resumed = second->begin(program);
      resumed->restore(stopped->save());
      CHECK(resumed->place() == engine::Place{0, 2});
      resumed->advance(engine::Run::end, {});
      CHECK(resumed->value({0, 16}, 80, 3) == 80U * 80 + 2 * 3 * 3);
    }
    stopped->advance(engine::Run::end, {});
    CHECK(stopped->value({0, 16}, 80, 3) == 80U * 80 + 2 * 3 * 3);
  }
}

TEST_CASE("rejects a checkpoint with a changed size or any changed byte") {
  const isa::Program program = small_program();
  const machines::Machine machine = planes(program.shape);
  const std::vector<std::byte> bytes = checkpoint::encode(snapshot_at(5, program, machine));
  REQUIRE(checkpoint::decode(bytes, "c", program, machine) == snapshot_at(5, program, machine));
  const auto refused = [&](std::span<const std::byte> changed) {
    return error_of([&] { checkpoint::decode(changed, "c", program, machine); }).starts_with("c: the checkpoint ");
  };
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK(refused(std::span(bytes).first(size)));
    std::vector<std::byte> changed = bytes;
    changed[size] ^= std::byte{0x10};
    CHECK(refused(changed));
  }
  std::vector<std::byte> longer = bytes;
  longer.push_back(std::byte{0});
  CHECK(refused(longer));
}

TEST_CASE("rejects a checkpoint of another Program or machine and ignores the name") {
  const isa::Program program = small_program();
  const machines::Machine machine = planes(program.shape);
  const std::vector<std::byte> bytes = checkpoint::encode(snapshot_at(5, program, machine));
  isa::Program other = program;
  other.segments[0].instructions.back().constant = 34;
  CHECK(error_of([&] { checkpoint::decode(bytes, "c", other, machine); }) ==
        "c: the checkpoint belongs to another Program; resume it with the Program it was taken from");
  machines::Machine slower = machine;
  slower.memory_reads = 2;
  CHECK(error_of([&] { checkpoint::decode(bytes, "c", program, slower); }) ==
        "c: the checkpoint belongs to a run on another machine; give the same --machine");
  machines::Machine renamed = machine;
  renamed.name = "another";
  CHECK_NOTHROW(checkpoint::decode(bytes, "c", program, renamed));
}

TEST_CASE("a checkpoint with a state that no run of the Program reaches is rejected") {
  const isa::Program program = small_program();
  const machines::Machine machine = planes(program.shape);
  const checkpoint::Snapshot good = snapshot_at(5, program, machine);
  const auto refused = [&](auto change) {
    checkpoint::Snapshot bad = good;
    change(bad);
    return !error_of([&] { checkpoint::decode(checkpoint::encode(bad), "c", program, machine); }).empty();
  };
  CHECK_FALSE(refused([](checkpoint::Snapshot&) {}));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.place.index = 7; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.place.index = 4; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.place.segment = 1; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.is_end_reported = true; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.answers.push_back(true); }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.skipped = 1; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.skips.push_back({0, 0}); }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.skips.push_back({0, 2}); }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.run.planes[1].at(1) |= std::uint64_t{1} << 6U; }));
  CHECK(refused(
      [](checkpoint::Snapshot& one) { one.run.planes[1].at(7) |= std::uint64_t{1} << 6U; }));  // in the last row
  CHECK(refused([](checkpoint::Snapshot& one) { one.picture.frame.owner[3] = 1; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.picture.frame.depth[3] = 256; }));
  CHECK(refused([](checkpoint::Snapshot& one) { one.picture.frame.colour[3] = 64; }));
  CHECK(refused([](checkpoint::Snapshot& one) { ++one.stats.total.instructions; }));
}

TEST_CASE("a run of a Program without segments ends at once and can be checkpointed") {
  isa::Program nothing;
  nothing.shape = {1, 1, 1};
  const machines::Machine machine = planes(nothing.shape);
  const auto run = engine::make_functional_engine(machine)->begin(nothing);
  CHECK(run->is_finished());
  const checkpoint::Snapshot snapshot = snapshot_at(0, nothing, machine);
  CHECK(checkpoint::decode(checkpoint::encode(snapshot), "c", nothing, machine) == snapshot);
}

TEST_CASE("a machine's identity covers every parameter but not its name or description") {
  const isa::Program program = small_program();
  const machines::Machine machine = planes(program.shape);
  const checkpoint::RunIdentity identity = checkpoint::identity_of(program, machine);
  const auto with = [&](auto change) {
    machines::Machine other = machine;
    change(other);
    return checkpoint::identity_of(program, other);
  };
  CHECK(with([](machines::Machine& one) { one.name = one.description = "other"; }) == identity);
  const checkpoint::RunIdentity others[] = {
      with([](machines::Machine& one) { ++one.picture.width; }),
      with([](machines::Machine& one) { ++one.picture.height; }),
      with([](machines::Machine& one) { ++one.array.width; }),
      with([](machines::Machine& one) { ++one.array.height; }),
      with([](machines::Machine& one) { ++one.array.memory_bits; }),
      with([](machines::Machine& one) { ++one.clock_hz; }),
      with([](machines::Machine& one) { ++one.memory_reads; }),
      with([](machines::Machine& one) { ++one.alu_bits; }),
      with([](machines::Machine& one) { ++one.clear_clocks; }),
      with([](machines::Machine& one) { ++one.link.width; }),
      with([](machines::Machine& one) { one.figures.push_back({}); }),
  };
  for (std::size_t i = 0; i < std::size(others); ++i) {
    CAPTURE(i);
    CHECK(others[i].program == identity.program);
    CHECK(others[i].machine != identity.machine);
  }
}
