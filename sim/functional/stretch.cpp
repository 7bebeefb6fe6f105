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
  find_wakes();
}

void Stretch::find_end(std::span<const isa::Instruction> instructions) {
  looked_at_.reserve(instructions.size());
  bool ends = false;
  while (!ends && looked_at_.size() < instructions.size()) {
    const isa::Instruction& instruction = instructions[looked_at_.size()];
    ends = instruction.opcode == isa::Opcode::skip_if_none;
    bool looked_at = false;
    for (const engine::Observer* const one : observers_) {
      if (!one->reads_after(instruction)) continue;
      (one->reads_enable_alone(instruction) ? looked_at : ends) = true;
    }
    looked_at_.push_back(looked_at ? 1 : 0);
  }
  instructions_ = instructions.first(looked_at_.size());
}

void Stretch::find_wakes() {
  wakes_.resize(size() + 1);
  auto next = static_cast<std::uint32_t>(size());
  wakes_.back() = next;
  for (std::uint32_t i = next; i-- > 0;) {
    if (isa::acts_on_disabled(instructions_[i].opcode)) next = i;
    wakes_[i] = next;
  }
}

void Stretch::show(std::size_t index, const isa::Region& part, std::span<const std::uint64_t> words) const {
  for (engine::Observer* const one : observers_)
    if (one->reads_enable_alone(instructions_[index])) one->enabled_after(instructions_[index], part, words);
}

}  // namespace csgsim::functional
