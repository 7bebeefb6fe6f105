#include "tests/support/bare_text.h"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

#include "hw/isa/facts.h"
#include "hw/isa/text.h"

namespace csgsim::testing {

std::string bare_text(isa::Program program) {
  program.facts->fields.clear();
  std::ostringstream text;
  isa::print(text, program);
  const std::regex comment(R"( *[;#].*)");
  const std::regex facts(R"( (primitives|halfspaces|kept_primitives|kept_halfspaces|comparisons)=\d+)");
  std::istringstream lines(text.str());
  std::string bare;
  for (std::string line; std::getline(lines, line);) {
    const bool is_fact =
        std::ranges::any_of(std::array{".depth", ".model", ".compile", ".field", ".primitive", ".pruning"},
                            [&](const char* directive) { return line.starts_with(directive); });
    if (is_fact) continue;
    const bool is_segment = line.starts_with(".segment");
    line = std::regex_replace(line, comment, "");
    bare += (is_segment ? std::regex_replace(line, facts, "") : line) + "\n";
  }
  return bare;
}

}  // namespace csgsim::testing
