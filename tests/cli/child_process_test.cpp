#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "hw/base/address_sanitizer.h"
#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string program = std::string(CSGSIM_BINARY_DIR) + "/csgsim";

/// Draws source with a stand-in for OpenSCAD; terminated after a minute, with code 124.
Outcome draw_source(const std::string& commands, const std::vector<std::string>& more = {}) {
  const Folder folder;
  write_stand_in(folder, "openscad", commands);
  write(folder / "part.scad", "// whatever\n");
  std::vector<std::string> words{"--kill-after=1", "60",     "env",  path_argument(folder), program, "render",
                                 "part.scad",      "--size", "16x16"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program("timeout", words, folder.path());
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// Waits up to 10 seconds for the condition and returns whether it holds.
template <class Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return condition();
}

/// The numbers in a file, one for each complete line.
std::vector<pid_t> numbers_in(const std::string& file) {
  std::istringstream text(content(file));
  std::vector<pid_t> numbers;
  for (std::string line; std::getline(text, line) && !text.eof();) numbers.push_back(std::stoi(line));
  return numbers;
}

bool is_running(pid_t process) {
  // If the process ends after its file was opened, reading returns nothing.
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string status;
  std::getline(file, status);
  // A zombie has ended, though its parent has not waited for it yet.
  return !status.empty() && !contains(status, ") Z ");
}

/// Starts a csgsim that draws the source in the folder.
pid_t begin_drawing(const Folder& folder) {
  const pid_t process = ::fork();
  REQUIRE(process >= 0);
  if (process != 0) return process;
  const std::string path = path_argument(folder).substr(5);
  ::setenv("PATH", path.c_str(), 1);
  ::setpgid(0, 0);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, number);
  if (::chdir(folder.path().c_str()) == 0)
    ::execl(program.c_str(), "csgsim", "render", "part.scad", "--size", "16x16", nullptr);
  std::_Exit(127);
}

}  // namespace

TEST_CASE("ending csgsim by any signal also ends its child processes") {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGKILL}) {
    for (const bool is_group : {false, true}) {
      CAPTURE(signal);
      CAPTURE(is_group);
      const Folder folder;
      write_stand_in(folder, "openscad", "sleep 300 & echo $! > numbers; echo $$ >> numbers; wait; sleep 300");
      write(folder / "part.scad", "// whatever\n");
      const pid_t process = begin_drawing(folder);
      CHECK(comes_true([&] { return numbers_in(folder / "numbers").size() == 2; }));
      const std::vector<pid_t> numbers = numbers_in(folder / "numbers");
      ::kill(is_group ? -process : process, signal);
      ::waitpid(process, nullptr, 0);
      for (const pid_t number : numbers) {
        CHECK(comes_true([&] { return !is_running(number); }));
        ::kill(number, SIGKILL);
      }
    }
  }
}

TEST_CASE("csgsim terminates and reports an OpenSCAD that prints more than the limit") {
  const Outcome outcome = draw_source("exec yes 'ECHO: \"much\"' >&2");
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(outcome.err ==
        "part.scad: OpenSCAD was stopped: it wrote more than 16 MiB of messages; move its echo() out of loops\n");
}

TEST_CASE("csgsim terminates and reports an OpenSCAD that runs longer than the limit") {
  const Outcome outcome = draw_source("sleep 300", {"--openscad-time", "1"});
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(outcome.err ==
        "part.scad: OpenSCAD was stopped: it did not finish within 1 s; simplify the model, or allow more time with "
        "--openscad-time SECONDS\n");
}

TEST_CASE("OpenSCAD is limited to 8 GiB of memory or to a lower limit of csgsim") {
  const std::string tells = "echo \"WARNING: $(ulimit -v)\" >&2; echo 'cube(size = [8, 6, 4]);'";
  CHECK(draw_source(tells).err == "openscad: WARNING: 8388608\n");
  const Folder folder;
  write_stand_in(folder, "openscad", tells);
  write(folder / "part.scad", "// whatever\n");
  const Outcome less = run_program("sh",
                                   {"-c", "ulimit -v 4000000 && exec env " + path_argument(folder) + " " + program +
                                              " render part.scad --size 16x16"},
                                   folder.path());
  // The sanitizer's own memory exceeds this limit.
  if (CSGSIM_ADDRESS_SANITIZER == 0) CHECK(less.err == "openscad: WARNING: 4000000\n");
}

TEST_CASE("OpenSCAD inherits no open file except the standard streams") {
  // The shell also has its script open. A pipe would be one more open file, so a temporary file holds the links.
  const Outcome outcome = require_success(
      draw_source("links=$(mktemp); readlink /proc/$$/fd/* > $links; sed 's/^/WARNING: /' $links >&2; rm $links; "
                  "echo 'cube(size = [8, 6, 4]);'"));
  int files = 0;
  std::istringstream lines(outcome.err);
  for (std::string line; std::getline(lines, line);) files += contains(line, "/openscad") ? 0 : 1;
  CAPTURE(outcome.err);
  CHECK(files == 3);
}
