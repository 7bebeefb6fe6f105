#include "hw/division/candidates.h"

#include <algorithm>

#include "hw/division/cells.h"
#include "hw/division/corners.h"

namespace csgsim::division {

namespace {

void append(std::vector<Halfspace>& into, const std::vector<Tested>& from) {
  for (const Tested& one : from) into.push_back(one.halfspace);
}

/// The half-spaces that are left, in their order; false if nothing of the primitive is in the rectangle.
bool leave(const DisplayModel& model, std::uint32_t index, const Rectangle& pixels, std::vector<Halfspace>& left,
           Counts& counts) {
  std::vector<Tested> open;
  bool nothing = false;
  for (const Halfspace& halfspace : model.primitives[index].halfspaces) {
    const Tested tested = test_corners(model, index, halfspace, pixels);
    const Known known = known_between(tested, 0, model.farthest());
    nothing = nothing || known == Known::out;
    if (known == Known::depends) open.push_back(tested);
  }
  if (nothing) return false;
  const auto extremes_of = [&](Side side) {
    std::vector<Tested> on_side;
    std::copy_if(open.begin(), open.end(), std::back_inserter(on_side),
                 [&](const Tested& one) { return one.side == side; });
    counts.cells += keep_by_leaders(model, on_side, pixels);
    return on_side;
  };
  // Sides follow each other; within one the order stays, and no rule looks at the order between sides but that of
  // edges.
  for (const Side side : {Side::front, Side::back}) append(left, extremes_of(side));
  for (const Tested& one : open) {
    if (one.side == Side::not_negative || one.side == Side::negative) left.push_back(one.halfspace);
  }
  return true;
}

}  // namespace

std::uint64_t Candidates::entries() const {
  std::uint64_t entries = primitives.size();
  for (const std::uint32_t primitive : primitives) entries += halfspaces[primitive].size();
  return entries;
}

Candidates all_of(const DisplayModel& model) {
  Candidates all;
  for (std::uint32_t i = 0; i < model.primitives.size(); ++i) {
    all.primitives.push_back(i);
    all.halfspaces.push_back(model.primitives[i].halfspaces);
  }
  all.listed.assign(model.primitives.size(), true);
  return all;
}

Candidates survivors(const DisplayModel& model, const Rectangle& group, Counts& counts) {
  Candidates left;
  left.halfspaces.resize(model.primitives.size());
  left.listed.assign(model.primitives.size(), false);
  counts.boxes += model.primitives.size();
  for (std::uint32_t i = 0; i < model.primitives.size(); ++i) {
    const Rectangle shared = overlap(model.primitives[i].box.pixels, group);
    if (model.primitives[i].box.empty() || shared.empty()) continue;
    counts.halfspaces += model.primitives[i].halfspaces.size();
    left.listed[i] = leave(model, i, shared, left.halfspaces[i], counts);
    if (left.listed[i])
      left.primitives.push_back(i);
    else
      left.halfspaces[i].clear();
  }
  return left;
}

}  // namespace csgsim::division
