#include "tests/lockstep/parts.h"

#include <rapidcheck.h>

#include <vector>

#include "hw/isa/validate.h"
#include "sim/cycle/clocked_engine.h"
#include "tests/lockstep/lockstep.h"

namespace csgsim::test {

namespace {

/// The colours of the pixels at the end of each segment; the background where a segment has no instructions.
class Picture final : public engine::Observer {
 public:
  explicit Picture(const isa::Program& program)
      : colours(std::size_t{program.shape.width} * program.shape.height), program_(program), colour_(program.colour) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }

  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    const isa::Region region = state.region();
    std::vector<std::uint32_t> values(std::size_t{region.width} * region.height, program_.background);
    if (!program_.segments[segment].instructions.empty()) state.read_field(colour_, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t y = region.y + i / region.width;
      colours[y * program_.shape.width + region.x + i % region.width] = values[i];
    }
  }

  std::vector<std::uint32_t> colours;

 private:
  const isa::Program& program_;
  isa::Field colour_;
};

}  // namespace

bool parts_agree(const std::string& what, const machines::Machine& machine,
                 const std::function<isa::Program()>& any_program,
                 const std::function<void(const isa::Program&, const TimedMachine&)>& check,
                 systemc::EvaluatorForm evaluator) {
  const auto reference = engine::make_reference_engine(machine);
  const auto functional = engine::make_functional_engine(machine);
  TimedMachine hardware(machine, evaluator);
  const auto cycle = cycle::make_clocked_engine(machine, hardware);
  return rc::check(what, [&] {
    const isa::Program program = any_program();
    isa::validate(program);
    const engine::RunResult counted = check_lockstep(*reference, *cycle, program, machine).engine;
    check(program, hardware);
    if (*rc::gen::inRange(0, 3) == 0) hardware.check_wave(program, *reference);
    Picture picture(program);
    engine::Observer* const observers[] = {&picture};
    const engine::RunResult expected = functional->run(program, observers);
    if (counted.clocks != expected.clocks || counted.account != expected.account) {
      RC_FAIL("counted " + show(counted) + "\npredicted " + show(expected));
    }
    RC_ASSERT(is_account_complete(counted));
    RC_ASSERT(counted.overflows == expected.overflows);
    if (program.colour.width == 0) {
      RC_ASSERT(counted.scanned_out.empty());
    } else {
      RC_ASSERT(counted.scanned_out == picture.colours);
    }
  });
}

}  // namespace csgsim::test
