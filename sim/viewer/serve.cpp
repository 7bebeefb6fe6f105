#include "sim/viewer/serve.h"

#include <string>

#include "hw/base/error.h"
#include "hw/base/module.h"

namespace csgsim::viewer {

namespace {

#ifdef CSGSIM_WITHOUT_VIEWER
constexpr const char* disabling_option = "CSGSIM_VIEWER";
#else
constexpr const char* disabling_option = nullptr;
#endif

}  // namespace

void serve(const Serving& serving) {
  const void* const symbol = load_module_symbol({.file = module_file,
                                                 .symbol = module_symbol,
                                                 .does = "serves pages to browsers",
                                                 .disabling_option = disabling_option});
  const std::string wrong = static_cast<const Module*>(symbol)->serve(serving);
  if (!wrong.empty()) throw InputError(wrong);
}

}  // namespace csgsim::viewer
