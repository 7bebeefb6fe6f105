#include <hwy/targets.h>
#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "hw/isa/validate.h"
#include "sim/engine/engine.h"
#include "tests/lockstep/lockstep.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::ArrayShape;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using isa::Program;

namespace {

/// The first difference between the functional engine and the reference on the Program; empty if there is none.
std::string difference(const Program& program) {
  isa::validate(program);
  const machines::Machine machine = test::machine_of(program.shape, 1);
  const auto judge = engine::make_reference_engine(machine);
  const auto engine = engine::make_functional_engine(machine);
  try {
    test::check_lockstep(*judge, *engine, program, machine);
  } catch (const test::Difference& found) {
    return found.what();
  }
  const std::uint64_t expected = judge->run(program, {}).overflows;
  const std::uint64_t overflows = engine->run(program, {}).overflows;
  return overflows == expected ? "" : fmt::format("{} overflows, not {}", overflows, expected);
}

void require_lockstep(const ArrayShape& shape, std::size_t instructions) {
  CHECK(rc::check(fmt::format("{}x{} of {} bits", shape.width, shape.height, shape.memory_bits), [&] {
    const Program program = *test::arbitrary_program(shape, instructions, 2);
    const std::string found = difference(program);
    if (!found.empty()) RC_FAIL(found);
  }));
}

Program program_of(const ArrayShape& shape, std::vector<Instruction> instructions) {
  Program program;
  program.shape = shape;
  program.segments.push_back({{0, 0, shape.width, shape.height}, std::move(instructions)});
  return program;
}

Instruction op(Opcode opcode, Field first = {}, Field second = {}, Field third = {}) {
  Instruction instruction;
  instruction.opcode = opcode;
  instruction.fields = {first, second, third};
  return instruction;
}

Instruction set(Field field, std::uint64_t constant) {
  Instruction instruction = op(Opcode::set_constant, field);
  instruction.constant = constant;
  return instruction;
}

Instruction with(Opcode opcode, Field field, isa::Linear linear) {
  Instruction instruction = op(opcode, field);
  instruction.linear = linear;
  return instruction;
}

/// Selects one instruction set after another, and restores the default at the end of its life.
class EachInstructionSet {
 public:
  ~EachInstructionSet() { use(0); }
  static void use(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace

TEST_CASE("random Programs leave the same bits as the reference on small arrays") {
  for (const std::uint32_t bits : {8U, 72U, 208U})
    for (const auto& [width, height] : {std::pair{1U, 1U}, {8U, 8U}}) require_lockstep({width, height, bits}, 60);
}

TEST_CASE("random Programs leave the same bits as the reference if rows end within a word") {
  for (const std::uint32_t bits : {8U, 72U}) require_lockstep({100, 30, bits}, 25);
  require_lockstep({65, 65, 72}, 25);
}

TEST_CASE("random Programs leave the same bits as the reference if rows fill words") {
  for (const std::uint32_t bits : {8U, 72U}) require_lockstep({64, 64, bits}, 25);
  require_lockstep({512, 8, 72}, 25);
}

TEST_CASE("random Programs leave the same bits as the reference with every SIMD target") {
  const EachInstructionSet each;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    INFO(hwy::TargetName(target));
    EachInstructionSet::use(target);
    require_lockstep({70, 9, 72}, 40);
  }
}

TEST_CASE("random Programs leave the same bits as the reference on full and partial tiles") {
  for (const auto& [width, height] : {std::pair{65U, 9U}, {130U, 70U}, {20U, 129U}})
    require_lockstep({width, height, 72}, 30);
}

TEST_CASE("blocks decided by their corners are exact at the pixel where F equals a number") {
  const Field z{0, 20};
  const Field other{20, 20};
  constexpr std::uint64_t most = 0xfffff;
  for (const std::int64_t a : {0, 1, -1, 4096, -3'000'000, 40'000'000})
    for (const std::int64_t level : {std::int64_t{0}, std::int64_t{500'000}, std::int64_t{most}})
      for (const std::int64_t beside : {-1, 0, 1}) {
        CAPTURE(a);
        CAPTURE(level);
        CAPTURE(beside);
        // F equals the level at column 64, row 3.
        const isa::Linear plane{.a = a, .b = 7, .c = (level << 12U) + beside - 64 * a - 21, .width = 50, .shift = 12};
        const isa::Linear half{.a = 3, .b = -2, .c = -120, .width = 24, .shift = 0};
        std::vector<Instruction> program{op(Opcode::enable_all), set(z, static_cast<std::uint64_t>(level))};
        for (const Opcode opcode : {Opcode::linear_ge, Opcode::linear_gt, Opcode::linear_le, Opcode::linear_lt,
                                    Opcode::linear_eq, Opcode::keep_max, Opcode::keep_min}) {
          program.push_back(op(Opcode::enable_all));
          program.push_back(with(opcode, z, plane));
        }
        program.push_back(op(Opcode::enable_all));
        program.push_back(with(Opcode::edge_not_negative, {}, half));
        program.push_back(with(Opcode::load_linear, other, plane));
        program.push_back(with(Opcode::keep_max, other, half));
        program.push_back(op(Opcode::field_le, z, other));
        program.push_back(op(Opcode::copy, z, other));
        CHECK(difference(program_of({70, 9, 40}, program)) == "");
      }
}

TEST_CASE("a sphere's depth computed by a root has the same bits as in the reference") {
  // D has 41 bits, its root 20; depth = middle - root, for a sphere of radius 60 at (70, 40).
  const Field d{0, 41};
  const Field root{21, 20};
  const Field depth{41, 20};
  constexpr std::int64_t scale = std::int64_t{1} << 26U;
  const isa::Linear squares{.a = -scale, .b = 0, .c = -scale, .width = 42, .shift = 0};
  const isa::Linear rest{
      .a = 140 * scale, .b = 80 * scale, .c = (3600 - 70 * 70 - 40 * 40) * scale, .width = 42, .shift = 0};
  const isa::Linear middle{.a = 3, .b = 5, .c = 700'000, .width = 24, .shift = 0};
  const isa::Linear linear{.a = 1000, .b = -3000, .c = 1'000'000, .width = 40, .shift = 3};
  CHECK(difference(program_of({150, 90, 72}, {
                                                 op(Opcode::enable_all),
                                                 set(root, 0xfffff),
                                                 with(Opcode::keep_max, {10, 20}, linear),
                                                 op(Opcode::enable_all),
                                                 with(Opcode::squares, {}, squares),
                                                 with(Opcode::load_linear, d, rest),
                                                 op(Opcode::root, d),
                                                 op(Opcode::copy, depth, root),
                                                 with(Opcode::linear_minus, depth, middle),
                                                 op(Opcode::enable_all),
                                                 with(Opcode::linear_plus, {50, 18}, middle),
                                                 with(Opcode::squares, {}, squares),
                                                 with(Opcode::edge_negative, {}, rest),
                                                 op(Opcode::field_lt, depth, root),
                                             })) == "");
}

TEST_CASE("a field keeps its bits if used as a number and then bit by bit") {
  const Field z{4, 20};
  const Field part{10, 9};
  const Field bit{23, 1};
  const isa::Linear plane{.a = 40'000, .b = -3'000, .c = 1'000'000, .width = 40, .shift = 3};
  CHECK(difference(program_of({100, 30, 72}, {
                                                 op(Opcode::enable_all),
                                                 with(Opcode::load_linear, z, plane),
                                                 op(Opcode::enable_all),
                                                 op(Opcode::enable_and, bit),
                                                 set(part, 0x155),
                                                 op(Opcode::enable_store, {5, 1}),
                                                 with(Opcode::keep_max, z, plane),
                                                 op(Opcode::copy, {40, 9}, part),
                                                 op(Opcode::enable_all),
                                                 op(Opcode::bit_not, {40, 1}, {23, 1}),
                                                 op(Opcode::field_le, {30, 20}, z),
                                             })) == "");
}

TEST_CASE("a bit read from a number's lanes has no pixels beyond the row's end") {
  const Field z{0, 20};
  CHECK(difference(program_of({65, 3, 72}, {
                                               op(Opcode::enable_all),
                                               set(z, 0xfffff),
                                               op(Opcode::enable_load, {3, 1}),
                                               op(Opcode::enable_invert),
                                               op(Opcode::enable_or, {19, 1}),
                                           })) == "");
}

TEST_CASE("a comparison uses the wrapped value of F and counts the overflow") {
  const Field z{0, 8};
  const isa::Linear steep{.a = 100, .b = 7, .c = -1000, .width = 9, .shift = 0};
  for (const Opcode opcode : {Opcode::linear_ge, Opcode::linear_gt, Opcode::linear_le, Opcode::linear_lt,
                              Opcode::linear_eq, Opcode::load_linear, Opcode::keep_max, Opcode::keep_min}) {
    CAPTURE(isa::name_of(opcode));
    CHECK(difference(program_of({70, 9, 8}, {op(Opcode::enable_all), set(z, 90), with(opcode, z, steep)})) == "");
  }
}

TEST_CASE("F wraps at the first number beyond its width") {
  for (const std::int64_t sign : {1, -1})
    for (const std::int64_t beyond : {-1, 0, 1}) {
      CAPTURE(sign);
      CAPTURE(beyond);
      // F runs from 0 to about +-2^9 along the row.
      const isa::Linear linear{.a = sign * 64, .b = 0, .c = sign * beyond, .width = 10, .shift = 1};
      for (const Opcode opcode : {Opcode::edge_not_negative, Opcode::edge_negative})
        CHECK(difference(program_of({9, 1, 8}, {op(Opcode::enable_all), with(opcode, {}, linear)})) == "");
      CHECK(difference(program_of({9, 1, 8}, {op(Opcode::enable_all), with(Opcode::load_linear, {0, 8}, linear)})) ==
            "");
    }
}

TEST_CASE("a sum that wraps many times over the picture has the stripes of the reference") {
  for (const std::uint16_t width : {std::uint16_t{1}, std::uint16_t{3}, std::uint16_t{7}, std::uint16_t{20}}) {
    CAPTURE(width);
    const isa::Linear pattern{.a = 37, .b = -91, .c = -1000, .width = width, .shift = 0};
    const Program program = program_of(
        {70, 30, 8}, {op(Opcode::enable_all), with(Opcode::stripe, {}, pattern), op(Opcode::enable_store, {0, 1}),
                      op(Opcode::enable_all), with(Opcode::stripe, {}, {.a = 1, .b = 1, .width = width})});
    CHECK(difference(program) == "");
    CHECK(engine::make_functional_engine(test::machine_of(program.shape, 1))->run(program, {}).overflows == 0);
  }
}

TEST_CASE("sums of numbers in planes and in lanes are exact in all combinations") {
  const isa::Linear plane{.a = 3, .b = -7, .c = 300, .width = 30, .shift = 0};
  const isa::Linear edge{.a = 1, .b = -2, .c = 5, .width = 10, .shift = 0};
  for (const Field source : {Field{0, 1}, {0, 7}, {1, 5}, {0, 8}})
    for (const bool source_in_planes : {false, true})
      for (const bool target_in_planes : {false, true}) {
        CAPTURE(source.width);
        std::vector<Instruction> program{op(Opcode::enable_all), with(Opcode::load_linear, {0, 8}, plane),
                                         op(Opcode::enable_all), with(Opcode::load_linear, {8, 8}, plane),
                                         op(Opcode::enable_all)};
        if (source_in_planes) program.push_back(op(Opcode::bit_not, {0, 8}, {0, 8}));
        if (target_in_planes) program.push_back(op(Opcode::bit_not, {8, 8}, {8, 8}));
        program.push_back(with(Opcode::edge_negative, {}, edge));
        program.push_back(op(Opcode::add, {8, 8}, source));
        program.push_back(op(Opcode::add, {16, 20}, {8, 8}));
        program.push_back(op(Opcode::add, {16, 20}, {8, 8}));
        CHECK(difference(program_of({70, 30, 36}, program)) == "");
      }
}

TEST_CASE("several threads give the same bits and the same counts as one") {
  CHECK(rc::check([] {
    const ArrayShape shape{70, 13, 40};
    const Program program = *test::arbitrary_program(shape, 30, 2);
    isa::validate(program);
    const machines::Machine machine = test::machine_of(shape, 1);
    const auto judge = engine::make_reference_engine(machine);
    test::check_lockstep(*judge, *engine::make_functional_engine(machine, 2), program, machine);
    const engine::RunResult expected = judge->run(program, {});
    for (const unsigned threads : {2U, 5U, 64U}) {
      const auto engine = engine::make_functional_engine(machine, threads);
      const engine::RunResult result = engine->run(program, {});
      RC_ASSERT(result.overflows == expected.overflows);
      RC_ASSERT(result.answers == expected.answers);
      RC_ASSERT(result.skipped == expected.skipped);
      RC_ASSERT(result.clocks == expected.clocks);
    }
  }));
}

TEST_CASE("random Programs skip instructions and contain skips that are not taken") {
  struct Skips final : engine::Observer {
    void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
      if (step.instruction.opcode == Opcode::skip_if_none) ++(step.enabled_pixels == 0 ? taken : passed);
    }
    std::uint64_t taken = 0;
    std::uint64_t passed = 0;
  } skips;
  engine::Observer* const observers[] = {&skips};
  // Enough Programs even if RC_PARAMS requests few.
  for (int round = 0; round < 5; ++round) {
    CHECK(rc::check([&] {
      const Program program = *test::arbitrary_program({8, 8, 72}, 40, 2);
      engine::make_reference_engine(test::machine_of(program.shape, 1))->run(program, observers);
    }));
  }
  CHECK((!testing::draws_from_fixed_seed() || skips.taken > 0));
  CHECK((!testing::draws_from_fixed_seed() || skips.passed > 0));
}

TEST_CASE("one enabled pixel in any tile prevents a skip in all tiles") {
  const ArrayShape shape{70, 13, 40};
  const machines::Machine machine = test::machine_of(shape, 1);
  Instruction skip = op(Opcode::skip_if_none);
  skip.constant = 1;
  for (std::int64_t row = 0; row <= 13; ++row) {
    CAPTURE(row);
    const Program program =
        program_of(shape, {op(Opcode::enable_all), with(Opcode::edge_not_negative, {}, {.a = 1, .c = -69, .width = 8}),
                           with(Opcode::edge_not_negative, {}, {.b = 1, .c = -row, .width = 6}),
                           with(Opcode::edge_not_negative, {}, {.b = -1, .c = row, .width = 6}), skip, set({0, 8}, 7)});
    for (const unsigned threads : {1U, 2U, 5U}) {
      const auto engine = engine::make_functional_engine(machine, threads);
      test::check_lockstep(*engine::make_reference_engine(machine), *engine, program, machine);
      CHECK(engine->run(program, {}).skipped == (row == 13 ? 1 : 0));
    }
  }
}

TEST_CASE("skipped instructions count no overflow") {
  Instruction skip = op(Opcode::skip_if_none);
  skip.constant = 2;
  const isa::Linear narrow{.a = 1, .b = 0, .c = 100, .width = 3, .shift = 0};
  const Program program = program_of({9, 2, 8}, {skip, op(Opcode::enable_all), with(Opcode::edge_negative, {}, narrow),
                                                 op(Opcode::enable_all), with(Opcode::edge_negative, {}, narrow)});
  CHECK(difference(program) == "");
  CHECK(engine::make_reference_engine(test::machine_of(program.shape, 1))->run(program, {}).overflows == 18);
}

TEST_CASE("axis-parallel and oblique edges cut a full array at the exact pixel") {
  for (const std::int64_t a : {-3, 0, 2})
    for (const std::int64_t b : {-5, 0, 3})
      for (const std::int64_t c : {-100, -6, -1, 0, 1, 90})
        for (const Opcode opcode : {Opcode::edge_not_negative, Opcode::edge_negative}) {
          const isa::Linear first{.a = a, .b = b, .c = c, .width = 20, .shift = 2};
          const isa::Linear second{.a = -b, .b = a, .c = c + 7, .width = 20, .shift = 0};
          CHECK(difference(program_of({70, 30, 8}, {op(Opcode::enable_all), with(opcode, {}, first),
                                                    with(Opcode::edge_not_negative, {}, second)})) == "");
        }
}
