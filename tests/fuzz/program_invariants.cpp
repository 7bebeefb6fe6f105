#include "tests/fuzz/program_invariants.h"

#include <sstream>

#include "hw/isa/binary.h"
#include "hw/isa/text.h"
#include "tests/fuzz/property.h"

namespace csgsim::fuzz {

void check_program(const isa::Program& program) {
  try {
    isa::validate(program);
    require(isa::decode(isa::encode(program), "again.csgt") == program, "the binary form is read as written");
    std::ostringstream text;
    isa::print(text, program);
    require(isa::parse(text.view(), "again.csgt") == program, "the text form is read as written");
  } catch (const InputError& error) {
    broken(error.what());
  }
}

}  // namespace csgsim::fuzz
