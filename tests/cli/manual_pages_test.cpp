#include <stdlib.h>

#include "tests/cli/cli.h"
#include "tests/cli/help_lines.h"

using namespace csgsim::testing::cli;

namespace {

/// The page as man shows it, in lines long enough for every option.
std::string shown(const std::string& page) {
  ::setenv("MANWIDTH", "150", 1);
  ::setenv("LC_ALL", "C.UTF-8", 1);
  const Outcome outcome = require_success(run_program("man", {"--warnings", "-P", "cat", "-l", page}));
  CHECK(outcome.err == "");
  return outcome.out;
}

std::vector<std::string> pages() {
  std::vector<std::string> names{"csgsim.1"};
  for (const std::string& command : commands()) names.push_back("csgsim-" + command + ".1");
  return names;
}

}  // namespace

TEST_CASE("groff and mandoc accept the manual pages of the program and each command") {
  const Folder folder;
  require_success(run_words({"--describe", folder.path().string()}));
  REQUIRE(pages().size() >= 20);
  for (const std::string& page : pages()) {
    CAPTURE(page);
    REQUIRE(fs::exists(folder / page));
    const std::string text = shown(folder / page);
    CHECK(text.find("SYNOPSIS") != std::string::npos);
    const Outcome lint = run_program("mandoc", {"-Tlint", "-Wwarning", folder / page});
    CHECK(lint.out == "");
    CHECK(lint.code == 0);
  }
}

TEST_CASE("a command's page has every option of its help with the same value") {
  const Folder folder;
  require_success(run_words({"--describe", folder.path().string()}));
  const std::string all = shown(folder / "csgsim.1");
  for (const std::string& command : commands()) {
    CAPTURE(command);
    CHECK(all.find("csgsim-" + command + "(1)") != std::string::npos);
    const std::string page = shown(folder / ("csgsim-" + command + ".1"));
    const std::vector<std::string> heads = option_heads(command);
    REQUIRE(!heads.empty());
    for (const std::string& head : heads) {
      CAPTURE(head);
      CHECK(page.find("\n       " + head) != std::string::npos);
    }
    CHECK(page.find("EXAMPLES\n") != std::string::npos);
  }
}

TEST_CASE("manual pages are reproducible and an unwritable folder is reported") {
  const Folder folder;
  for (const std::string name : {"a", "b"}) REQUIRE(run_words({"--describe", folder / name}).code == 0);
  require_success(run_program("diff", {"-r", folder / "a", folder / "b"}));
  write(folder / "file", "");
  const Outcome outcome = run_words({"--describe", folder / "file/below"});
  CHECK(outcome.code == 1);
  CHECK(is_one_line(outcome.err));
}
