#include <rapidcheck.h>

#include "tests/support/properties.h"

namespace csgsim::testing {

/// Replaces rapidcheck's function of that symbol, which rc::check calls; the linker redirects the calls
/// (CMakeLists.txt). rapidcheck gives the same random numbers to each property that a process checks, and offers no
/// other way to change that.
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
