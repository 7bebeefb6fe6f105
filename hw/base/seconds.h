// Measures wall time.
// Used by sim/app, sim/software, sim/studies and sim/viewer.
#pragma once

#include <chrono>

namespace csgsim {

/// Wall time since `begin`, in seconds.
inline double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace csgsim
