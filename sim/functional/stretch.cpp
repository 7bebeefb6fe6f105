#include "sim/functional/stretch.h"

#include <algorithm>

#include "hw/isa/opcodes.h"

namespace csgsim::functional {

namespace {

constexpr std::size_t most_instructions = 1024;

}  // namespace

Stretch::Stretch(std::span<const isa::Instruction> instructions, std::span<engine::Observer* const> observers)
    : observers_(observers) {
  find_end(instructions.first(std::min(instructions.size(), most_instructions)));
  find_first_acting();
}

void Stretch::find_end(std::span<const isa::Instruction> instructions) {
  observed_.reserve(instructions.size());
  bool ends = false;
  while (!ends && observed_.size() < instructions.size()) {
    const isa::Instruction& instruction = instructions[observed_.size()];
    ends = instruction.opcode == isa::Opcode::skip_if_none;
    bool reads_enable = false;
    for (const engine::Observer* const one : observers_) {
      if (!one->reads_after(instruction)) continue;
      (one->reads_enable_alone(instruction) ? reads_enable : ends) = true;
    }
    observed_.push_back(reads_enable ? 1 : 0);
  }
  instructions_ = instructions.first(observed_.size());
}

void Stretch::find_first_acting() {
  first_acting_.resize(size() + 1);
  auto next = static_cast<std::uint32_t>(size());
  first_acting_.back() = next;
  for (std::uint32_t i = next; i-- > 0;) {
    if (isa::acts_on_disabled(instructions_[i].opcode)) next = i;
    first_acting_[i] = next;
  }
}

void Stretch::notify_observers(std::size_t instruction_index, const isa::Region& part,
                               std::span<const std::uint64_t> enable_words) const {
  for (engine::Observer* const one : observers_)
    if (one->reads_enable_alone(instructions_[instruction_index]))
      one->enabled_after(instructions_[instruction_index], part, enable_words);
}

}  // namespace csgsim::functional
