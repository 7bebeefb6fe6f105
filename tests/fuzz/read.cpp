// CSG models in OpenSCAD's format.

#include "host/read/read.h"

#include <algorithm>
#include <string>

#include "tests/fuzz/property.h"
#include "tests/unit/read/tree_invariants.h"

namespace fuzz = csgsim::fuzz;

/// Any bytes give a valid tree or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const csgsim::model::Tree tree = csgsim::read::read_csg_text(fuzz::text_of(data, size), "fuzz.csg");
    const std::string invariant = csgsim::read_test::broken_invariant(tree);
    fuzz::require(invariant.empty(), invariant);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.csg");
    const bool has_strings = fuzz::text_of(data, size).find('"') != std::string_view::npos;
    const std::string_view message = error.what();
    fuzz::require(
        has_strings || std::ranges::all_of(message, [](char letter) { return letter >= ' ' && letter <= '~'; }),
        "a message of the reader is ASCII, but for strings of the file");
  }
  return 0;
}
