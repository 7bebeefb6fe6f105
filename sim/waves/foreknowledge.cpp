#include "sim/waves/foreknowledge.h"

#include "hw/isa/opcodes.h"

namespace csgsim::waves {

namespace {

class Watcher final : public engine::Observer {
 public:
  Watcher(const isa::Program& program, Foreknowledge& known) : program_(program), known_(known) {}

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }

  void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
    if (isa::needs_global_or(step.instruction.opcode)) known_.answers.push_back(step.enabled_pixels > 0);
  }

  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    const isa::Field colour = isa::frame_header(program_).colour;
    if (program_.segments.size() != 1 || colour.width == 0) return;
    const isa::Region& region = program_.segments[segment].region;
    known_.picture.resize(std::size_t{region.width} * region.height);
    state.read_field(colour, known_.picture);
  }

 private:
  const isa::Program& program_;
  Foreknowledge& known_;
};

}  // namespace

Foreknowledge gather_foreknowledge(const isa::Program& program, const machines::Machine& machine) {
  Foreknowledge known;
  Watcher watcher(program, known);
  engine::Observer* const watchers[] = {&watcher};
  known.result = engine::make_functional_engine(machine)->run(program, watchers);
  known.timeline = machines::timeline(program, machine, engine::run_outcome(known.result));
  return known;
}

}  // namespace csgsim::waves
