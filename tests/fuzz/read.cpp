#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "tests/unit/read/tree_invariants.h"

namespace {

[[noreturn]] void report(const std::string& what) {
  std::fprintf(stderr, "fuzz_read: %s\n", what.c_str());
  std::abort();
}

}  // namespace

/// Any bytes are either a tree that keeps its promises or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string broken = csgsim::read_test::broken_promise(csgsim::read::read_csg_text(text, "fuzz.csg"));
    if (!broken.empty()) report(broken);
  } catch (const csgsim::InputError& error) {
    const std::string_view message = error.what();
    if (!message.starts_with("fuzz.csg:")) report("a message without its file");
    for (const char letter : message) {
      if (letter < ' ' || letter > '~') report("a message that is not one line of plain text");
    }
  }
  return 0;
}
