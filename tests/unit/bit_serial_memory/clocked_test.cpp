#include "tests/unit/bit_serial_memory/clocked.h"

#include <rapidcheck.h>

#include <systemc>

#include "hw/isa/opcodes.h"
#include "hw/machines/kind.h"
#include "hw/systemc/kernel.h"
#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

// Random Programs on memories in SystemC. Every instruction is compared with the reference, and clocks, account and
// timeline with those calculated without stepping.

using namespace csgsim;
using testing::ClockedMemory;

namespace {

constexpr std::uint32_t widest = isa::max_field_width;

/// Enable bits and memory as one list of words.
std::vector<std::uint64_t> reference_pixels(const reference::ReferenceArray& array, const isa::ArrayShape& shape) {
  std::vector<std::uint64_t> words(std::size_t{(shape.width + 63) / 64} * shape.height);
  array.read_enable(words);
  std::vector<std::uint32_t> values(std::size_t{shape.width} * shape.height);
  for (std::uint32_t base = 0; base < shape.memory_bits; base += widest) {
    const isa::Field field{static_cast<std::uint16_t>(base),
                           static_cast<std::uint16_t>(std::min(widest, shape.memory_bits - base))};
    array.read_field(field, values);
    words.insert(words.end(), values.begin(), values.end());
  }
  return words;
}

std::vector<std::uint64_t> pixels_of_view(const systemc::PixelView& view, const isa::ArrayShape& shape) {
  // Every bit starts as 1, so that a bit which the reads do not overwrite is detected.
  std::vector<std::uint64_t> words(std::size_t{(shape.width + 63) / 64} * shape.height, ~std::uint64_t{0});
  view.read_enable(shape.width, shape.height, words);
  std::vector<std::uint32_t> values(std::size_t{shape.width} * shape.height, ~std::uint32_t{0});
  for (std::uint32_t base = 0; base < shape.memory_bits; base += widest) {
    const isa::Field field{static_cast<std::uint16_t>(base),
                           static_cast<std::uint16_t>(std::min(widest, shape.memory_bits - base))};
    view.read_field(field, shape.width, shape.height, values);
    words.insert(words.end(), values.begin(), values.end());
  }
  return words;
}

/// Follows a run with the reference and stores the differences.
class Follower final : public systemc::RunListener {
 public:
  Follower(const isa::Program& program, const machines::Machine& machine)
      : program_(program), machine_(machine), period_(systemc::period_of(machine)), start_(edge()) {}

  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) override {
    const isa::Instruction& instruction = program_.segments[retired.segment].instructions[retired.index];
    const std::string at = fmt::format("s{} i{} {}", retired.segment, retired.index, isa::name_of(instruction.opcode));
    begin_segment(retired.segment);
    expect(retired.index == next_, at + ": instruction index");
    expect(retired.enabled_pixels == judge_->enabled_pixels(), at + ": enabled pixels");
    judge_->execute(instruction);
    const bool none = judge_->enabled_pixels() == 0;
    if (instruction.opcode == isa::Opcode::global_or) answers.push_back(!none);
    const bool skips = none && instruction.opcode == isa::Opcode::skip_if_none;
    expect(retired.skipped == (skips ? instruction.constant : 0), at + ": number of skipped instructions");
    if (retired.skipped > 0) reported_skips.push_back({retired.segment, retired.index});
    skipped += retired.skipped;
    next_ = static_cast<std::uint32_t>(retired.index + 1 + retired.skipped);
    expect(retired.clocks == machine_.kind->clocks(instruction, machine_), at + ": clocks");
    ends.push_back({retired.segment, retired.index, edge() - start_ - 1});
    if (copied_ != nullptr) {
      expect(pixels_of_view(*copied_, program_.shape) == copied_pixels_, at + ": copy of the previous pixels");
      expect(pixels_of_view(*copied_->copy(), program_.shape) == copied_pixels_, at + ": copy of the copied pixels");
    }
    const std::vector<std::uint64_t> expected = reference_pixels(*judge_, program_.shape);
    expect(pixels_of_view(pixels, program_.shape) == expected, at + ": pixels");
    copied_ = pixels.copy();
    copied_pixels_ = expected;
  }

  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels) override {
    begin_segment(segment);
    expect(next_ == program_.segments[segment].instructions.size(),
           fmt::format("s{}: ends before its last instruction", segment));
    expect(pixels_of_view(pixels, program_.shape) == reference_pixels(*judge_, program_.shape),
           fmt::format("s{}: pixels at its end", segment));
    ++segments;
  }

  [[nodiscard]] std::vector<std::uint32_t> picture() const {
    if (program_.colour.width == 0) return {};
    const std::size_t size = std::size_t{program_.shape.width} * program_.shape.height;
    const bool drawn =
        std::ranges::any_of(program_.segments, [](const isa::Segment& one) { return !one.instructions.empty(); });
    std::vector<std::uint32_t> values(size, program_.background);
    if (drawn) judge_->read_field(program_.colour, values);
    return values;
  }

  struct End {
    std::uint32_t segment = 0;
    std::uint32_t index = 0;
    std::uint64_t clock = 0;  ///< first clock after the instruction
  };

  std::vector<std::string> differences;
  std::vector<bool> answers;
  std::vector<machines::Skip> reported_skips;
  std::vector<End> ends;
  std::uint64_t skipped = 0;
  std::uint32_t segments = 0;

 private:
  [[nodiscard]] std::uint64_t edge() const { return sc_core::sc_time_stamp().value() / period_.value(); }

  void expect(bool holds, const std::string& what) {
    if (!holds) differences.push_back(what);
  }

  void begin_segment(std::uint32_t segment) {
    if (segment_ == segment) return;
    expect(segment == (segment_ ? *segment_ + 1 : 0), fmt::format("s{}: starts out of order", segment));
    segment_ = segment;
    next_ = 0;
    judge_ = std::make_unique<reference::ReferenceArray>(program_.shape);
  }

  const isa::Program& program_;
  const machines::Machine& machine_;
  const sc_core::sc_time period_;
  const std::uint64_t start_;
  std::optional<std::uint32_t> segment_;
  std::uint32_t next_ = 0;
  std::unique_ptr<reference::ReferenceArray> judge_;
  std::unique_ptr<const systemc::PixelView> copied_;
  std::vector<std::uint64_t> copied_pixels_;
};

