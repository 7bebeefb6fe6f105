#include "sim/system/own_program.h"

#include <filesystem>
#include <system_error>

#include "hw/base/error.h"

namespace csgsim::system {

std::string own_program() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    throw InputError("csgsim: cannot find its own program file: " + error.message() + "; check that /proc is mounted");
  return program.native();
}

}  // namespace csgsim::system
