#include "tests/fuzz/property.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "hw/base/text.h"

namespace csgsim::fuzz {

void broken(std::string_view invariant) {
  std::fprintf(stderr, "broken invariant: %s\n", std::string(invariant).c_str());
  std::abort();
}

void check_message(const InputError& error, std::string_view file) {
  const std::string_view message = error.what();
  require(!message.empty() && printable(message) == message, "a message is one line of printable text");
  require(file.empty() || message.starts_with(std::string(file) + ':'), "a message begins with its file's name");
}

}  // namespace csgsim::fuzz
