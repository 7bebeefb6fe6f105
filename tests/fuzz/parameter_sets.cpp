// Files of parameter sets, as OpenSCAD's customizer saves them.

#include "sim/session/model/parameter_sets.h"

#include <string>
#include <string_view>

#include "tests/fuzz/property.h"
#include "tests/fuzz/scratch_file.h"

namespace fuzz = csgsim::fuzz;

/// Any bytes contain the set or give one line of error. A set is contained only if its name stands in the bytes, or an
/// escape sequence does, which may spell a letter of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  const std::string_view text = fuzz::text_of(data, size);
  const std::string file = folder.path() / "sets.json";
  fuzz::write_scratch(file, text);
  try {
    csgsim::session::require_parameter_set(file, "large");
    fuzz::require(text.find("\"large\"") != text.npos || text.find("\\u") != text.npos, "a found set is in the file");
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, file);
  }
  return 0;
}
