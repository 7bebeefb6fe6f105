#include "hw/isa/program.h"

#include <algorithm>

#include "hw/base/indirect-inl.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"

namespace csgsim {

template class Indirect<isa::SegmentFacts>;
template class Indirect<isa::DivisionCounts>;
template class Indirect<isa::Preparation>;
template class Indirect<isa::Facts>;

}  // namespace csgsim

namespace csgsim::isa {

Field find_field(const Program& program, FieldRole role) {
  const auto found = std::find_if(program.facts->fields.begin(), program.facts->fields.end(),
                                  [role](const NamedField& named) { return named.role == role; });
  return found == program.facts->fields.end() ? Field{} : found->field;
}

FrameHeader frame_header(const Program& program) { return {program.shape, program.colour, program.background}; }

std::size_t total_instructions(const Program& program) {
  std::size_t count = 0;
  for (const Segment& segment : program.segments) count += segment.instructions.size();
  return count;
}

}  // namespace csgsim::isa
