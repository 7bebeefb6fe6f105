#include "hw/division/candidates.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "hw/division/cells.h"
#include "hw/division/corners.h"

namespace csgsim::division {

namespace {

void append(std::vector<std::uint32_t>& into, const std::vector<TestedHalfspace>& from) {
  for (const TestedHalfspace& one : from) into.push_back(one.number);
}

/// Keeps the surviving half-spaces, in their order. Returns false if nothing of the primitive is in the rectangle.
bool prune_halfspaces(Datapath& path, std::uint32_t index, const Rectangle& pixels,
                      std::vector<std::uint32_t>& halfspaces) {
  std::vector<TestedHalfspace> undecided;
  bool is_empty = false;
  for (const TestedHalfspace& tested : path.test(index, halfspaces, pixels)) {
    const Containment known = classify_between(tested, 0, path.header().farthest());
    is_empty = is_empty || known == Containment::out;
    if (known == Containment::depends) undecided.push_back(tested);
  }
  halfspaces.clear();
  if (is_empty) return false;
  const auto survivors_of_side = [&](Side side) {
    std::vector<TestedHalfspace> on_side;
    std::copy_if(undecided.begin(), undecided.end(), std::back_inserter(on_side),
                 [&](const TestedHalfspace& one) { return one.side == side; });
    remove_behind_leaders(path, on_side, pixels);
    return on_side;
  };
  // The sides follow one another. Order is kept within a side; between sides, only the order of edges matters.
  for (const Side side : {Side::front, Side::back}) append(halfspaces, survivors_of_side(side));
  for (const TestedHalfspace& one : undecided) {
    if (one.side == Side::not_negative || one.side == Side::negative) halfspaces.push_back(one.number);
  }
  return true;
}

}  // namespace

std::uint64_t Candidates::entry_count() const {
  std::uint64_t entries = primitives.size();
  for (const std::uint32_t primitive : primitives) entries += halfspaces[primitive].size();
  return entries;
}

Candidates all_candidates(const DisplayModel& model) {
  Candidates all;
  for (std::uint32_t i = 0; i < model.primitives.size(); ++i) {
    all.primitives.push_back(i);
    all.halfspaces.emplace_back(model.primitives[i].halfspaces.size());
    std::iota(all.halfspaces.back().begin(), all.halfspaces.back().end(), 0U);
  }
  all.listed.assign(model.primitives.size(), true);
  return all;
}

Candidates survivors(Datapath& path, const Candidates& candidates, const Rectangle& group) {
  Candidates kept;
  kept.halfspaces.resize(candidates.halfspaces.size());
  kept.listed.assign(candidates.halfspaces.size(), false);
  for (const std::uint32_t i : candidates.primitives) {
    const PrimitiveHead primitive = path.visit_primitive(i);
    const Rectangle shared = overlap(primitive.box.pixels, group);
    if (primitive.box.empty() || shared.empty()) continue;
    std::vector<std::uint32_t> halfspaces = candidates.halfspaces[i];
    if (!prune_halfspaces(path, i, shared, halfspaces)) continue;
    kept.listed[i] = true;
    kept.primitives.push_back(i);
    kept.halfspaces[i] = std::move(halfspaces);
  }
  return kept;
}

}  // namespace csgsim::division
