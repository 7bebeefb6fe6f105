#include "host/read/files.h"

#include <algorithm>

namespace csgsim::read {

namespace fs = std::filesystem;

fs::path file_of(const Arguments& arguments) {
  const std::optional<std::string> name = arguments.text("file");
  if (!name) arguments.fail("there is no file; add file = \"name\"");
  return arguments.file(*name);
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

}  // namespace csgsim::read
