// The text form of Programs.

#include "hw/isa/text.h"
#include "tests/fuzz/program_invariants.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;

/// Any bytes give a valid Program or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fuzz::check_program(csgsim::isa::parse(fuzz::text_of(data, size), "fuzz.csgt"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.csgt");
  }
  return 0;
}
