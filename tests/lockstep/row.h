#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace csgsim::test {

/// Reads the words of a row, KEY=NUMBER each, into the variables in `known`. Throws std::invalid_argument for an
/// unknown key.
void read_row(int count, char** words, const std::map<std::string, std::uint32_t*>& variables);

/// Exit code for main of a test that draws at most `programs` Programs: 0 if they agree, 2 if an exception is reported.
/// RC_PARAMS overrides the seed and the number of Programs.
int property_exit_code(unsigned program_count, const std::function<bool()>& programs_agree);

}  // namespace csgsim::test
