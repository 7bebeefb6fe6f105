#include "hw/division/datapath.h"

namespace csgsim::division {

PrimitiveHead Datapath::visit_primitive(std::uint32_t primitive) {
  ++counts_.boxes;
  const PrimitiveHead head = read_primitive(primitive);
  on_box();
  return head;
}

std::vector<TestedHalfspace> Datapath::test(std::uint32_t primitive, std::span<const std::uint32_t> numbers,
                                            const Rectangle& pixels) {
  std::vector<TestedHalfspace> tested;
  if (numbers.empty()) return tested;
  ++counts_.lists;
  tested.reserve(numbers.size());
  for (const std::uint32_t number : numbers) {
    ++counts_.halfspaces;
    const Halfspace halfspace = read_halfspace(primitive, number);
    const Plane plane = read_plane(halfspace.plane);
    tested.push_back(test_corners(header_, {primitive, number, halfspace, plane}, pixels));
    on_corner_test(tested.size() == numbers.size());
  }
  return tested;
}

void Datapath::compare_with_leaders(std::uint64_t halfspaces) {
  counts_.cells += halfspaces;
  on_cell(halfspaces);
}

void Datapath::visit_node() {
  ++counts_.nodes;
  on_node();
}

void Datapath::write(const isa::Instruction& instruction) {
  ++counts_.instructions;
  on_instruction(instruction);
}

}  // namespace csgsim::division
