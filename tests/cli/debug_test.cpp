#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

std::string trace(const std::string& name) { return std::string(CSGSIM_SOURCE_DIR) + "/traces/" + name + ".csgt"; }

/// Starts csgsim with these words, and kills it as soon as the file exists.
void kill_when_there(const std::vector<std::string>& words, const std::string& file, int signal) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    std::vector<char*> arguments;
    std::vector<std::string> all{std::string(CSGSIM_BINARY_DIR) + "/csgsim"};
    all.insert(all.end(), words.begin(), words.end());
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
    ::execv(arguments.front(), arguments.data());
    std::_Exit(127);
  }
  int status = 0;
  while (!fs::exists(file) && ::waitpid(child, &status, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ::kill(child, signal);
  ::waitpid(child, &status, 0);
}

nlohmann::json without_wall(const std::string& path) {
  nlohmann::json stats = json(path);
  stats.erase("wall_seconds");
  stats.erase("configuration");
  return stats;
}

}  // namespace

TEST_CASE("resuming a killed run from its checkpoint gives the same pictures and counts") {
  const Folder folder;
  const std::string program = trace("old_example002_lines");
  const auto outputs = [&](const std::string& name) {
    return " -o " + (folder / (name + ".png")) + " --depth " + (folder / (name + "d.exr")) + " --owner " +
           (folder / (name + "o.exr")) + " --stats " + (folder / (name + ".json"));
  };
  const std::string machine = " --machine scan-line ";
  require_success(run("run " + program + machine + outputs("whole")));
  for (const int signal : {SIGINT, SIGKILL}) {
    const std::string file = folder / "c.csgs";
    fs::remove(file);
    kill_when_there({"run", program, "--machine", "scan-line", "--level", "reference", "--checkpoint", file,
                     "--checkpoint-every", "3000"},
                    file, signal);
    REQUIRE(run("run " + program + machine + outputs("rest") + " --resume " + file + " --checkpoint " + file).code ==
            0);
    CHECK(content(folder / "rest.png") == content(folder / "whole.png"));
    CHECK(content(folder / "restd.exr") == content(folder / "wholed.exr"));
    CHECK(content(folder / "resto.exr") == content(folder / "wholeo.exr"));
    CHECK(without_wall(folder / "rest.json") == without_wall(folder / "whole.json"));
  }
}

TEST_CASE("rejects impossible checkpoints in one line and leaves no file") {
  const Folder folder;
  const std::string run_it = "run " + trace("thesis_fig_2_3");
  const std::string file = folder / "c.csgs";
  check_misuse(run_it + " --checkpoint " + file + " --level cycle", "the cycle level cannot stop");
  check_misuse(run_it + " --resume " + file + " --level cycle", "the cycle level cannot stop");
  check_misuse(run_it + " --checkpoint-every 5", "--checkpoint FILE");
  check_misuse(run_it + " --checkpoint-every 0 --checkpoint " + file, "take at least 1");
  check_misuse(run_it + " --checkpoint " + (folder / "p.png") + " -o " + (folder / "p.png"), "same file");
  CHECK(run(run_it + " --checkpoint " + (folder / "none/c.csgs")).code == 1);
  CHECK(folder.files() == 0);
  require_success(run(run_it + " --checkpoint " + file));
  const auto refused = [&](const std::string& words, const std::string& text) {
    const Outcome outcome = run(words);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    // The error may follow a warning that the Program was compiled for another machine.
    const std::size_t end = outcome.err.find(": warning: ") == std::string::npos ? 0 : outcome.err.find('\n') + 1;
    CHECK(is_one_line(outcome.err.substr(end)));
    CHECK(outcome.err.find(text) != std::string::npos);
  };
  refused("run " + trace("old_example002") + " --resume " + file, "belongs to another Program");
  refused(run_it + " --machine pixel-planes-4+clock.frequency=11000000 --resume " + file, "on another machine");
  write(folder / "short.csgs", content(file).substr(0, 1000));
  refused(run_it + " --resume " + (folder / "short.csgs"), "checksum does not match");
  refused(run_it + " --resume " + trace("thesis_fig_2_3"), "does not begin with CSGS");
}

namespace {

/// A Program that gives each pixel a colour, and another one from column `from` on.
std::string two_colours(int from) {
  return ".array width=8 height=2 memory_bits=16\n.machine name=\"pixel-planes-4\"\n"
         ".frame colour_base=8 colour_bits=6\n.field Z2 [0+:8] depth\n.field colour [8+:6] colour\n"
         ".primitive \"a\"\n.segment x=0 y=0 width=8 height=2\n  enable_all\n  set_constant Z2, 255\n"
         "  set_constant colour, 3\n  edge_not_negative x - " +
         std::to_string(from) + " (w8) ; render p0\n  set_constant colour, 48 ; shade p0\n";
}

}  // namespace

TEST_CASE("diff finds the first differing instruction and pixel with the history of both") {
  const Folder folder;
  write(folder / "a.txt", two_colours(5));
  write(folder / "b.txt", two_colours(4));
  const Outcome outcome = run("diff " + (folder / "a.txt") + " " + (folder / "b.txt"));
  CHECK(outcome.code == 1);
  CHECK(outcome.err == "A and B differ\n");
  const std::string expected =
      "i3 is the first instruction that differs:\n  A  edge_not_negative x - 5 (w8)\n  B  edge_not_negative x - 4 "
      "(w8)\n"
      "the states are equal after 3 instructions\n"
      "after i3, edge_not_negative x - 5 (w8)\n2 pixels differ, first 4,0:\n  E                A 0, B 1\n"
      "the pictures differ at 2 pixels, first 4,0:\n";
  CAPTURE(outcome.out);
  CHECK(outcome.out.find(expected) != std::string::npos);
  CHECK(outcome.out.find("\nA  pixel 4,0 shows") != std::string::npos);
  CHECK(outcome.out.find("\nB  pixel 4,0 shows") != std::string::npos);
}

