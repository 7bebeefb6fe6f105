#include "sim/engine/engine.h"

#include <memory>
#include <optional>

#include "hw/machines/clocks.h"
#include "sim/functional/array.h"

namespace csgsim::sim {

namespace {

/// What observers see of the array.
class ArrayState final : public PixelState {
 public:
  ArrayState(const Array& array, const isa::Region& region) : array_(array), region_(region) {}
  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    array_.read_field(field, values);
  }
  void read_enable(std::span<std::uint64_t> words) const override { array_.read_enable(words); }

 private:
  const Array& array_;
  isa::Region region_;
};

class FunctionalEngine final : public Engine {
 public:
  explicit FunctionalEngine(machines::Machine machine) : machine_(std::move(machine)) {}

  [[nodiscard]] std::string_view level() const override { return "functional"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    RunResult result;
    std::optional<Array> array;
    for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
      const isa::Segment& segment = program.segments[s];
      const isa::Region& region = segment.region;
      if (array && array->width() == region.width && array->rows() == region.height)
        array->clear();
      else
        array.emplace(region.width, 0, region.height, program.shape.memory_bits);

      const ArrayState state(*array, region);
      for (std::uint32_t i = 0; i < segment.instructions.size(); ++i) {
        const isa::Instruction& instruction = segment.instructions[i];
        const Step step{s, i, instruction, machines::clocks(instruction, machine_), array->enabled()};
        result.overflows += array->execute(instruction);
        result.clocks += step.clocks;
        if (instruction.opcode == isa::Opcode::global_or) result.answers.push_back(array->enabled() != 0);
        for (Observer* const observer : observers) observer->after_instruction(step, state);
      }
      for (Observer* const observer : observers) observer->after_segment(s, state);
    }
    result.latency_clocks = machines::evaluator_latency(machine_.array);
    result.clocks += result.latency_clocks;
    return result;
  }

 private:
  machines::Machine machine_;
};

}  // namespace

std::unique_ptr<Engine> make_functional_engine(const machines::Machine& machine) {
  return std::make_unique<FunctionalEngine>(machine);
}

}  // namespace csgsim::sim