void check_account(const machines::Account& account, const machines::Account& expected) {
  for (std::size_t i = 0; i < expected.counts.size(); ++i) {
    CAPTURE(expected.counts[i].name);
    CHECK(account.counts[i].value == expected.counts[i].value);
  }
  for (std::size_t i = 0; i < expected.parts.size(); ++i) {
    for (std::size_t k = 0; k < expected.parts[i].clocks.size(); ++k) {
      CAPTURE(std::string(expected.parts[i].clocks[k].activity));
      CHECK(account.parts[i].clocks[k].clocks == expected.parts[i].clocks[k].clocks);
    }
  }
  CHECK(account == expected);
}

void check_timeline(const Follower& follower, const isa::Program& program, const machines::Machine& machine) {
  const std::optional<machines::Timeline> timeline = machine.kind->timeline(program, machine, follower.reported_skips);
  REQUIRE(timeline.has_value());
  std::vector<std::vector<bool>> carried_out;
  for (const isa::Segment& segment : program.segments) carried_out.emplace_back(segment.instructions.size());
  for (const Follower::End& end : follower.ends) {
    CAPTURE(end.segment);
    CAPTURE(end.index);
    CHECK(timeline->issued[end.segment][end.index].end == end.clock);
    carried_out[end.segment][end.index] = true;
  }
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    CHECK(machine.kind->spans_at_pixel(*timeline, program, machine, s, 1, 1) == timeline->issued[s]);
    for (std::size_t i = 0; i < carried_out[s].size(); ++i)
      CHECK((timeline->issued[s][i] == machines::ClockSpan{}) == !carried_out[s][i]);
  }
}

void check_run(const ClockedMemory& memory, const isa::Program& program) {
  Follower follower(program, memory.machine);
  const systemc::RunReport report = memory.hardware->run(program, follower);
  const std::string differences = fmt::format("{}", fmt::join(follower.differences, "; "));
  CHECK(differences == "");
  CHECK(follower.segments == program.segments.size());
  CHECK(report.answers == follower.answers);
  CHECK(report.skipped == follower.skipped);
  CHECK(report.picture == follower.picture());
  const machines::FrameTiming timing = memory.machine.kind->time(program, memory.machine, follower.reported_skips);
  CHECK(report.clocks == timing.clocks);
  CHECK(report.shown_clocks == timing.shown_clocks);
  CHECK(report.interval_clocks == timing.shown_clocks);
  CHECK(report.latency_clocks == 0);
  check_account(report.account, timing.account);
  check_timeline(follower, program, memory.machine);
}

isa::Program random_frame(const ClockedMemory& memory, std::uint64_t seed) {
  constexpr std::size_t instructions = 14;
  constexpr int size = 60;
  const auto draw = [&](std::uint64_t number) {
    return test::arbitrary_program_in_parts(memory.machine, instructions, memory.machine.evaluator_degree)(
               rc::Random(number), size)
        .value();
  };
  isa::Program program = draw(2 * seed);
  const isa::Instruction query{.opcode = isa::Opcode::global_or};
  if (seed % 3 == 0) program.segments.front().instructions.push_back(query);
  // The machine accepts any number of segments; each begins with memory and enable 0.
  if (seed % 4 == 0) program.segments.push_back(draw(2 * seed + 1).segments.front());
  return program;
}

