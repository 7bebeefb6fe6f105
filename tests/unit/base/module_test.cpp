#include "hw/base/module.h"

#include "hw/base/error.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("the error for a missing module says how to install or build it") {
  ModuleRole role{.file = "csgsim_kites.so", .symbol = "csgsim_kites_1", .does = "flies kites"};
  CHECK(
      module_missing_text(role) ==
      "csgsim_kites.so, the part of csgsim that flies kites, was not found in the library search path; install csgsim "
      "completely (cmake --install), or add its folder to LD_LIBRARY_PATH");
  CHECK_THROWS_WITH_AS(load_module_symbol(role), module_missing_text(role).c_str(), InputError);
  role.instead = ", or walk";
  role.disabling_option = "CSGSIM_KITES";
  CHECK(
      module_missing_text(role) ==
      "this build of csgsim lacks csgsim_kites.so, the part that flies kites; build csgsim with -DCSGSIM_KITES=ON, or "
      "walk");
}
