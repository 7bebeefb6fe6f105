#include "sim/system/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "hw/base/descriptor.h"
#include "hw/base/error.h"
#include "hw/base/interruption.h"
#include "hw/base/text.h"
#include "sim/system/child_guard.h"

namespace csgsim::system {

namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  Descriptor out;  ///< read end
  Descriptor in;   ///< write end
};

[[noreturn]] void fail(const std::string& program, int error) {
  throw InputError(fmt::format("{}: cannot be run: {}; check the limits of this process (ulimit -a)", program,
                               std::strerror(error)));
}

Pipe make_pipe(const std::string& program) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(program, errno);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// The guard of a program. The destructor terminates both.
class Guard {
 public:
  explicit Guard(pid_t number) : number_(number) {}
  ~Guard() {
    ::kill(number_, SIGTERM);
    while (::waitpid(number_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

 private:
  pid_t number_;
};

/// Bytes read from a pipe, up to a limit.
struct Stream {
  Descriptor file;
  std::string& bytes;
  std::size_t most;
  Exceeded exceeded;  ///< the limit to report if there are more bytes

  /// Reads the available bytes. Beyond the limit it reads only one byte, which indicates the excess; returns false
  /// then.
  [[nodiscard]] bool take() {
    std::array<char, std::size_t{1} << 16U> block{};
    for (;;) {
      const std::size_t wanted = std::min(block.size(), most - std::min(most, bytes.size()) + 1);
      const ssize_t count = ::read(file.number(), block.data(), wanted);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return true;
      if (count == 0) static_cast<void>(file.close());
      if (count == 0) return true;
      bytes.append(block.data(), static_cast<std::size_t>(count));
      if (bytes.size() <= most) continue;
      bytes.resize(most);
      return false;
    }
  }
};

int milliseconds_until(Clock::time_point end) {
  constexpr std::chrono::milliseconds longest = std::chrono::hours(1);
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
  return static_cast<int>(std::clamp(left, std::chrono::milliseconds(0), longest).count());
}

/// Reads the program's output until the guard reports its end or a limit is exceeded. Throws Interrupted.
Exceeded listen(const Descriptor& report, std::array<Stream, 2>& streams, Clock::time_point end) {
  // poll() is not woken by a stop request
  constexpr int look_after = 50;  // milliseconds
  const bool is_interruptible = thread_stop_token().stop_possible();
  for (;;) {
    throw_if_interrupted();
    std::array<pollfd, 3> files{pollfd{report.number(), POLLIN, 0}, pollfd{streams[0].file.number(), POLLIN, 0},
                                pollfd{streams[1].file.number(), POLLIN, 0}};
    const int longest = milliseconds_until(end);
    const int ready = ::poll(files.data(), files.size(), is_interruptible ? std::min(longest, look_after) : longest);
    if (ready < 0 && errno != EINTR) return Exceeded::nothing;
    for (Stream& stream : streams) {
      if (stream.file.is_open() && !stream.take()) return stream.exceeded;
    }
    if (ready > 0 && files[0].revents != 0) return Exceeded::nothing;
    if (Clock::now() >= end) return Exceeded::time;
  }
}

std::vector<char*> arguments_of(std::vector<std::string>& words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return arguments;
}

bool is_missing(int error) { return error == ENOENT || error == ENOTDIR || error == EACCES || error == ENOEXEC; }

}  // namespace

std::optional<ChildEnd> run_child(std::span<const std::string> words, const MemoryFile& input,
                                  const ChildLimits& limits) {
  std::vector<std::string> owned(words.begin(), words.end());
  const std::vector<char*> arguments = arguments_of(owned);
  const std::string& program = words.front();
  Pipe output = make_pipe(program);
  Pipe errors = make_pipe(program);
  Pipe report_pipe = make_pipe(program);
  const Clock::time_point end = Clock::now() + limits.time;
  const pid_t number = start_guard({arguments.data(), input.descriptor().number(), output.in.number(),
                                    errors.in.number(), report_pipe.in.number(), limits.memory});
  if (number < 0) fail(program, errno);
  for (Pipe* const pipe : {&output, &errors, &report_pipe}) static_cast<void>(pipe->in.close());
  ChildEnd ended;
  {
    const Guard guard(number);
    std::array<Stream, 2> streams{Stream{std::move(output.out), ended.output, limits.output, Exceeded::output},
                                  Stream{std::move(errors.out), ended.errors, limits.errors, Exceeded::errors}};
    ended.exceeded = listen(report_pipe.out, streams, end);
    // The last output may have arrived after the last poll.
    for (Stream& stream : streams) {
      if (ended.exceeded == Exceeded::nothing && stream.file.is_open() && !stream.take())
        ended.exceeded = stream.exceeded;
    }
  }
  GuardReport report{0, SIGKILL, 0};  // used if the guard was killed
  static_cast<void>(!::read(report_pipe.out.number(), &report, sizeof report));
  if (is_missing(report.error)) return std::nullopt;
  if (report.error != 0) fail(program, report.error);
  ended.status = report.status;
  ended.memory = report.memory;
  return ended;
}

bool has_succeeded(const ChildEnd& end) { return end.exceeded == Exceeded::nothing && end.status == 0; }

std::string failure_text(const ChildEnd& end, const ChildLimits& limits) {
  switch (end.exceeded) {
    case Exceeded::nothing: break;
    case Exceeded::time: return fmt::format("it did not finish within {} s", limits.time.count());
    case Exceeded::output: return "it wrote more than " + binary_size(limits.output);
    case Exceeded::errors: return fmt::format("it wrote more than {} of messages", binary_size(limits.errors));
  }
  if (WIFSIGNALED(end.status)) {
    return std::string("it was killed by a signal: ") + ::strsignal(WTERMSIG(end.status)) +
           (limits.memory == ChildLimits::none ? "" : "; its memory limit is " + binary_size(limits.memory));
  }
  const std::size_t begin = std::min(end.errors.find_first_not_of(" \n"), end.errors.size());
  return end.errors.substr(begin, end.errors.find('\n', begin) - begin);
}

}  // namespace csgsim::system
