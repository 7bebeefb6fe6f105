#include "host/csg/pair_table.h"

#include <algorithm>
#include <utility>

namespace csgsim::csg {

namespace {

/// Number of steps of a typical search, for the estimate of its time.
constexpr double usual_steps = 8;

std::uint64_t key_of(std::uint32_t one, std::uint32_t other) {
  constexpr unsigned index_bits = 32;
  return std::uint64_t{std::min(one, other)} << index_bits | std::max(one, other);
}

}  // namespace

void PairTable::begin_frame() {
  work_ = {};
  is_in_first_frame_ = false;
}

Hull& PairTable::hull(std::uint32_t primitive) {
  return hulls_.try_emplace(primitive, geometry_.solids[primitive].vertices).first->second;
}

bool PairTable::are_apart(std::uint32_t first, std::uint32_t second, const view::View& view, const Counted& counted) {
  const auto [lower, higher] = std::minmax(first, second);
  const auto [found, is_new] = results_.try_emplace(key_of(first, second));
  if (is_new) found->second.gap = find_gap(hull(lower), hull(higher), Counted(work_));
  found->second.program = program_;
  const std::optional<Gap>& gap = found->second.gap;
  if (!gap) return false;
  counted.add(&isa::Preparation::supports);
  return gap->half > view.extents[lower].looseness * gap->far_first &&
         gap->half > view.extents[higher].looseness * gap->far_second;
}

double PairTable::price(std::uint32_t first, std::uint32_t second, const Prices& prices) const {
  const auto found = results_.find(key_of(first, second));
  if (found != results_.end() && found->second.program == program_) return found->second.gap ? prices.support : 0;
  const auto points = [&](std::uint32_t primitive) {
    return static_cast<double>(geometry_.solids[primitive].vertices.size());
  };
  return usual_steps * (points(first) + points(second)) * prices.support;
}

}  // namespace csgsim::csg
