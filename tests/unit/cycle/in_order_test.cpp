#include "sim/cycle/in_order.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/cycle/number_view.h"

using namespace csgsim;
using isa::Opcode;

namespace {

/// What an observer was told: an instruction, or the end of a segment.
struct Told {
  std::uint32_t segment = 0;
  std::optional<std::uint32_t> index;     ///< none: the end
  std::optional<std::uint32_t> number{};  ///< that the pixels showed, where the observer looked

  bool operator==(const Told&) const = default;
};

/// Looks after the instructions of one opcode, or after none, and after each segment.
class Witness final : public engine::Observer {
 public:
  explicit Witness(std::optional<Opcode> looks_after) : looks_after_(looks_after) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const override {
    return instruction.opcode == looks_after_;
  }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    told.push_back({step.segment, step.index, {}});
    if (reads_after(step.instruction)) told.back().number = number_of(state);
  }
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    told.push_back({segment, {}, number_of(state)});
  }

  std::vector<Told> told;

 private:
  static std::uint32_t number_of(const engine::PixelState& state) {
    std::vector<std::uint32_t> values(std::size_t{state.region().width} * state.region().height);
    state.read_field({0, 1}, values);
    return values.back();
  }

  std::optional<Opcode> looks_after_;
};

constexpr isa::Instruction looked_at{.opcode = Opcode::enable_all};
constexpr isa::Instruction other{.opcode = Opcode::enable_invert};

isa::Program program_of(const std::vector<std::vector<isa::Instruction>>& segments) {
  isa::Program program;
  for (const std::vector<isa::Instruction>& instructions : segments) {
    program.segments.push_back({.region = {0, 0, 3, 2}, .instructions = instructions});
  }
  return program;
}

/// The pixels show it after that instruction, or, for an index past the last, at the end of the segment.
std::uint32_t number_after(std::uint32_t segment, std::size_t index) {
  return 100 * segment + static_cast<std::uint32_t>(index);
}

/// A machine that draws the segments side by side, a next event of the segment chosen at a time.
class SideBySide {
 public:
  SideBySide(const isa::Program& program, cycle::InOrder& in_order)
      : program_(program), in_order_(in_order), next_(program.segments.size()) {}

  [[nodiscard]] bool has_ended(std::uint32_t segment) const {
    return next_[segment] > program_.segments[segment].instructions.size();
  }

  /// The segment's next instruction, or its end.
  void proceed(std::uint32_t segment) {
    const std::vector<isa::Instruction>& instructions = program_.segments[segment].instructions;
    const std::uint32_t index = next_[segment]++;
    pixels.set(number_after(segment, index));
    if (index == instructions.size()) return in_order_.after_segment(segment, pixels);
    in_order_.after_instruction({.segment = segment, .index = index, .instruction = instructions[index]}, pixels);
  }

  test::NumberView pixels{0};

 private:
  const isa::Program& program_;
  cycle::InOrder& in_order_;
  std::vector<std::uint32_t> next_;
};

/// What a witness has to be told of the Program, in whatever order it is drawn.
std::vector<Told> in_program_order(const isa::Program& program, std::optional<Opcode> looks_after) {
  std::vector<Told> all;
  for (std::uint32_t segment = 0; segment < program.segments.size(); ++segment) {
    const std::vector<isa::Instruction>& instructions = program.segments[segment].instructions;
    for (std::uint32_t index = 0; index < instructions.size(); ++index) {
      all.push_back({segment, index, {}});
      if (instructions[index].opcode == looks_after) all.back().number = number_after(segment, index);
    }
    all.push_back({segment, {}, number_after(segment, instructions.size())});
  }
  return all;
}

}  // namespace

