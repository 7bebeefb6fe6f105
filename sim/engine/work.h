// Work counters of an engine.
// Used by sim/engine and sim/functional.
#pragma once

#include <cstdint>

namespace csgsim::engine {

/// Work of the simulation of a Program, not of the machine; zeros if the engine does not count it. The counts do not
/// depend on the number of threads.
struct Work {
  std::uint64_t instructions = 0;  ///< executions at a tile of pixels; each tile counts
  std::uint64_t words = 0;         ///< words of 64 pixel bits processed individually
  std::uint64_t lanes = 0;         ///< pixels at which a field was processed as a number

  Work& operator+=(const Work& other) {
    instructions += other.instructions;
    words += other.words;
    lanes += other.lanes;
    return *this;
  }
  bool operator==(const Work&) const = default;
};

}  // namespace csgsim::engine
