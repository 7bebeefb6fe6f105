#include "tests/lockstep/row.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "tests/support/properties.h"

namespace csgsim::test {

void read_row(int count, char** words, const std::map<std::string, std::uint32_t*>& variables) {
  testing::begin_program(count, words);
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const std::size_t equals = word.find('=');
    const auto setting = variables.find(word.substr(0, equals));
    if (equals == word.npos || setting == variables.end()) throw std::invalid_argument("what is " + word + "?");
    *setting->second = static_cast<std::uint32_t>(std::stoul(word.substr(equals + 1)));
  }
}

int property_exit_code(unsigned program_count, const std::function<bool()>& programs_agree) {
  testing::add_parameters(fmt::format("max_success={}", program_count));
  return programs_agree() ? 0 : 1;
}

}  // namespace csgsim::test