TEST_CASE("in whatever order segments are drawn, observers are told in program order and see what was there then") {
  CHECK(rc::check([] {
    const auto lengths = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 5U));
    std::vector<std::vector<isa::Instruction>> segments;
    segments.reserve(lengths.size());
    for (const std::uint32_t length : lengths) {
      segments.push_back(
          *rc::gen::container<std::vector<isa::Instruction>>(length, rc::gen::element(looked_at, other)));
    }
    const isa::Program program = program_of(segments);
    Witness looks(Opcode::enable_all);
    Witness only_ends(std::nullopt);
    engine::Observer* const observers[] = {&only_ends, &looks};
    cycle::InOrder in_order(program, observers);
    SideBySide machine(program, in_order);
    std::vector<std::uint32_t> unfinished(program.segments.size());
    for (std::uint32_t segment = 0; segment < unfinished.size(); ++segment) unfinished[segment] = segment;
    while (!unfinished.empty()) {
      const auto chosen = *rc::gen::inRange<std::size_t>(0, unfinished.size());
      machine.proceed(unfinished[chosen]);
      if (machine.has_ended(unfinished[chosen])) {
        unfinished.erase(unfinished.begin() + static_cast<std::ptrdiff_t>(chosen));
      }
    }
    RC_ASSERT(looks.told == in_program_order(program, Opcode::enable_all));
    RC_ASSERT(only_ends.told == in_program_order(program, std::nullopt));
  }));
}

TEST_CASE("what comes in its turn is told at once, and nothing is copied") {
  const isa::Program program = program_of({{looked_at, other}, {looked_at}});
  Witness witness(Opcode::enable_all);
  engine::Observer* const observers[] = {&witness};
  cycle::InOrder in_order(program, observers);
  SideBySide machine(program, in_order);
  std::size_t told = 0;
  for (const std::uint32_t segment : {0U, 0U, 0U, 1U, 1U}) {
    machine.proceed(segment);
    CHECK(witness.told.size() == ++told);
  }
  CHECK(machine.pixels.copies() == 0);
}

TEST_CASE("before their turn pixels are copied where an observer looks, and at the end of the segment") {
  const isa::Program program = program_of({{other}, {other, looked_at, other, other}});
  for (const auto& [looks_after, copies] :
       {std::pair{std::optional(Opcode::enable_all), 2U}, {std::optional<Opcode>(), 1U}}) {
    Witness witness(looks_after);
    engine::Observer* const observers[] = {&witness};
    cycle::InOrder in_order(program, observers);
    SideBySide machine(program, in_order);
    for (int i = 0; i < 5; ++i) machine.proceed(1);
    CHECK(witness.told.empty());
    CHECK(machine.pixels.copies() == copies);
  }
}

TEST_CASE("a segment whose turn comes while it is drawn is told from then on as it goes") {
  const isa::Program program = program_of({{looked_at}, {looked_at, looked_at, looked_at}});
  Witness witness(Opcode::enable_all);
  engine::Observer* const observers[] = {&witness};
  cycle::InOrder in_order(program, observers);
  SideBySide machine(program, in_order);
  machine.proceed(1);
  machine.proceed(0);
  machine.proceed(0);
  CHECK(witness.told.size() == 3);
  machine.proceed(1);
  CHECK(witness.told.back() == Told{1, 1, number_after(1, 1)});
  CHECK(machine.pixels.copies() == 1);
}

TEST_CASE("an observer that reads without having said so is told so, in its turn and before it") {
  struct Curious final : engine::Observer {
    [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
    void after_instruction(const engine::Step& /*step*/, const engine::PixelState& state) override {
      std::vector<std::uint64_t> words(2);
      state.read_enable(words);
    }
  } curious;
  engine::Observer* const observers[] = {&curious};
  const isa::Program program = program_of({{}, {other}});
  cycle::InOrder held(program, observers);
  SideBySide ahead(program, held);
  CHECK_NOTHROW(ahead.proceed(1));
  CHECK_THROWS_AS(ahead.proceed(0), std::logic_error);
  cycle::InOrder at_once(program, observers);
  SideBySide in_turn(program, at_once);
  CHECK_NOTHROW(in_turn.proceed(0));
  CHECK_THROWS_AS(in_turn.proceed(1), std::logic_error);
}
