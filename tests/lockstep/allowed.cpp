#include <rapidcheck.h>

#include "tests/lockstep/agree.h"

namespace csgsim::test {

isa::Program first_allowed(const std::function<isa::Program()>& any_program, const Allowed& allowed) {
  constexpr int most_tried = 50;
  for (int i = 0; i < most_tried; ++i) {
    isa::Program program = any_program();
    if (allowed(program)) return program;
  }
  RC_DISCARD("no Program is allowed");
}

}  // namespace csgsim::test
