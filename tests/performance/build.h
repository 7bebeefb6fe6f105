#pragma once

#include <string>

namespace csgsim::bench {

/// What was built, and where it runs.
struct Build {
  std::string commit;    ///< empty if it was not built in a clone
  std::string compiler;  ///< name and version
  std::string flags;
  std::string cpu;      ///< model name
  unsigned cores = 0;   ///< that the system shows
  std::string vectors;  ///< the instruction set that the SIMD kernels take here
};

Build this_build();

}  // namespace csgsim::bench
