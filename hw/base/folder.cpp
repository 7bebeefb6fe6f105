#include "hw/base/folder.h"

#include <system_error>

#include "hw/base/error.h"

namespace csgsim {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error == std::errc::not_a_directory || error == std::errc::file_exists)
    throw InputError(folder.native() + ": this folder cannot be created: a file has its name; name another folder");
  if (error)
    throw InputError(folder.native() + ": this folder cannot be created: " + error.message() +
                     "; check the path and its permissions");
}

}  // namespace csgsim
