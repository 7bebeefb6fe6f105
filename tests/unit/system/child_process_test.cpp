#include "sim/system/child_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stop_token>
#include <thread>

#include "hw/base/interruption.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::size_t mib = std::size_t{1} << 20U;
constexpr system::ChildLimits usual{.time = std::chrono::seconds(60), .output = mib, .errors = mib};

system::ChildEnd run_shell(const std::string& commands, const system::ChildLimits& limits = usual,
                           const std::string& input = "") {
  system::MemoryFile file("sh");
  file.write(input);
  const std::vector<std::string> words{"sh", "-c", commands};
  const auto ended = system::run_child(words, file, limits);
  REQUIRE(ended.has_value());
  return *ended;
}

}  // namespace

TEST_CASE("a program reads its input, and all that it writes is there at its end") {
  const std::string much(std::size_t{3} << 18U, 'x');
  const system::ChildEnd ended = run_shell("tee /dev/stderr; exit 3", usual, much);
  CHECK(ended.output == much);
  CHECK(ended.errors == much);
  CHECK(ended.exceeded == system::Exceeded::nothing);
  CHECK(WEXITSTATUS(ended.status) == 3);
  CHECK_FALSE(system::is_done(ended));
  CHECK(system::is_done(run_shell("true")));
}

TEST_CASE("a program may write as much as its limits, and not a byte more") {
  const std::string exact = "head -c 1048576 /dev/zero";
  CHECK(system::is_done(run_shell(exact)));
  CHECK(system::is_done(run_shell(exact + " >&2")));
  for (const auto& [commands, exceeded] :
       {std::pair("; echo", system::Exceeded::output), std::pair(" >&2; echo >&2", system::Exceeded::errors)}) {
    const system::ChildEnd ended = run_shell(exact + commands + "; sleep 300");
    CHECK(ended.exceeded == exceeded);
    CHECK(ended.output.size() + ended.errors.size() == mib);
    CHECK(system::why_failed(ended, usual).find("more than 1 MiB") != std::string::npos);
  }
}

TEST_CASE("a program that is not done in its time is ended, with what it has begun") {
  system::ChildLimits limits = usual;
  limits.time = std::chrono::seconds(1);
  const system::ChildEnd ended = run_shell("sleep 300 & echo $!; wait", limits);
  CHECK(ended.exceeded == system::Exceeded::time);
  CHECK(system::why_failed(ended, limits) == "it did not finish within 1 s");
  CHECK(::kill(std::stoi(ended.output), 0) != 0);
}

TEST_CASE("what a program leaves behind is ended with it, and not waited for") {
  const system::ChildEnd ended = run_shell("sleep 300 & echo $!");
  CHECK(system::is_done(ended));
  CHECK(::kill(std::stoi(ended.output), 0) != 0);
}

TEST_CASE("the most memory of a program's processes is told") {
  constexpr std::size_t held = 64 * mib;
  const system::ChildEnd ended = run_shell("head -c 64M /dev/zero | tail -c 64M > /dev/null");
  CHECK(system::is_done(ended));
  CHECK(ended.memory >= held);
  CHECK(ended.memory < 4 * held);
  CHECK(run_shell("true").memory < held);
}

TEST_CASE("a program that a signal ends is told as such") {
  const system::ChildEnd ended = run_shell("kill -SEGV $$");
  CHECK(system::why_failed(ended, usual) == "it was killed by a signal: Segmentation fault");
}

TEST_CASE("a program that is not there is told from one that fails") {
  const system::MemoryFile none("none");
  CHECK_FALSE(system::run_child(std::vector<std::string>{"there/is/none"}, none, usual).has_value());
  CHECK_FALSE(system::run_child(std::vector<std::string>{"csgsim-is-none"}, none, usual).has_value());
  CHECK(system::why_failed(run_shell("echo why >&2; exit 1"), usual) == "why");
}

TEST_CASE("ends a program, with what it has begun, when this thread's work is to stop") {
  std::stop_source stop;
  const Interruptible interruptible(stop.get_token());
  const std::string number = "/tmp/csgsim-child-" + std::to_string(::getpid());
  std::jthread other([&] {
    while (!std::filesystem::exists(number)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop.request_stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THROWS_AS(run_shell("sleep 300 & echo $! > " + number + ".part; mv " + number + ".part " + number + "; wait"),
                  Interrupted);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(30));
  pid_t child = 0;
  std::ifstream(number) >> child;
  REQUIRE(child > 0);
  CHECK(::kill(child, 0) != 0);
  std::filesystem::remove(number);
}

TEST_CASE("ends a program at once when this thread's work was to stop before") {
  std::stop_source stop;
  const Interruptible interruptible(stop.get_token());
  stop.request_stop();
  CHECK_THROWS_AS(run_shell("sleep 300"), Interrupted);
}
