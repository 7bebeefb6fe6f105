#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace csgsim::test {

/// Reads the words of a row, KEY=NUMBER each, to where `known` says. Throws std::invalid_argument for what it does not
/// know.
void read_row(int count, char** words, const std::map<std::string, std::uint32_t*>& known);

/// What main of a test returns that draws so many Programs at most: 0 if they agree, 2 if an exception says why they
/// could not be drawn. RC_PARAMS overrides the seed and the number of Programs.
int exit_code_of(unsigned programs, const std::function<bool()>& agree);

}  // namespace csgsim::test
