#include "sim/viewer/serve.h"

#include <fmt/format.h>

#include <filesystem>

#include "hw/base/error.h"
#include "hw/base/module.h"

namespace csgsim::viewer {

void serve(const Serving& serving) {
  constexpr const char* mend = "install csgsim whole (cmake --install), or name its folder in LD_LIBRARY_PATH";
  const std::filesystem::path file = find_module(module_file);
  if (file.empty()) {
    throw InputError(fmt::format(
        "{}, the part of csgsim that talks with browsers, is in no folder where libraries are looked for; {}",
        module_file, mend));
  }
  const OpenedModule opened = open_module(file, module_symbol);
  if (opened.symbol == nullptr) {
    throw InputError(fmt::format("{}, the part of csgsim that talks with browsers, cannot be opened: {}; {}",
                                 file.native(), opened.error, mend));
  }
  const std::string wrong = static_cast<const Module*>(opened.symbol)->serve(serving);
  if (!wrong.empty()) throw InputError(wrong);
}

}  // namespace csgsim::viewer
