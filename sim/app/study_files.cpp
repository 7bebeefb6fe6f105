#include "sim/app/study_files.h"

#include <system_error>

#include "hw/base/error.h"

namespace csgsim::app {

std::filesystem::path study_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": cannot be made a folder (" + error.message() + ")");
  return folder;
}

}  // namespace csgsim::app
