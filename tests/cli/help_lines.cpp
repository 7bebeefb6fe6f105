#include "tests/cli/help_lines.h"

#include <sstream>

#include "tests/cli/cli.h"

namespace csgsim::testing::cli {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> commands() {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(run("--help").out)) {
    if (line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

std::vector<std::string> option_heads(const std::string& command) {
  std::vector<std::string> heads;
  for (const std::string& line : lines_of(run(command + " --help").out)) {
    if (line.starts_with("  -")) heads.push_back(line.substr(2, line.find("  ", 2) - 2));
  }
  return heads;
}

}  // namespace csgsim::testing::cli
