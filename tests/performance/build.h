#pragma once

#include <filesystem>
#include <string>

namespace csgsim::bench {

/// The build and the computer it runs on.
struct Build {
  std::string commit;    ///< empty if not built in a clone
  std::string compiler;  ///< name and version
  std::string flags;
  std::string cpu;      ///< model name
  unsigned cores = 0;   ///< number of cores visible to the system
  std::string vectors;  ///< instruction set used by the SIMD kernels
};

Build this_build();

/// The commit printed by another csgsim, or its file's name if it prints none. Throws InputError if the file cannot be
/// run or fails.
std::string name_of_build(const std::filesystem::path& csgsim_path);

}  // namespace csgsim::bench
