#include "hw/pixel_square/stepped_datapath.h"

#include <algorithm>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/isa/operands.h"

namespace csgsim::pixel_square {

SteppedDatapath::SteppedDatapath(const division::ModelHeader& header, const division::ModelMemory& memory,
                                 const machines::Machine& machine, bool far_planes, Ends ends)
    : Datapath(header),
      memory_(memory),
      machine_(machine),
      figures_(machines::own<Figures>(machine)),
      far_planes_(far_planes),
      ends_(std::move(ends)) {}

std::uint64_t SteppedDatapath::plane_clocks() const {
  if (!far_planes_) return memory_.plane_words();
  return machine_.link.latency +
         std::uint64_t{quotient_up(memory_.plane_bits(), machine_.link.width)} * machine_.link.word_clocks;
}

division::PrimitiveHead SteppedDatapath::read_primitive(std::uint32_t primitive) {
  ends_.spend(memory_.primitive_words() + (level_ == Level::listed ? 1 : 0));
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

void SteppedDatapath::on_box() { ends_.spend(figures_.box_clocks); }

/// The next half-space of a list is read while one is tested.
void SteppedDatapath::on_corner_test(bool is_last) {
  const std::uint64_t test = figures_.halfspace_clocks;
  ends_.spend(testing_ ? std::max(read_, test) : read_);
  testing_ = !is_last;
  if (is_last) ends_.spend(test);
  if (level_ != Level::group && counts().halfspaces > figures_.halfspaces)
    ends_.spend(spilt_halfspace_clocks(figures_));
}

/// The first level has no memory for what it has tested, and reads and tests it again.
void SteppedDatapath::on_cell(std::uint64_t halfspaces) {
  std::uint64_t each = figures_.cell_clocks;
  if (level_ == Level::group) {
    each += std::max(memory_.halfspace_words() + plane_clocks(), std::uint64_t{figures_.halfspace_clocks});
  } else if (counts().halfspaces > figures_.halfspaces) {
    each += spilt_halfspace_clocks(figures_);
  }
  ends_.spend(halfspaces * each);
}

void SteppedDatapath::on_node() {
  ends_.spend(figures_.node_clocks);
  if (counts().nodes > figures_.nodes) ends_.spend(spilt_node_clocks(figures_));
}

void SteppedDatapath::on_instruction(const isa::Instruction& instruction) {
  if (isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear))
    ends_.spend(figures_.linear_clocks);
  ends_.store_command(instruction);
}

}  // namespace csgsim::pixel_square
