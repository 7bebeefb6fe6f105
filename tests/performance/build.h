#pragma once

#include <filesystem>
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

/// The commit that another csgsim tells of itself, or its file's name if it tells of none. Throws InputError if it is
/// no program, or one that fails.
std::string name_of_build(const std::filesystem::path& csgsim);

}  // namespace csgsim::bench
