#include "hw/pixel_square/stepped_datapath.h"

#include <algorithm>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/isa/operands.h"

namespace csgsim::pixel_square {

SteppedDatapath::SteppedDatapath(const division::ModelHeader& header, const division::ModelMemory& memory,
                                 const machines::Machine& machine, bool remote_planes, Callbacks callbacks)
    : Datapath(header),
      memory_(memory),
      machine_(machine),
      figures_(machines::kind_figures<Figures>(machine)),
      remote_planes_(remote_planes),
      callbacks_(std::move(callbacks)) {}

std::uint64_t SteppedDatapath::plane_clocks() const {
  if (!remote_planes_) return memory_.plane_words();
  return machine_.link.latency +
         std::uint64_t{quotient_up(memory_.plane_bits(), machine_.link.width)} * machine_.link.word_clocks;
}

division::PrimitiveHead SteppedDatapath::read_primitive(std::uint32_t primitive) {
  callbacks_.spend(memory_.primitive_words() + (level_ == Level::listed ? 1 : 0));
  return memory_.primitive(primitive);
}

division::Halfspace SteppedDatapath::read_halfspace(std::uint32_t primitive, std::uint32_t number) {
  read_ = memory_.halfspace_words() + (level_ == Level::listed ? 1 : 0);
  return memory_.halfspace(primitive, number);
}

division::Plane SteppedDatapath::read_plane(std::uint32_t index) {
  read_ += plane_clocks();
  return memory_.plane(index);
}

void SteppedDatapath::on_box() { callbacks_.spend(figures_.box_clocks); }

/// Reading the next half-space of a list overlaps with testing the current half-space.
void SteppedDatapath::on_corner_test(bool is_last) {
  const std::uint64_t test = figures_.halfspace_clocks;
  callbacks_.spend(testing_ ? std::max(read_, test) : read_);
  testing_ = !is_last;
  if (is_last) callbacks_.spend(test);
  if (level_ != Level::group && counts().halfspaces > figures_.halfspaces)
    callbacks_.spend(spilt_halfspace_clocks(figures_));
}

/// The first level has no memory for tested half-spaces, so it reads and tests them again.
void SteppedDatapath::on_cell(std::uint64_t halfspaces) {
  std::uint64_t each = figures_.cell_clocks;
  if (level_ == Level::group) {
    each += std::max(memory_.halfspace_words() + plane_clocks(), std::uint64_t{figures_.halfspace_clocks});
  } else if (counts().halfspaces > figures_.halfspaces) {
    each += spilt_halfspace_clocks(figures_);
  }
  callbacks_.spend(halfspaces * each);
}

void SteppedDatapath::on_node() {
  callbacks_.spend(figures_.node_clocks);
  if (counts().nodes > figures_.nodes) callbacks_.spend(spilt_node_clocks(figures_));
}

void SteppedDatapath::on_instruction(const isa::Instruction& instruction) {
  if (isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear))
    callbacks_.spend(figures_.linear_clocks);
  callbacks_.store_command(instruction);
}

}  // namespace csgsim::pixel_square
