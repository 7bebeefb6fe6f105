#include <utility>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"
#include "sim/reference/reference_array.h"

namespace csgsim::sim {

namespace {

class ReferenceEngine final : public Engine {
 public:
  explicit ReferenceEngine(machines::Machine machine) : machine_(std::move(machine)) {}

  [[nodiscard]] std::string_view level() const override { return "reference"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    RunResult result;
    std::vector<machines::Skip> skips;
    for (std::size_t s = 0; s < program.segments.size(); ++s) run_segment(program, s, observers, result, skips);
    put(machines::time_frame(program, machine_, skips), result);
    return result;
  }

 private:
  void run_segment(const isa::Program& program, std::size_t s, std::span<Observer* const> observers, RunResult& result,
                   std::vector<machines::Skip>& skips) const {
    const isa::Segment& segment = program.segments[s];
    const auto number = static_cast<std::uint32_t>(s);
    ReferenceArray array(segment.region, program.shape.memory_bits);
    for (std::size_t index = 0; index < segment.instructions.size(); ++index) {
      const isa::Instruction& instruction = segment.instructions[index];
      const std::uint64_t enabled = array.enabled_pixels();
      const std::uint64_t clocks = machines::clocks(instruction, machine_);
      array.execute(instruction);
      if (instruction.opcode == isa::Opcode::global_or) result.answers.push_back(enabled > 0);
      const Step step{number, static_cast<std::uint32_t>(index), instruction, clocks, enabled};
      for (Observer* observer : observers) observer->after_instruction(step, array);
      if (instruction.opcode == isa::Opcode::skip_if_none && enabled == 0) {
        skips.push_back({number, static_cast<std::uint32_t>(index)});
        index += instruction.constant;
        result.skipped += instruction.constant;
      }
    }
    result.overflows += array.overflows();
    for (Observer* observer : observers) observer->after_segment(number, array);
  }

  machines::Machine machine_;
};

}  // namespace

std::unique_ptr<Engine> make_reference_engine(const machines::Machine& machine) {
  return std::make_unique<ReferenceEngine>(machine);
}

}  // namespace csgsim::sim
