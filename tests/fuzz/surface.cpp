// Heights for surface(), as numbers and as pixels.

#include "host/solids/surface.h"

#include "host/solids/limits.h"
#include "tests/fuzz/mesh_invariants.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace solids = csgsim::solids;

namespace {

template <class Read>
void check(Read read) {
  try {
    fuzz::check_mesh(read(), solids::double_precision_tolerance);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
}

}  // namespace

/// Any bytes give a surface or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  check([&] { return solids::parse_surface(text, "m", true); });
  check([&] { return solids::parse_surface_png(text, "m", false, false); });
  return 0;
}
