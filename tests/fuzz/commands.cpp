// Models in the thesis's commands.

#include <string>

#include "host/commands/read.h"
#include "tests/fuzz/property.h"
#include "tests/unit/read/tree_invariants.h"

namespace fuzz = csgsim::fuzz;

namespace {

/// Work limit of a mutation, about a second.
constexpr std::uint64_t most_work = 20'000'000;

}  // namespace

/// Any bytes give a valid tree or one line of error, and so do the surfaces in them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  try {
    csgsim::read::Options options;
    options.work = csgsim::Work(most_work);
    const csgsim::model::Tree tree = csgsim::commands::read_text(text, "fuzz.jan", options);
    const std::string invariant = csgsim::read_test::broken_invariant(tree);
    fuzz::require(invariant.empty(), invariant);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.jan");
  }
  try {
    for (const csgsim::commands::NamedSurface& surface : csgsim::commands::read_surfaces(text, "fuzz.jan")) {
      fuzz::require(surface.tolerance > 0, "a tolerance is positive");
      fuzz::require(surface.location.line > 0, "a surface has a position");
    }
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.jan");
  }
  return 0;
}
