#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string binary() { return std::string(CSGSIM_BINARY_DIR) + "/csgsim"; }

/// Exit code of a shell command; -1 if a signal ended it.
int shell(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) < 128 ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("an unwritable standard error does not change the exit code") {
  for (const std::string redirection : {"2>/dev/full", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    CAPTURE(redirection);
    CHECK(shell(binary() + " render none.csg " + redirection) == 1);
    CHECK(shell(binary() + " render --none " + redirection) == 2);
  }
  const std::string warned = binary() + " render " + model("old_example011") +
                             " --size 16x16 --projection perspective --near 0.001 --z-bits 8 >/dev/null ";
  CHECK(shell(warned + "2>&1") == 0);
  CHECK(shell(warned + "2>/dev/full") == 0);
}

TEST_CASE("an output file never receives text for a closed standard stream") {
  const Folder folder;
  const std::string words = " compile " + model("old_example011") + " --size 16x16 -o ";
  REQUIRE(shell(binary() + words + (folder / "whole.csgt") + " >/dev/null") == 0);
  CHECK(shell(binary() + words + (folder / "closed.csgt") + " >&- 2>&- <&-") == 1);  // its summary cannot be printed
  CHECK(content(folder / "closed.csgt") == content(folder / "whole.csgt"));
}

TEST_CASE("csgsim ended by a signal that can be caught leaves no file behind") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU, SIGXFSZ, SIGVTALRM,
                           SIGPROF, SIGPIPE, SIGRTMIN}) {
    CAPTURE(signal);
    const Folder folder;
    const Folder temporary;
    const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/terrain_vehicle.csgt";
    const std::string output = folder / "long.vcd";
    const pid_t child = ::fork();
    if (child == 0) {
      ::setenv("TMPDIR", temporary.path().c_str(), 1);
      const rlimit no_core{0, 0};
      ::setrlimit(RLIMIT_CORE, &no_core);
      ::execl(binary().c_str(), "csgsim", "wave", program.c_str(), "--pixel", "1,1", "--window", "0:1000000", "--whole",
              "-o", output.c_str(), static_cast<char*>(nullptr));
      std::_Exit(127);
    }
    for (int wait = 0; wait < 500 && folder.files() == 0; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(folder.files() > 0);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.files() == 0);
    CHECK(temporary.files() == 0);
  }
}
