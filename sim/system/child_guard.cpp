#include "sim/system/child_guard.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <limits>

#include "hw/base/blocked_signals.h"

// Between fork and exec only async-signal-safe functions may be called, since other threads may have held locks.

namespace csgsim::system {

namespace {

constexpr std::size_t kibibyte = 1024;  // unit of ru_maxrss

/// Resets signal handlers to their defaults; ignored signals stay ignored.
void reset_handlers() {
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = SIG_DFL;
    action.sa_flags = 0;
    ::sigaction(signal, &action, nullptr);
  }
  std::signal(SIGCHLD, SIG_DFL);
}

void set_limit(int resource, std::size_t maximum) {
  rlimit now{};
  if (maximum == std::numeric_limits<std::size_t>::max() || ::getrlimit(resource, &now) != 0) return;
  now.rlim_cur = std::min<rlim_t>({now.rlim_cur, now.rlim_max, maximum});
  now.rlim_max = std::min<rlim_t>(now.rlim_max, maximum);
  ::setrlimit(resource, &now);
}

void report_to(int file, const GuardReport& report) {
  // A write of this size to a pipe is atomic. If the reader is gone, the report is not needed.
  static_cast<void>(!::write(file, &report, sizeof report));
}

/// Requests that the signal is sent when the parent process ends, and raises it if the parent has ended already.
void signal_at_end_of(pid_t parent, int signal) {
  ::prctl(PR_SET_PDEATHSIG, signal);
  if (::getppid() != parent) ::raise(signal);
}

[[noreturn]] void become(const GuardedProgram& program, pid_t guard, const sigset_t& signals) {
  ::setpgid(0, 0);
  signal_at_end_of(guard, SIGKILL);
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_AS, program.memory);
  ::dup2(program.input, STDIN_FILENO);
  ::dup2(program.output, STDOUT_FILENO);
  ::dup2(program.errors, STDERR_FILENO);
  ::close_range(STDERR_FILENO + 1, std::numeric_limits<unsigned>::max(), CLOSE_RANGE_CLOEXEC);
  ::pthread_sigmask(SIG_SETMASK, &signals, nullptr);
  ::execvp(program.words[0], program.words);
  report_to(program.report, {errno, 0, 0});
  ::_exit(1);
}

/// Closes all other files: open ends of pipes would block their readers.
void close_all_but(int kept) {
  ::dup2(kept, STDIN_FILENO);
  ::close_range(STDIN_FILENO + 1, std::numeric_limits<unsigned>::max(), 0);
}

/// Waits until the program ends or SIGTERM arrives.
void wait_for(pid_t program) {
  sigset_t awaited;
  ::sigemptyset(&awaited);
  ::sigaddset(&awaited, SIGCHLD);
  ::sigaddset(&awaited, SIGTERM);
  for (siginfo_t ended{};
       ::waitid(P_PID, static_cast<id_t>(program), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;) {
    if (::sigwaitinfo(&awaited, nullptr) == SIGTERM) return;
  }
}

[[noreturn]] void guard(const GuardedProgram& program, pid_t parent, const sigset_t& signals) {
  ::setpgid(0, 0);
  reset_handlers();
  signal_at_end_of(parent, SIGTERM);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans of the program become children of the guard
  const pid_t self = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become(program, self, signals);
  if (child < 0) {
    report_to(program.report, {errno, 0, 0});
    ::_exit(1);
  }
  ::setpgid(child, child);
  close_all_but(program.report);
  wait_for(child);
  // the group keeps its number until its last process has been waited for
  ::kill(-child, SIGKILL);
  GuardReport report;
  int status = 0;
  rusage usage{};
  for (pid_t ended = 0; (ended = ::wait4(-child, &status, 0, &usage)) > 0;) {
    if (ended == child) report.status = status;
    report.memory = std::max(report.memory, static_cast<std::size_t>(usage.ru_maxrss) * kibibyte);
  }
  report_to(STDIN_FILENO, report);
  ::_exit(0);
}

}  // namespace

pid_t start_guard(const GuardedProgram& program) {
  const BlockedSignals blocked;
  const pid_t parent = ::getpid();
  const pid_t started = ::fork();
  if (started == 0) guard(program, parent, blocked.before());
  return started;
}

}  // namespace csgsim::system
