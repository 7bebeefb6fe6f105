#include "hw/isa/program.h"

#include <algorithm>

namespace csgsim::isa {

Field field_of(const Program& program, FieldRole role) {
  const auto found = std::find_if(program.fields.begin(), program.fields.end(),
                                  [role](const NamedField& named) { return named.role == role; });
  return found == program.fields.end() ? Field{} : found->field;
}

}  // namespace csgsim::isa
