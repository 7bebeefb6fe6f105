#include "host/view/leading.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace csgsim::view {

namespace {

using Corners = std::array<std::int64_t, 4>;

Corners at_corners(const FixedLinear& function, const PixelRect& pixels) {
  const auto at = [&](std::int64_t x, std::int64_t y) { return function.a * x + function.b * y + function.c; };
  return {at(pixels.x0, pixels.y0), at(pixels.x1, pixels.y0), at(pixels.x0, pixels.y1), at(pixels.x1, pixels.y1)};
}

/// Whether `one` is below `other` by at least `step` at every corner. Compares corners up to the first at which this is
/// false, and adds their number to `compared`.
bool is_below(const Corners& one, const Corners& other, std::int64_t step, std::uint64_t& compared) {
  return std::equal(one.begin(), one.end(), other.begin(), [&](std::int64_t mine, std::int64_t theirs) {
    ++compared;
    return mine + step <= theirs;
  });
}

}  // namespace

std::vector<bool> leading(std::span<const FixedLinear> functions, const PixelRect& pixels, std::int64_t step,
                          std::uint64_t* comparisons) {
  std::vector<Corners> values;
  values.reserve(functions.size());
  for (const FixedLinear& function : functions) values.push_back(at_corners(function, pixels));
  std::array<std::size_t, 4> leaders{};
  for (std::size_t corner = 0; corner < leaders.size(); ++corner) {
    const auto greatest = std::ranges::max_element(values, {}, [&](const Corners& one) { return one[corner]; });
    leaders[corner] = static_cast<std::size_t>(greatest - values.begin());
  }
  std::uint64_t compared = functions.size() * leaders.size();
  std::vector<bool> leads;
  leads.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    leads.push_back(std::ranges::none_of(leaders, [&](std::size_t by) {
      if (by == i || !is_below(values[i], values[by], step, compared)) return false;
      return i > by || !is_below(values[by], values[i], step, compared);
    }));
  }
  if (comparisons != nullptr) *comparisons += compared;
  return leads;
}

}  // namespace csgsim::view
