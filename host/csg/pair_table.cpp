#include "host/csg/pair_table.h"

#include <algorithm>
#include <utility>

namespace csgsim::csg {

namespace {

/// Steps of a usual search, for estimating its price.
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

bool PairTable::are_apart(std::uint32_t one, std::uint32_t other, const view::View& view, const Counted& counted) {
  const auto [first, second] = std::minmax(one, other);
  const auto [found, is_new] = results_.try_emplace(key_of(one, other));
  if (is_new) found->second.gap = find_gap(hull(first), hull(second), Counted(work_));
  found->second.program = program_;
  const std::optional<Gap>& gap = found->second.gap;
  if (!gap) return false;
  counted.add(&isa::Preparation::supports);
  return gap->half > view.extents[first].looseness * gap->far_first &&
         gap->half > view.extents[second].looseness * gap->far_second;
}

double PairTable::price(std::uint32_t one, std::uint32_t other, const Prices& prices) const {
  const auto found = results_.find(key_of(one, other));
  if (found != results_.end() && found->second.program == program_) return found->second.gap ? prices.support : 0;
  const auto points = [&](std::uint32_t primitive) {
    return static_cast<double>(geometry_.solids[primitive].vertices.size());
  };
  return usual_steps * (points(one) + points(other)) * prices.support;
}

}  // namespace csgsim::csg