TEST_CASE("diff finds levels and machines equal and rejects unequal sizes and options") {
  const std::string model_64 = "diff " + model("old_example011") + " --size 16x16 ";
  const Outcome levels = require_success(run(model_64 + "--level-b cycle"));
  CHECK(levels.out.find("the states are equal after 26 instructions\nthe pictures are equal\n") != std::string::npos);
  require_success(run(model_64 + "--level-a cycle --level-b reference"));
  require_success(run(model_64 + "--machine-b scan-line"));
  check_misuse(model_64 + "--level-a cycle --level-b cycle", "one machine per process");
  check_misuse("diff " + trace("thesis_fig_2_3") + " --strategy-b list", "for models");
  check_misuse("diff " + trace("thesis_fig_2_3") + " --size 8x8", "for models");
  fails(run("diff " + trace("thesis_fig_2_3") + " " + trace("old_example002")), 1,
        {"A draws 512 x 512 pixels and B 200 x 150"});
}

TEST_CASE("a debugger script echoes each command with its output and stops at an error") {
  const Folder folder;
  write(folder / "p.txt", two_colours(5));
  write(folder / "s", "step 2\n\nuntil colour[6,1] == 48  # the second\nprint colour[6,1]\nprint color[6,1]\nstep\n");
  const Outcome outcome = run("debug " + (folder / "p.txt") + " -x " + (folder / "s"));
  CHECK(outcome.code == 1);
  CHECK(outcome.out ==
        "> step 2\ni2 of 5: set_constant colour, 3\n"
        "> until colour[6,1] == 48  # the second\ncolour[6,1] == 48\nat the end, after i4\n"
        "> print colour[6,1]\ncolour[6,1] = 48 (0x30), #ff0000\n> print color[6,1]\n");
  CHECK(outcome.err == (folder / "s") + ":5:7: there is no field 'color'; the nearest is 'colour'\n");
  write(folder / "s", "step\nquit\nstep\n");
  const Outcome quit = require_success(run("debug " + (folder / "p.txt") + " -x " + (folder / "s")));
  CHECK(quit.out == "> step\ni1 of 5: set_constant Z2, 255\n> quit\n");
  check_misuse("debug " + (folder / "p.txt") + " --strategy list", "for models");
  CHECK(run("debug " + model("old_example011") + " --size 16x16").code == 0);  // reads /dev/null
}

TEST_CASE("the interactive debugger completes and edits lines and survives errors") {
  const Folder folder;
  write(folder / "p.txt", two_colours(5));
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE_MESSAGE(child >= 0, "there is no pseudo-terminal; mount /dev/pts, which a chroot lacks");
  if (child == 0) {
    ::setenv("TERM", "dumb", 1);
    const std::string binary = std::string(CSGSIM_BINARY_DIR) + "/csgsim";
    const std::string program = folder / "p.txt";
    ::execl(binary.c_str(), binary.c_str(), "debug", program.c_str(), nullptr);
    std::_Exit(127);
  }
  std::string shown;
  const auto read_some = [&] {
    pollfd waiting{terminal, POLLIN, 0};
    if (::poll(&waiting, 1, 20'000) != 1) return false;
    char buffer[512];
    const ssize_t got = ::read(terminal, buffer, sizeof buffer);
    if (got > 0) shown.append(buffer, static_cast<std::size_t>(got));
    return got > 0;
  };
  // The editor receives the keys of a line only after it has switched the terminal to raw mode, after the prompt. Until
  // then the terminal echoes and erases them.
  const auto is_taken_over = [&] {
    termios mode{};
    return ::tcgetattr(terminal, &mode) == 0 && (mode.c_lflag & ICANON) == 0;
  };
  const std::pair<std::string, std::string> lines[] = {
      {"help lists the commands\r\n", "wrong\n"},
      {"unknown command", "ste\t2\n"},
      {"i2 of 5: set_constant colour, 3\r\n", "prin\tcol\t\x7f[6,1]\n"},
      {"print colour[6,1]\r\n", "quit\n"}};
  std::size_t said = 0;
  for (const auto& [answer, keys] : lines) {
    while ((shown.find(answer, said) == std::string::npos || !shown.ends_with("> ")) && read_some()) {
    }
    for (int i = 0; i < 20'000 && !is_taken_over(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    REQUIRE(is_taken_over());
    said = shown.size();
    shown += '|';
    REQUIRE(::write(terminal, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()));
  }
  while (read_some()) {
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  CAPTURE(shown);
  CHECK(status == 0);
  CHECK(shown.find("5 instructions on pixel-planes-4; help lists the commands") != std::string::npos);
  CHECK(shown.find("debug:1:1: unknown command") != std::string::npos);
  CHECK(shown.find("i2 of 5: set_constant colour, 3") != std::string::npos);
  CHECK(shown.find("colour[6,1] = 0 (0x0), #000000") != std::string::npos);
}
