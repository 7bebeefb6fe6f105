#include "sim/app/paths.h"

#include <algorithm>
#include <cctype>

namespace csgsim::app {

bool ends_in(const std::filesystem::path& path, std::string_view ending) {
  return std::ranges::equal(path.extension().string(), ending,
                            [](unsigned char letter, unsigned char wanted) { return std::tolower(letter) == wanted; });
}

}  // namespace csgsim::app
