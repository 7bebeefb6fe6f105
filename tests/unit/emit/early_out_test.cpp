#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/observe/stats.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace isa;

namespace {

bool is_skip(const Instruction& instruction) { return instruction.opcode == Opcode::skip_if_none; }

std::vector<Instruction> without_skips(std::vector<Instruction> instructions) {
  std::erase_if(instructions, is_skip);
  return instructions;
}

const std::vector<Instruction>& instructions_of(const isa::Program& program) {
  return program.segments.at(0).instructions;
}

/// A cube in front of everything else, and behind it a sphere with a hole.
constexpr const char* behind_a_cube =
    "multmatrix([[1,0,0,0],[0,1,0,-20],[0,0,1,0],[0,0,0,1]]){cube(size=[30,2,30],center=true);}"
    "difference(){sphere($fn=24,r=9);cylinder($fn=24,h=30,r1=3,r2=3,center=true);}";

testing::Setup setup(emit::Strategy strategy = emit::Strategy::stack,
                     emit::Colouring colouring = emit::Colouring::rebroadcast) {
  testing::Setup made;
  made.camera = {{5, -90, 10}, {0, 0, 0}, view::Projection::orthographic};
  made.sampling.width = 64;
  made.sampling.height = 64;
  made.memory_bits = 120;
  made.options.strategy = strategy;
  made.options.colouring = colouring;
  made.options.pruning.hidden = false;
  return made;
}

struct Ran {
  engine::RunResult result;
  observe::Stats stats;
};

Ran run(const isa::Program& program) {
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 1> observers{&stats};
  engine::RunResult result = engine::make_reference_engine(testing::machine_of(program.shape))->run(program, observers);
  return {std::move(result), stats.stats()};
}

}  // namespace

TEST_CASE("early out adds nothing but queries to the instructions of a Program") {
  for (const emit::Strategy strategy :
       {emit::Strategy::stack, emit::Strategy::list, emit::Strategy::bits, emit::Strategy::products}) {
    for (const emit::Colouring colouring : {emit::Colouring::rebroadcast, emit::Colouring::field}) {
      CAPTURE(emit::name_of(strategy));
      testing::Setup how = setup(strategy, colouring);
      const isa::Program with_queries = testing::compile_text(behind_a_cube, how).program;
      how.options.pruning.early_out = false;
      const isa::Program without_queries = testing::compile_text(behind_a_cube, how).program;
      CHECK(std::none_of(instructions_of(without_queries).begin(), instructions_of(without_queries).end(), is_skip));
      CHECK(instructions_of(with_queries).size() > instructions_of(without_queries).size());
      CHECK(without_skips(instructions_of(with_queries)) == instructions_of(without_queries));
      how.options.pruning.early_out = true;
      how.has_global_or = false;
      CHECK(testing::compile_text(behind_a_cube, how).program == without_queries);
    }
  }
}

TEST_CASE("a query guards at least sixteen times its clocks and guards are nested") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    testing::Setup how = setup();
    how.camera = one.camera;
    const isa::Program program = testing::compile_file(testing::model_path(one.name), how).program;
    const machines::Machine machine = testing::machine_of(program.shape);
    const std::span<const Instruction> all = instructions_of(program);
    std::size_t end_before = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!is_skip(all[i])) continue;
      const std::span<const Instruction> guarded = all.subspan(i + 1, all[i].constant);
      const std::size_t end = i + 1 + guarded.size();
      CHECK(machines::clocks(guarded, machine) >= 16 * machines::clocks(all[i], machine));
      CHECK(std::all_of(guarded.begin(), guarded.end(), [&](const Instruction& instruction) {
        const bool shades_set =
            instruction.origin.purpose == isa::Purpose::shade && instruction.origin.node == all[i].origin.primitive;
        return shades_set || instruction.origin.primitive == all[i].origin.primitive;
      }));
      CHECK((i >= end_before || end == end_before));
      end_before = std::max(end_before, end);
    }
  }
}

TEST_CASE("early out skips hidden primitives and all clocks add up to the total") {
  const isa::Program program = testing::compile_text(behind_a_cube, setup()).program;
  testing::Setup how = setup();
  how.options.pruning.early_out = false;
  const Ran with_queries = run(program);
  const Ran without_queries = run(testing::compile_text(behind_a_cube, how).program);
  CHECK(with_queries.result.skipped > 0);
  CHECK(with_queries.result.clocks < without_queries.result.clocks);
  CHECK(with_queries.result.clocks < machines::clocks(program, testing::machine_of(program.shape)));
  CHECK(with_queries.stats.total.instructions + with_queries.result.skipped == instructions_of(program).size());
  std::uint64_t others = 0;  // controller clocks that belong to no instruction
  for (const auto& [activity, clocks] : with_queries.result.account.parts.front().clocks) {
    if (activity == "clearing" || activity == "starved" || activity == "jumping") others += clocks;
  }
  CHECK(with_queries.stats.total.clocks + others + with_queries.result.latency_clocks == with_queries.result.clocks);
  observe::Cost by_purpose;
  for (const observe::Cost& cost : with_queries.stats.by_purpose) by_purpose += cost;
  CHECK(by_purpose == with_queries.stats.total);
  const auto of = [](const Ran& ran, isa::Purpose purpose) {
    return ran.stats.by_purpose[static_cast<std::size_t>(purpose)];
  };
  CHECK(of(with_queries, isa::Purpose::render) == of(without_queries, isa::Purpose::render));
  CHECK(of(with_queries, isa::Purpose::shade).clocks < of(without_queries, isa::Purpose::shade).clocks);
}

TEST_CASE("measure_clocks() returns the clocks of a run with skips") {
  const isa::Program program = testing::compile_text(behind_a_cube, setup()).program;
  CHECK(functional::measure_clocks(program, testing::machine_of(program.shape)) == run(program).result.clocks);
}
