#include "tests/faults/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <exception>

#include "hw/base/address_sanitizer.h"
#include "places.h"
#include "tests/support/test.h"

namespace csgsim::testing::faults {

namespace {

std::string read_all(int number) {
  std::string text;
  std::array<char, 4096> block{};
  for (ssize_t size = 0; (size = ::read(number, block.data(), block.size())) > 0;)
    text.append(block.data(), static_cast<std::size_t>(size));
  return text;
}

void apply(const Conditions& conditions) {
  for (const auto& [name, value] : conditions.environment) ::setenv(name.c_str(), value.c_str(), 1);
  std::signal(SIGXFSZ, conditions.is_signalled ? SIG_DFL : SIG_IGN);
  const struct rlimit no_core {};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (!conditions.longest_file) return;
  const struct rlimit limit { *conditions.longest_file, *conditions.longest_file };
  if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) std::_Exit(98);
}

/// Redirects standard error to the pipe and discards standard output.
void connect(int error_pipe) {
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(error_pipe, STDERR_FILENO);
}

ChildResult run(const std::function<void()>& work, const Conditions& conditions) {
  std::array<int, 2> pipe{};
  REQUIRE(::pipe2(pipe.data(), O_CLOEXEC) == 0);
  std::fflush(nullptr);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    connect(pipe[1]);
    apply(conditions);
    work();
    std::_Exit(97);
  }
  ::close(pipe[1]);
  ChildResult ended;
  ended.err = read_all(pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  return ended;
}

}  // namespace

ChildResult run_csgsim(const std::vector<std::string>& words, const Conditions& conditions) {
  static const std::string program = std::string(CSGSIM_BINARY_DIR) + "/csgsim";
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return run([&] { ::execv(program.c_str(), arguments.data()); }, conditions);
}

ChildResult run_in_child(const std::function<void()>& work, const Conditions& conditions) {
  const auto tell = [&] {
    try {
      work();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      std::_Exit(1);
    }
    std::_Exit(0);
  };
  return run(tell, conditions);
}

ChildResult run_with_faults(const std::vector<std::string>& words, const std::string& fault,
                            const std::string& report) {
  Conditions conditions;
  conditions.environment = {{"LD_PRELOAD", CSGSIM_FAULT_LIBRARY}, {"CSGSIM_FAULT_REPORT", report}};
  if (!fault.empty()) conditions.environment["CSGSIM_FAULT"] = fault;
#if CSGSIM_ADDRESS_SANITIZER
  conditions.environment["ASAN_OPTIONS"] = "verify_asan_link_order=0";
#endif
  return run_csgsim(words, conditions);
}

std::map<std::string, std::size_t> calls(const std::string& report) {
  std::map<std::string, std::size_t> counts;
  std::ifstream file(report);
  std::string word;
  std::string kind;
  for (std::size_t count = 0; file >> word >> kind >> count;) counts[kind] = count;
  return counts;
}

}  // namespace csgsim::testing::faults
