#include <rapidcheck.h>

#include "tests/support/properties.h"

namespace csgsim::testing {

/// Stands in for rapidcheck's function of that symbol, which rc::check calls: the linker replaces it (CMakeLists.txt).
/// rapidcheck gives each property that a process checks the same numbers, and has no other place to set that.
rc::detail::TestResult check_in_own_stream(
    const rc::detail::Property& property,
    const rc::detail::TestMetadata& metadata) __asm__("__wrap_" CSGSIM_CHECK_PROPERTY);

rc::detail::TestResult check_in_own_stream(const rc::detail::Property& property,
                                           const rc::detail::TestMetadata& metadata) {
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  parameters.seed = next_seed(parameters.seed, metadata.description);
  return rc::detail::checkProperty(property, metadata, parameters);
}

}  // namespace csgsim::testing