isa::Program short_program(const machines::Machine& machine, std::vector<isa::Instruction> instructions) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, machine.array.memory_bits};
  program.segments.push_back(
      {.region = {0, 0, program.shape.width, program.shape.height}, .instructions = std::move(instructions)});
  return program;
}

}  // namespace

TEST_CASE("a clocked memory matches the reference's pixels and the calculated clocks") {
  constexpr std::uint64_t programs = 12;
  for (std::size_t i = 1; i < testing::clocked_memories().size(); ++i) {
    const ClockedMemory& memory = testing::clocked_memories()[i];
    CAPTURE(memory.name);
    for (std::uint64_t seed = 1; seed <= programs; ++seed) {
      CAPTURE(seed);
      check_run(memory, random_frame(memory, 100 * i + seed));
    }
  }
}

TEST_CASE("a skip without enabled pixels jumps to any later instruction or frame end") {
  using isa::Opcode;
  const isa::Instruction invert{.opcode = Opcode::enable_invert};
  const isa::Instruction all{.opcode = Opcode::enable_all};
  const isa::Instruction set{.opcode = Opcode::set_constant, .fields = {{{0, 6}}}, .constant = 37};
  for (const ClockedMemory& memory : testing::clocked_memories()) {
    CAPTURE(memory.name);
    for (std::uint64_t count = 1; count <= 9; ++count) {
      CAPTURE(count);
      const isa::Instruction skip{.opcode = Opcode::skip_if_none, .constant = count};
      std::vector<isa::Instruction> instructions{all, skip, set, invert, skip};
      instructions.insert(instructions.end(), count, set);  // up to the end: FrameEnd comes next
      check_run(memory, short_program(memory.machine, instructions));
      instructions.insert(instructions.end(), {all, set, invert, skip});
      instructions.insert(instructions.end(), count, all);
      instructions.push_back({.opcode = Opcode::global_or});
      isa::Program program = short_program(memory.machine, instructions);
      program.colour = {2, 5};
      check_run(memory, program);
      // The same skip, but to the start of a second segment.
      program.segments.push_back(program.segments.front());
      program.segments.front().instructions.resize(5 + count);
      check_run(memory, program);
    }
  }
}

TEST_CASE("an empty frame shows the background and takes no scan-out clocks") {
  for (const ClockedMemory& memory : testing::clocked_memories()) {
    CAPTURE(memory.name);
    isa::Program program = short_program(memory.machine, {});
    program.colour = {1, 4};
    program.background = 9;
    check_run(memory, program);
    systemc::RunListener no_listener;
    const systemc::RunReport report = memory.hardware->run(program, no_listener);
    CHECK(report.shown_clocks == report.clocks);
    const std::size_t pixels = std::size_t{program.shape.width} * program.shape.height;
    CHECK(report.picture == std::vector<std::uint32_t>(pixels, 9));
    // A single instruction makes the machine show the pixels, which are 0.
    program.segments.front().instructions.push_back({.opcode = isa::Opcode::enable_all});
    check_run(memory, program);
    CHECK(memory.hardware->run(program, no_listener).picture == std::vector<std::uint32_t>(pixels, 0));
    // An instruction in one of two segments is enough.
    program.segments.insert(program.segments.begin(), {.region = program.segments.front().region, .instructions = {}});
    check_run(memory, program);
  }
}

TEST_CASE("a memory rejects a Program of another picture size or with more pixel memory") {
  const ClockedMemory& memory = testing::smallest_memory();
  const isa::Program fitting = short_program(memory.machine, {{.opcode = isa::Opcode::enable_all}});
  systemc::RunListener no_listener;
  const auto refusal = [&](isa::ArrayShape shape) {
    isa::Program program = fitting;
    program.shape = shape;
    return testing::error_of([&] { memory.hardware->run(program, no_listener); });
  };
  const std::string refused =
      "the Program needs another picture size or more pixel memory than the machine has; compile it for this machine";
  CHECK(refusal({8, 8, 8}) == "");
  CHECK(refusal({8, 8, 7}) == "");
  CHECK(refusal({8, 8, 9}) == refused);
  CHECK(refusal({7, 8, 8}) == refused);
  CHECK(refusal({9, 8, 8}) == refused);
  CHECK(refusal({8, 7, 8}) == refused);
  CHECK(refusal({8, 9, 8}) == refused);
}

TEST_CASE("after a listener's exception ends a run the next frame matches the reference") {
  class Thrower final : public systemc::RunListener {
   public:
    void after_instruction(const systemc::Retired& /*retired*/, const systemc::PixelView& /*pixels*/) override {
      throw std::runtime_error("enough");
    }
  };
  for (const ClockedMemory& memory : testing::clocked_memories()) {
    const isa::Program program =
        short_program(memory.machine, {{.opcode = isa::Opcode::enable_all}, {.opcode = isa::Opcode::enable_invert}});
    Thrower thrower;
    CHECK_THROWS_WITH_AS(memory.hardware->run(program, thrower), "enough", std::runtime_error);
    check_run(memory, program);
  }
}
