// Runs a case of the benchmark suite on a machine.
// Used by sim/app.
#pragma once

#include <string>
#include <string_view>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"
#include "sim/suite/data.h"

namespace csgsim::suite {

/// A case and where it runs.
struct Job {
  const Case* one = nullptr;
  std::string machine;           ///< as for --machine
  std::string level;             ///< name of a level, as for --level
  bool compiles_always = false;  ///< compile the model even if the machine runs the stored Program
};

/// A Program with the machine that runs it.
struct Prepared {
  machines::Machine machine;
  isa::Program program;
};

/// The stored Program, or the one compiled from the case's model. Throws InputError.
Prepared prepare(const Data& data, const Job& job);

/// Runs the Program and returns its results. Throws InputError.
Row measure(const Prepared& prepared, const Job& job, bool shows_progress);

/// Calls prepare() and measure() in a separate process, because SystemC elaborates one machine per process. Throws
/// InputError with that process's message.
Row measure_apart(const Data& data, const Job& job);

/// Hash of the picture: of three bytes per pixel, red, green and blue, from the top left row by row.
std::string hash_of(const observe::Frame& frame);

/// Hash of a text's bytes.
std::string hash_of(std::string_view text);

}  // namespace csgsim::suite
