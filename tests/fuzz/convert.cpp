// CSG models converted to meshes.

#include <cstdint>
#include <map>

#include "host/read/read.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/surface.h"
#include "tests/fuzz/property.h"

namespace convert = csgsim::software::convert;
namespace fuzz = csgsim::fuzz;

namespace {

/// Limit of work, so that no case takes long.
constexpr std::uint64_t most_steps = 20'000'000;
constexpr std::size_t most_primitives = 60;

void check(const convert::Surface& surface) {
  std::map<convert::Side, int> sides;
  for (const convert::Triangle& triangle : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      fuzz::require(triangle[i] < surface.points.size(), "corners are indices of points");
      ++sides[{triangle[i], triangle[(i + 1) % 3]}];
    }
  }
  for (const auto& [side, times] : sides) {
    const auto back = sides.find({side[1], side[0]});
    fuzz::require(times == 1 && back != sides.end() && back->second == 1,
                  "each edge is shared by two faces in opposite directions");
  }
}

}  // namespace

/// Any bytes become a closed mesh or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const csgsim::Work work(most_steps);
    const csgsim::read::Options options{.work = work};
    const csgsim::model::Tree tree = csgsim::read::read_csg_text(fuzz::text_of(data, size), "fuzz.csg", options);
    if (tree.primitives.size() > most_primitives) return 0;
    check(convert::make_surface(convert::boundary(tree, {}, work)));
  } catch (const csgsim::WorkError&) {
    // The conversion exceeds the work limit.
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.csg");
  }
  return 0;
}
