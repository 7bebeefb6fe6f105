#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"
#include "hw/pixel_planes/timing.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/cycle/sequence.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/timed_machine.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

/// The array without the memory reserved for a second buffer of such colours.
isa::ArrayShape drawn_in(const machines::Machine& machine, std::uint32_t colour_bits) {
  isa::ArrayShape shape = machine.array;
  shape.memory_bits -= machines::second_buffer(colour_bits, machine).width;
  return shape;
}

/// Records the skips of a run and the picture of its last segment, if that fills the array.
class Drawing final : public engine::Observer {
 public:
  explicit Drawing(isa::Field colour) : colour_(colour) {}

  void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
    if (step.instruction.opcode == isa::Opcode::skip_if_none && step.enabled_pixels == 0)
      skips.push_back({step.segment, step.index});
  }
  void after_segment(std::uint32_t /*segment*/, const engine::PixelState& state) override {
    picture.resize(std::size_t{state.region().width} * state.region().height);
    if (colour_.width > 0) state.read_field(colour_, picture);
  }

  std::vector<machines::Skip> skips;
  std::vector<std::uint32_t> picture;

 private:
  isa::Field colour_;
};

/// Random frames that have either colours of equal width or none.
std::vector<isa::Program> arbitrary_frames(const machines::Machine& machine, unsigned instructions,
                                           const Allowed& allowed) {
  const auto widest = std::min(isa::max_field_width, machine.array.memory_bits / 2);
  const auto width = static_cast<std::uint16_t>(*rc::gen::inRange(1U, widest + 1));
  const bool coloured = *rc::gen::inRange(0, 4) > 0;
  const isa::ArrayShape shape = drawn_in(machine, coloured ? width : 0);
  std::vector<isa::Program> frames;
  for (int i = 0; i < 4; ++i) {
    const unsigned most = *rc::gen::inRange(0U, instructions + 1);
    isa::Program& frame = frames.emplace_back(
        first_allowed([&] { return *arbitrary_program(shape, most, machine.evaluator_degree); }, allowed));
    frame.facts->fields.clear();
    const auto base = static_cast<std::uint16_t>(*rc::gen::inRange(0U, shape.memory_bits - width + 1));
    frame.colour = coloured ? isa::Field{base, width} : isa::Field{};
  }
  return frames;
}

}  // namespace

bool planes_agree_in_sequences(const machines::Machine& machine, unsigned max_instructions,
                               systemc::EvaluatorForm evaluator, const Allowed& is_allowed) {
  const auto reference = engine::make_reference_engine(machine);
  return rc::check("consecutive frames are drawn and shown at the predicted clocks", [&] {
    const std::vector<isa::Program> programs = arbitrary_frames(machine, max_instructions, is_allowed);
    std::vector<Drawing> drawings;
    std::vector<pixel_planes::DrawnFrame> frames;
    std::vector<engine::Observer*> nobody;
    drawings.reserve(programs.size());
    engine::Observer unmoved;
    for (const isa::Program& program : programs) {
      engine::Observer* const drawing = &drawings.emplace_back(program.colour);
      reference->run(program, {&drawing, 1});
      frames.push_back({&program, drawings.back().skips});
      nobody.push_back(&unmoved);
    }
    const auto counted = cycle::run_sequence(machine, programs, nobody, evaluator);
    const auto expected = pixel_planes::time_sequence(frames, machine);
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (counted[i].clocks != expected[i].clocks || counted[i].account != expected[i].account)
        RC_FAIL(fmt::format("frame {}: predicted {} clocks, counted ", i, expected[i].clocks) + show(counted[i]));
      RC_ASSERT(is_account_complete(counted[i]));
      RC_ASSERT(counted[i].shown_clocks == std::max(expected[i].shown_clocks, expected[i].clocks));
      if (i + 1 < programs.size()) RC_ASSERT(counted[i].interval_clocks == expected[i].interval_clocks);
      if (!counted[i].scanned_out.empty()) RC_ASSERT(counted[i].scanned_out == drawings[i].picture);
    }
  });
}

bool planes_agree(const machines::Machine& machine, unsigned max_instructions, systemc::EvaluatorForm evaluator,
                  const Allowed& is_allowed) {
  const auto reference = engine::make_reference_engine(machine);
  TimedMachine hardware(machine, evaluator);
  const auto cycle = cycle::make_clocked_engine(machine, hardware);
  return rc::check("the clocked frame-buffer machine has the predicted bits, clocks, account and timeline", [&] {
    const isa::ArrayShape shape = drawn_in(machine, isa::max_field_width);
    const isa::Program program = first_allowed(
        [&] { return *arbitrary_program(shape, max_instructions, machine.evaluator_degree); }, is_allowed);
    const engine::RunResult expected = reference->run(program, {});
    const engine::RunResult counted = cycle->run(program, {});
    if (counted.clocks != expected.clocks || counted.account != expected.account) {
      RC_FAIL("counted " + show(counted) + "\npredicted " + show(expected));
    }
    RC_ASSERT(is_account_complete(counted));
    check_lockstep(*reference, *cycle, program, machine);
    hardware.check_timeline(program);
  });
}

}  // namespace csgsim::test
