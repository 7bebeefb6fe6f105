#include <sys/wait.h>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string source = CSGSIM_SOURCE_DIR;

/// A command of the page with the output lines shown for it, in order; other lines may come between.
struct Shown {
  std::string command;
  std::vector<std::string> lines;
};

/// Reads the commands of a page: commands are indented, their output is between fences.
std::vector<Shown> commands_of(const std::string& page) {
  std::vector<Shown> all;
  bool is_fenced = false;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line == "```") {
      is_fenced = !is_fenced;
    } else if (is_fenced) {
      REQUIRE_FALSE(all.empty());
      all.back().lines.push_back(line);
    } else if (line.starts_with("    csgsim ")) {
      all.push_back({line.substr(4), {}});
    }
  }
  return all;
}

/// Runs a command in a folder laid out as the repository's root, with csgsim on the PATH.
Outcome in_shell(const Folder& root, const std::string& command) {
  write(root / "command.sh", "set -o pipefail\n" + command + "\n");
  const std::string shell =
      "cd " + root.path().string() + " && PATH=" + CSGSIM_BINARY_DIR + ":$PATH bash command.sh >out 2>err </dev/null";
  const int status = std::system(shell.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(root / "out"), content(root / "err")};
}

}  // namespace

namespace {

/// Runs a page's commands, checks that they print every line shown there, and returns the number of lines.
std::size_t check_page(const Folder& root, const std::string& page) {
  for (const std::string name : {"tests", "traces", "docs"})
    fs::create_symlink(fs::path(source) / name, root.path() / name);
  const std::vector<Shown> commands = commands_of(content(source + "/docs/" + page));
  CHECK(commands.size() >= 6);
  std::size_t lines = 0;
  for (const Shown& shown : commands) {
    CAPTURE(shown.command);
    const Outcome outcome = in_shell(root, shown.command);
    CAPTURE(outcome.err);
    CHECK(outcome.code == (outcome.err == "A and B differ\n" ? 1 : 0));
    std::size_t at = 0;
    for (const std::string& line : shown.lines) {
      CAPTURE(line);
      const std::size_t found = outcome.out.find(line, at);
      REQUIRE(found != std::string::npos);
      at = found + line.size();
      ++lines;
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("the commands of docs/debugging.md run as written and print the lines shown") {
  const Folder root;
  CHECK(check_page(root, "debugging.md") >= 60);
  const auto picture = [](const fs::path& folder, const std::string& name) {
    return content((folder / name).replace_extension(".png").string());
  };
  for (const std::string name : {"bracket", "bracket_owners", "bearing", "right", "wrong"}) {
    CAPTURE(name);
    CHECK(picture(root.path(), name) == picture(fs::path(source) / "docs/pictures/debugging", name));
  }
  CHECK(content(root / "fault.png") == content(root / "again.png"));
  CHECK(content(root / "z1.png").substr(1, 3) == "PNG");
}

TEST_CASE("docs/debugging.md lists the commands and stops of the debugger") {
  const Folder root;
  const std::string page = content(source + "/docs/debugging.md");
  write(root / "help", "help\n");
  std::istringstream help(run("debug " + source + "/tests/debugging/fig_2_3_fault.txt -x " + (root / "help")).out);
  std::size_t listed = 0;
  for (std::string line; std::getline(help, line);) {
    if (!line.starts_with("  ")) continue;
    const std::size_t gap = line.find("  ", 2);
    const std::string form = line.substr(2, gap - 2);
    const std::string meaning = line.substr(line.find_first_not_of(' ', gap));
    CAPTURE(form);
    CHECK(page.find("| `" + form + "` | " + meaning + " |\n") != std::string::npos);
    ++listed;
  }
  CHECK(listed > 20);
}
