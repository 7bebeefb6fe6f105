// Drawings in DXF.

#include "host/flat/dxf.h"

#include "tests/fuzz/area_invariants.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;

/// Any bytes give a drawing or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fuzz::check_area(csgsim::flat::read_dxf(fuzz::text_of(data, size), {}));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
  return 0;
}
