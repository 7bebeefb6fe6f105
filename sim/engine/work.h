#pragma once

#include <cstdint>

namespace csgsim::engine {

/// What an engine did to carry a Program out, where it counts it: figures of the simulation, not of the machine. They
/// are the same in every run, on any number of threads.
struct Work {
  std::uint64_t instructions = 0;  ///< carried out at a tile of pixels, each counted at each tile
  std::uint64_t words = 0;         ///< words of 64 pixels' bits looked at for themselves
  std::uint64_t lanes = 0;         ///< pixels whose number was worked out or moved

  Work& operator+=(const Work& other) {
    instructions += other.instructions;
    words += other.words;
    lanes += other.lanes;
    return *this;
  }
  bool operator==(const Work&) const = default;
};

}  // namespace csgsim::engine
