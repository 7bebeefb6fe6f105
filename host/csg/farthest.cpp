#include "host/csg/farthest.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "host/csg/farthest.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace csgsim::csg {
namespace HWY_NAMESPACE {
namespace {

#if HWY_HAVE_FLOAT64

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, farthest_row>;
using Numbers = hn::Vec<Tag>;

/// Distances of points along a direction, summed in the order of glm::dot().
class Along {
 public:
  Along(const std::array<std::span<const double>, 3>& axes, const glm::dvec3& direction)
      : axes_(axes),
        x_(hn::Set(Tag(), direction.x)),
        y_(hn::Set(Tag(), direction.y)),
        z_(hn::Set(Tag(), direction.z)) {}

  HWY_INLINE Numbers at(std::size_t begin) const {
    const Tag tag;
    const Numbers x = hn::Mul(hn::LoadU(tag, &axes_[0][begin]), x_);
    const Numbers y = hn::Mul(hn::LoadU(tag, &axes_[1][begin]), y_);
    return hn::Add(hn::Add(x, y), hn::Mul(hn::LoadU(tag, &axes_[2][begin]), z_));
  }

 private:
  const std::array<std::span<const double>, 3>& axes_;
  Numbers x_;
  Numbers y_;
  Numbers z_;
};

std::size_t first_farthest_of(const std::array<std::span<const double>, 3>& axes, const glm::dvec3& direction) {
  const Tag tag;
  const Along along(axes, direction);
  const std::size_t size = axes[0].size();
  const std::size_t step = hn::Lanes(tag);
  Numbers most = hn::Set(tag, -std::numeric_limits<double>::infinity());
  for (std::size_t begin = 0; begin < size; begin += step) {
    const Numbers found = along.at(begin);
    most = hn::IfThenElse(hn::Gt(found, most), found, most);
  }
  const Numbers farthest = hn::MaxOfLanes(tag, most);
  for (std::size_t begin = 0; begin < size; begin += step) {
    const auto first = hn::FindFirstTrue(tag, hn::Eq(along.at(begin), farthest));
    if (first >= 0) return begin + static_cast<std::size_t>(first);
  }
  return size;
}

#else

std::size_t first_farthest_of(const std::array<std::span<const double>, 3>& axes, const glm::dvec3& /*direction*/) {
  return axes[0].size();
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::csg
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::csg {

HWY_EXPORT(first_farthest_of);

std::size_t first_farthest(const std::array<std::span<const double>, 3>& axes, const glm::dvec3& direction) {
  return HWY_DYNAMIC_DISPATCH(first_farthest_of)(axes, direction);
}

}  // namespace csgsim::csg
#endif
