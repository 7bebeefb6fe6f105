#pragma once

#include <optional>
#include <span>
#include <string>

#include "hw/base/memory_file.h"

namespace csgsim {

/// What a program's standard files are connected to.
struct ChildFiles {
  const MemoryFile& input;
  const MemoryFile& output;
  const MemoryFile& errors;
};

/// Runs the program that the first word names, found as a shell finds it, and waits for its end. Returns its status as
/// waitpid tells it; none if it cannot be run.
std::optional<int> run_child(std::span<const std::string> words, const ChildFiles& files);

/// Why a program of that status failed: the signal, or the first line of what it said.
std::string why_failed(int status, const MemoryFile& errors);

}  // namespace csgsim
