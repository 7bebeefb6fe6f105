#include "sim/cycle/in_order.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/cycle/number_view.h"

using namespace csgsim;
using isa::Opcode;

namespace {

/// A notification of an observer: after an instruction, or at the end of a segment.
struct Notification {
  std::uint32_t segment = 0;
  std::optional<std::uint32_t> index;     ///< empty for the end of the segment
  std::optional<std::uint32_t> number{};  ///< value of the pixels, if the observer read them

  bool operator==(const Notification&) const = default;
};

/// Reads the pixels after instructions of one opcode or none, and after each segment.
class Witness final : public engine::Observer {
 public:
  explicit Witness(std::optional<Opcode> reads_after_opcode) : reads_after_opcode_(reads_after_opcode) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const override {
    return instruction.opcode == reads_after_opcode_;
  }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    notifications.push_back({step.segment, step.index, {}});
    if (reads_after(step.instruction)) notifications.back().number = number_of(state);
  }
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    notifications.push_back({segment, {}, number_of(state)});
  }

  std::vector<Notification> notifications;

 private:
  static std::uint32_t number_of(const engine::PixelState& state) {
    std::vector<std::uint32_t> values(std::size_t{state.region().width} * state.region().height);
    state.read_field({0, 1}, values);
    return values.back();
  }

  std::optional<Opcode> reads_after_opcode_;
};

constexpr isa::Instruction observed{.opcode = Opcode::enable_all};
constexpr isa::Instruction other{.opcode = Opcode::enable_invert};

isa::Program program_of(const std::vector<std::vector<isa::Instruction>>& segments) {
  isa::Program program;
  for (const std::vector<isa::Instruction>& instructions : segments) {
    program.segments.push_back({.region = {0, 0, 3, 2}, .instructions = instructions});
  }
  return program;
}

/// Value of the pixels after that instruction, or, for an index past the last, at the end of the segment.
std::uint32_t number_after(std::uint32_t segment, std::size_t index) {
  return 100 * segment + static_cast<std::uint32_t>(index);
}

/// A machine that draws the segments concurrently; the test chooses which one proceeds.
class SideBySide {
 public:
  SideBySide(const isa::Program& program, cycle::ProgramOrderBuffer& in_order)
      : program_(program), in_order_(in_order), next_(program.segments.size()) {}

  [[nodiscard]] bool has_ended(std::uint32_t segment) const {
    return next_[segment] > program_.segments[segment].instructions.size();
  }

  /// Executes the segment's next instruction, or ends the segment.
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
  cycle::ProgramOrderBuffer& in_order_;
  std::vector<std::uint32_t> next_;
};

/// Expected notifications for the Program, independent of the drawing order.
std::vector<Notification> in_program_order(const isa::Program& program, std::optional<Opcode> reads_after_opcode) {
  std::vector<Notification> all;
  for (std::uint32_t segment = 0; segment < program.segments.size(); ++segment) {
    const std::vector<isa::Instruction>& instructions = program.segments[segment].instructions;
    for (std::uint32_t index = 0; index < instructions.size(); ++index) {
      all.push_back({segment, index, {}});
      if (instructions[index].opcode == reads_after_opcode) all.back().number = number_after(segment, index);
    }
    all.push_back({segment, {}, number_after(segment, instructions.size())});
  }
  return all;
}

}  // namespace

TEST_CASE("observers are notified in Program order with the pixels of that time") {
  CHECK(rc::check([] {
    const auto lengths = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 5U));
    std::vector<std::vector<isa::Instruction>> segments;
    segments.reserve(lengths.size());
    for (const std::uint32_t length : lengths) {
      segments.push_back(*rc::gen::container<std::vector<isa::Instruction>>(length, rc::gen::element(observed, other)));
    }
    const isa::Program program = program_of(segments);
    Witness reader(Opcode::enable_all);
    Witness only_ends(std::nullopt);
    engine::Observer* const observers[] = {&only_ends, &reader};
    cycle::ProgramOrderBuffer in_order(program, observers);
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
    RC_ASSERT(reader.notifications == in_program_order(program, Opcode::enable_all));
    RC_ASSERT(only_ends.notifications == in_program_order(program, std::nullopt));
  }));
}

TEST_CASE("events in Program order are forwarded at once without copies of the pixels") {
  const isa::Program program = program_of({{observed, other}, {observed}});
  Witness witness(Opcode::enable_all);
  engine::Observer* const observers[] = {&witness};
  cycle::ProgramOrderBuffer in_order(program, observers);
  SideBySide machine(program, in_order);
  std::size_t notifications = 0;
  for (const std::uint32_t segment : {0U, 0U, 0U, 1U, 1U}) {
    machine.proceed(segment);
    CHECK(witness.notifications.size() == ++notifications);
  }
  CHECK(machine.pixels.copies() == 0);
}

TEST_CASE("pixels of early events are copied only where observed and at segment ends") {
  const isa::Program program = program_of({{other}, {other, observed, other, other}});
  for (const auto& [reads_after_opcode, copies] :
       {std::pair{std::optional(Opcode::enable_all), 2U}, {std::optional<Opcode>(), 1U}}) {
    Witness witness(reads_after_opcode);
    engine::Observer* const observers[] = {&witness};
    cycle::ProgramOrderBuffer in_order(program, observers);
    SideBySide machine(program, in_order);
    for (int i = 0; i < 5; ++i) machine.proceed(1);
    CHECK(witness.notifications.empty());
    CHECK(machine.pixels.copies() == copies);
  }
}

TEST_CASE("events of a segment are forwarded from the time when all earlier segments ended") {
  const isa::Program program = program_of({{observed}, {observed, observed, observed}});
  Witness witness(Opcode::enable_all);
  engine::Observer* const observers[] = {&witness};
  cycle::ProgramOrderBuffer in_order(program, observers);
  SideBySide machine(program, in_order);
  machine.proceed(1);
  machine.proceed(0);
  machine.proceed(0);
  CHECK(witness.notifications.size() == 3);
  machine.proceed(1);
  CHECK(witness.notifications.back() == Notification{1, 1, number_after(1, 1)});
  CHECK(machine.pixels.copies() == 1);
}

TEST_CASE("an observer that reads pixels without declaring it causes an error") {
  struct Curious final : engine::Observer {
    [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
    void after_instruction(const engine::Step& /*step*/, const engine::PixelState& state) override {
      std::vector<std::uint64_t> words(2);
      state.read_enable(words);
    }
  } curious;
  engine::Observer* const observers[] = {&curious};
  const isa::Program program = program_of({{}, {other}});
  cycle::ProgramOrderBuffer held(program, observers);
  SideBySide ahead(program, held);
  CHECK_NOTHROW(ahead.proceed(1));
  CHECK_THROWS_AS(ahead.proceed(0), std::logic_error);
  cycle::ProgramOrderBuffer at_once(program, observers);
  SideBySide in_turn(program, at_once);
  CHECK_NOTHROW(in_turn.proceed(0));
  CHECK_THROWS_AS(in_turn.proceed(1), std::logic_error);
}
