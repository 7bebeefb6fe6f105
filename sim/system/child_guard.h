#pragma once

#include <sys/types.h>

#include <cstddef>

namespace csgsim::system {

/// What a program is started with.
struct GuardedProgram {
  char* const* words = nullptr;  ///< ended by a null pointer
  int input = -1;                ///< open files that become its standard ones
  int output = -1;
  int errors = -1;
  int told = -1;           ///< where its guard writes a GuardReport
  std::size_t memory = 0;  ///< RLIMIT_AS of its processes; the greatest number is none
};

/// How the program has ended.
struct GuardReport {
  int error = 0;           ///< errno, if it could not be run
  int status = 0;          ///< as waitpid tells it
  std::size_t memory = 0;  ///< most bytes that a process of its group had in memory
};

/// Starts a process that runs the program in a process group and waits for it: the guard. When the program ends, when
/// the guard is told to stop (SIGTERM), and when the thread that started it ends with its process, by whatever signal,
/// the guard ends all that is left of the group, and itself. Returns the guard's number, or -1 and errno.
pid_t start_guard(const GuardedProgram& program);

}  // namespace csgsim::system
