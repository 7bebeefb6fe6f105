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

TEST_CASE("a child program reads its input and all of its output is available at its end") {
  const std::string large_text(std::size_t{3} << 18U, 'x');
  const system::ChildEnd ended = run_shell("tee /dev/stderr; exit 3", usual, large_text);
  CHECK(ended.output == large_text);
  CHECK(ended.errors == large_text);
  CHECK(ended.exceeded == system::Exceeded::nothing);
  CHECK(WEXITSTATUS(ended.status) == 3);
  CHECK_FALSE(system::has_succeeded(ended));
  CHECK(system::has_succeeded(run_shell("true")));
}

TEST_CASE("a child program may write exactly up to its limits") {
  const std::string exact = "head -c 1048576 /dev/zero";
  CHECK(system::has_succeeded(run_shell(exact)));
  CHECK(system::has_succeeded(run_shell(exact + " >&2")));
  for (const auto& [commands, exceeded] :
       {std::pair("; echo", system::Exceeded::output), std::pair(" >&2; echo >&2", system::Exceeded::errors)}) {
    const system::ChildEnd ended = run_shell(exact + commands + "; sleep 300");
    CHECK(ended.exceeded == exceeded);
    CHECK(ended.output.size() + ended.errors.size() == mib);
    CHECK(system::failure_text(ended, usual).find("more than 1 MiB") != std::string::npos);
  }
}

TEST_CASE("a child program and its children are terminated at the time limit") {
  system::ChildLimits limits = usual;
  limits.time = std::chrono::seconds(1);
  const system::ChildEnd ended = run_shell("sleep 300 & echo $!; wait", limits);
  CHECK(ended.exceeded == system::Exceeded::time);
  CHECK(system::failure_text(ended, limits) == "it did not finish within 1 s");
  CHECK(::kill(std::stoi(ended.output), 0) != 0);
}

TEST_CASE("children that a child program leaves behind are terminated") {
  const system::ChildEnd ended = run_shell("sleep 300 & echo $!");
  CHECK(system::has_succeeded(ended));
  CHECK(::kill(std::stoi(ended.output), 0) != 0);
}

TEST_CASE("the peak memory of a child program's processes is reported") {
  constexpr std::size_t held = 64 * mib;
  const system::ChildEnd ended = run_shell("head -c 64M /dev/zero | tail -c 64M > /dev/null");
  CHECK(system::has_succeeded(ended));
  CHECK(ended.memory >= held);
  CHECK(ended.memory < 4 * held);
  CHECK(run_shell("true").memory < held);
}

TEST_CASE("a child program terminated by a signal is reported") {
  const system::ChildEnd ended = run_shell("kill -SEGV $$");
  CHECK(system::failure_text(ended, usual) == "it was killed by a signal: Segmentation fault");
}

TEST_CASE("a nonexistent child program is distinguished from a failing one") {
  const system::MemoryFile none("none");
  CHECK_FALSE(system::run_child(std::vector<std::string>{"there/is/none"}, none, usual).has_value());
  CHECK_FALSE(system::run_child(std::vector<std::string>{"csgsim-is-none"}, none, usual).has_value());
  CHECK(system::failure_text(run_shell("echo why >&2; exit 1"), usual) == "why");
}

TEST_CASE("a stop request to this thread terminates its child program and the children") {
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

TEST_CASE("a child program is terminated at once if a stop was requested before") {
  std::stop_source stop;
  const Interruptible interruptible(stop.get_token());
  stop.request_stop();
  CHECK_THROWS_AS(run_shell("sleep 300"), Interrupted);
}
