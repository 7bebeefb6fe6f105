#include "host/emit/layout.h"

#include <string>

#include "hw/isa/error.h"

namespace csgsim::emit {

Layout plan_layout(const Needs& needs, std::uint32_t memory_bits) {
  const unsigned total = 2 * needs.z_bits + needs.colour_bits + 1 + needs.stack_bits;
  if (total > memory_bits) {
    throw InputError("the picture needs " + std::to_string(total) + " memory bits a pixel (2 x " +
                     std::to_string(needs.z_bits) + " depth, " + std::to_string(needs.colour_bits) +
                     " colour, 1 mask, " + std::to_string(needs.stack_bits) + " stack) and the machine has " +
                     std::to_string(memory_bits) + "; give up depth with --z-bits, or take --memory-bits " +
                     std::to_string(total));
  }
  unsigned next = 0;
  const auto take = [&next](unsigned width) {
    const isa::Field field{static_cast<std::uint16_t>(next), static_cast<std::uint16_t>(width)};
    next += width;
    return field;
  };
  Layout layout;
  layout.depth = take(needs.z_bits);
  layout.candidate = take(needs.z_bits);
  layout.colour = take(needs.colour_bits);
  layout.mask = take(1);
  for (unsigned i = 0; i < needs.stack_bits; ++i) layout.stack.push_back(take(1));
  return layout;
}

std::vector<isa::NamedField> named_fields(const Layout& layout) {
  std::vector<isa::NamedField> fields{
      {"Z2", layout.depth, isa::FieldRole::depth},
      {"Z1", layout.candidate, isa::FieldRole::candidate_depth},
      {"colour", layout.colour, isa::FieldRole::colour},
      {"mask", layout.mask, isa::FieldRole::mask},
  };
  for (std::size_t i = 0; i < layout.stack.size(); ++i) {
    fields.push_back({"stack" + std::to_string(i), layout.stack[i], isa::FieldRole::stack});
  }
  return fields;
}

}  // namespace csgsim::emit
