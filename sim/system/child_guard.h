// A guard process that runs and terminates a child program.
// Used by child_process.cpp.
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace csgsim::system {

/// Arguments for starting a program.
struct GuardedProgram {
  char* const* words = nullptr;  ///< terminated by a null pointer
  int input = -1;                ///< open files that become standard input, output and error
  int output = -1;
  int errors = -1;
  int report = -1;         ///< file to which the guard writes a GuardReport
  std::size_t memory = 0;  ///< RLIMIT_AS of its processes; the maximum value means no limit
};

/// Report on the end of the program.
struct GuardReport {
  int error = 0;           ///< errno if it could not be run
  int status = 0;          ///< status from waitpid
  std::size_t memory = 0;  ///< peak resident memory of a process of its group, in bytes
};

/// Starts a guard: a process that runs the program in a process group and waits for it. When the program ends, when the
/// guard receives SIGTERM, or when the thread that started it or its process ends by any signal, the guard kills the
/// rest of the group and exits. Returns the process number of the guard, or -1 and errno.
pid_t start_guard(const GuardedProgram& program);

}  // namespace csgsim::system
