#include <regex>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n");
  return end == std::string::npos ? std::string() : text.substr(0, end + 1);
}

/// The commit that cmake/commit.cmake finds for a source folder.
std::string find_commit(const Folder& folder, const std::string& source, const std::string& given) {
  const std::string output = folder / "commit.cpp";
  fs::remove(output);
  require_success(run_program("cmake", {"-DSOURCE=" + source, "-DCOMMIT=" + given, "-DOUTPUT=" + output, "-P",
                                        std::string(CSGSIM_SOURCE_DIR) + "/cmake/commit.cmake"}));
  std::smatch found;
  const std::string text = content(output);
  REQUIRE(std::regex_search(text, found, std::regex("commit = \"([^\"]*)\"")));
  return found[1];
}

}  // namespace

TEST_CASE("--version prints the version with its commit and the build and libraries") {
  const Outcome outcome = require_success(run("--version"));
  CHECK(outcome.err == "");
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  CHECK(std::regex_match(line, std::regex("csgsim \\d+\\.\\d+\\.\\d+")));
  std::getline(lines, line);
  CHECK(std::regex_match(line, std::regex("commit ([0-9a-f]{12}(\\+changes)?|[^ ]+), \\d{4}-\\d\\d-\\d\\d")));
  std::getline(lines, line);
  CHECK(std::regex_match(line, std::regex("build [0-9a-f]{16}")));
  std::getline(lines, line);
  CHECK(line.starts_with("built with SystemC "));
}

TEST_CASE("--version prints the library versions of pkg-config") {
  const std::string printed = run("--version").out;
  for (const auto& library : {std::pair<std::string, std::string>{"libpng", "libpng"},
                              {"zlib", "zlib"},
                              {"fmt", "fmt"},
                              {"pugixml", "pugixml"},
                              {"OpenImageIO", "OpenImageIO"},
                              {"HarfBuzz", "harfbuzz"},
                              {"libedit", "libedit"}}) {
    CAPTURE(library.first);
    const Outcome version = require_success(run_program("pkg-config", {"--modversion", library.second}));
    CHECK((printed + ",").find(" " + library.first + " " + trimmed(version.out)) != std::string::npos);
  }
}

TEST_CASE("the version has the sources' commit with a mark for changes or a given commit") {
  const Folder folder;
  const std::string source = folder / "source";
  fs::create_directory(source);
  write(source + "/CMakeLists.txt", "1");
  CHECK(find_commit(folder, source, "") == "unknown");
  CHECK(find_commit(folder, source, "0123abcd") == "0123abcd");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"init", "-q"},
        {"add", "."},
        {"-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false", "commit", "-qm", "one"}})
    require_success(run_program("git", words, source));
  const std::string head = trimmed(run_program("git", {"rev-parse", "HEAD"}, source).out);
  CHECK(find_commit(folder, source, "0123abcd") == head.substr(0, 12));
  write(source + "/CMakeLists.txt", "2");
  CHECK(find_commit(folder, source, "") == head.substr(0, 12) + "+changes");
  // A source archive that was unpacked inside another project's repository.
  fs::create_directory(source + "/inner");
  write(source + "/inner/CMakeLists.txt", "3");
  CHECK(find_commit(folder, source + "/inner", "") == "unknown");
}
