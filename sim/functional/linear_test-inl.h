// Included once per instruction set, as Highway requires, hence no plain include guard.
#if defined(CSGSIM_LINEAR_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_LINEAR_TEST_INL_H
#undef CSGSIM_LINEAR_TEST_INL_H
#else
#define CSGSIM_LINEAR_TEST_INL_H
#endif

#include <hwy/highway.h>

#include "sim/functional/linear_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

constexpr bool is_sign(LinearKind kind) { return kind == LinearKind::not_negative || kind == LinearKind::negative; }
constexpr bool writes(LinearKind kind) {
  return kind == LinearKind::load || kind == LinearKind::keep_max || kind == LinearKind::keep_min;
}

/// The mask of where the test of the kind holds; a load writes everywhere. z is 0 for signs.
template <LinearKind kind, class Vector>
HWY_INLINE auto test(Vector f, Vector z) {
  namespace hn = hwy::HWY_NAMESPACE;
  using enum LinearKind;
  if constexpr (kind == not_negative || kind == greater_or_equal)
    return hn::Not(hn::Lt(f, z));
  else if constexpr (kind == negative || kind == less || kind == keep_min)
    return hn::Lt(f, z);
  else if constexpr (kind == greater || kind == keep_max)
    return hn::Gt(f, z);
  else if constexpr (kind == less_or_equal)
    return hn::Not(hn::Gt(f, z));
  else if constexpr (kind == equal)
    return hn::Eq(f, z);
  else
    return hn::Eq(f, f);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
