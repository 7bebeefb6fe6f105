#include "tests/unit/software/recount_sequences.h"

#include <algorithm>

#include "tests/unit/software/recount_steps.h"

namespace csgsim::testing {

using enum processors::Operation;

using software::Counts;
using software::Event;
using software::VisibleSurface;

SequenceRecount::SequenceRecount(const PlainTree& tree, std::size_t primitives, Counts& counts, Evaluate evaluate)
    : tree_(tree), primitives_(primitives), evaluate_(evaluate), held_(primitives) {
  Held one(primitives);
  for (std::uint32_t primitive = 0; primitive < primitives; ++primitive) {
    change(one, primitive, counts);
    alone_.push_back(tree.holds(one));
    change(one, primitive, counts);
    counts.operations += steps({load}) + calls(1);
    ++counts.precomputed;
  }
}

/// Inverts a leaf and recomputes each node above it until one does not change.
void SequenceRecount::change(Held& held, std::uint32_t primitive, Counts& counts) const {
  const TreeVisits tally = tree_.update_tree(held, primitive);
  counts.node_visits += tally.visits;
  counts.early_outs += tally.early_outs;
  const std::uint64_t nodes = tally.visits - 1;
  counts.operations += steps({load_long, add, load, logic, store, branch_taken}) + calls(1);
  // Father, operands and their status, the operator, and the previous status of the operands.
  counts.operations += nodes * steps({{load_long, 3}, {load, 4}, {compare, 3}, branch_taken, logic});
  counts.operations += steps({{logic, tally.differences}});
  counts.operations += (nodes - tally.early_outs) * steps({branch, branch_taken, store});
}

void SequenceRecount::follow(Sequence& sequence, std::uint32_t primitive, Counts& counts) {
  counts.operations += steps({compare_long, branch});
  Sequence& links = links_[sequence];
  const auto found = std::ranges::find(links, primitive);
  const bool is_new = found == links.end();
  if (sequence.empty()) {
    // The first elements are in a table by primitive.
    ++counts.list_steps;
    counts.operations += steps({add, load_long, compare_long, branch});
  } else {
    const auto passed = static_cast<std::uint64_t>(found - links.begin());
    const std::uint64_t looked_at = passed + (is_new ? 0 : 1);
    counts.list_steps += looked_at;
    counts.operations += steps({load_long});
    counts.operations += looked_at * steps({load, compare, compare_long, branch});
    counts.operations += passed * steps({load_long, branch_taken});
  }
  if (is_new) {
    links.insert(links.begin(), primitive);
    ++counts.list_elements;
    counts.operations += steps({{store, 2}, {store_long, 4}, add_long});
    counts.operations += calls(1);
  }
  sequence.push_back(primitive);
  elements_.insert(sequence);
}

void SequenceRecount::undo_flips(Counts& traversal) {
  for (const std::uint32_t primitive : in_) change(held_, primitive, traversal);
  in_.clear();
}

/// Searches the inserted primitives for it; the last one moves to the freed place.
void SequenceRecount::take_in(std::uint32_t primitive, Counts& counts, Counts& traversal) {
  const auto place = std::ranges::find(in_, primitive);
  counts.operations += steps({load_long, branch, store});
  counts.operations += static_cast<std::uint64_t>(place - in_.begin()) * steps({load, compare, branch_taken});
  if (place == in_.end()) {
    in_.push_back(primitive);
  } else {
    *place = in_.back();
    in_.pop_back();
  }
  change(held_, primitive, traversal);
}

bool SequenceRecount::evaluated(const Sequence& sequence, Counts& counts) {
  ++counts.evaluations;
  Counts traversal;
  if (evaluate_ == Evaluate::back) {
    counts.operations += sequence.size() * steps({load_long, load, branch_taken});
    undo_flips(traversal);
    for (std::size_t i = sequence.size(); i-- > 0;) take_in(sequence[i], counts, traversal);
  } else {
    if (taken_in_ == 0) undo_flips(traversal);
    for (; taken_in_ < sequence.size(); ++taken_in_) take_in(sequence[taken_in_], counts, traversal);
  }
  traversal.operations += steps({load});
  traversal.operations += calls(1);
  counts.node_visits += traversal.node_visits;
  counts.early_outs += traversal.early_outs;
  counts.operations += traversal.operations;
  counts.traversal += traversal.operations;
  return tree_.holds(held_);
}

bool SequenceRecount::is_in(const Sequence& sequence, std::size_t at, Counts& counts) {
  counts.operations += steps({load, compare, branch});
  if (const auto known = classes_.find(sequence); known != classes_.end()) {
    ++counts.looked_up;
    return known->second;
  }
  counts.operations += steps({store});
  if (sequence.size() > 1 || at > 1) return classes_[sequence] = evaluated(sequence, counts);
  ++counts.looked_up;
  counts.operations += steps({{load, 2}, logic});
  return classes_[sequence] = alone_[sequence.front()];
}

std::uint32_t SequenceRecount::owner(std::span<const Event> before, std::span<const Event> at, Counts& counts) const {
  counts.operations += at.size() * steps({{load, 2}, compare, branch});
  std::vector<std::uint32_t> candidates;
  for (const Event& event : at) {
    if (event.leaves() == tree_.is_subtracted(event.primitive())) candidates.push_back(event.primitive());
  }
  if (candidates.size() == 1) return candidates.front();
  ++counts.ties;
  std::vector<std::uint32_t> active;
  for (const std::span<const Event> events : {before, at}) {
    for (const Event& event : events) {
      if (event.leaves()) {
        std::erase(active, event.primitive());
      } else {
        active.push_back(event.primitive());
      }
    }
  }
  Held held(primitives_);
  for (const std::uint32_t primitive : active) change(held, primitive, counts);
  std::uint32_t owner = VisibleSurface::nothing_seen;
  TreeVisits tally;
  for (std::size_t i = 0; i < candidates.size() && owner == VisibleSurface::nothing_seen; ++i) {
    if (tree_.shows(held, candidates[i], tally)) owner = candidates[i];
  }
  counts.node_visits += tally.visits;
  counts.operations += tally.visits * steps({{load_long, 2}, {load, 3}, {compare, 2}, {branch, 2}});
  for (const std::uint32_t primitive : active) change(held, primitive, counts);
  return owner;
}

std::uint32_t SequenceRecount::owner(const Sequence& sequence, std::size_t at, Counts& counts) const {
  std::vector<Event> events;
  for (auto one = sequence.begin(); one != sequence.end(); ++one) {
    const bool leaves = std::count(sequence.begin(), one, *one) % 2 != 0;
    events.push_back({0, 2 * *one + (leaves ? 1 : 0)});
  }
  const auto first = events.end() - static_cast<std::ptrdiff_t>(at);
  std::sort(first, events.end());
  return owner({events.begin(), first}, {first, events.end()}, counts);
}

VisibleSurface SequenceRecount::along(std::span<const Event> events, std::uint32_t farthest, std::size_t& used,
                                      Counts& counts) {
  Sequence sequence;
  taken_in_ = 0;
  for (used = 0; used < events.size();) {
    const std::size_t begin = used;
    while (used < events.size() && events[used].depth == events[begin].depth)
      follow(sequence, events[used++].primitive(), counts);
    const std::uint64_t at = used - begin;
    ++counts.points;
    counts.operations += steps({{load_long, 1 + at}, {compare_long, at}, {branch, at}});
    if (is_in(sequence, at, counts))
      return {events[begin].depth, owner(events.first(begin), events.subspan(begin, at), counts)};
  }
  return {farthest, VisibleSurface::nothing_seen};
}

std::vector<std::uint32_t> SequenceRecount::held(const Sequence& sequence, Counts& counts) const {
  counts.operations += sequence.size() * steps({load_long, load, branch_taken});
  // The most recent one comes first.
  std::vector<std::uint32_t> held;
  for (std::size_t i = sequence.size(); i-- > 0;) {
    if (std::ranges::find(held, sequence[i]) != held.end()) continue;
    if (std::ranges::count(sequence, sequence[i]) % 2 != 0) held.push_back(sequence[i]);
  }
  return held;
}

/// A bit and a first element per primitive; three pointers and a class per element; in the status tree five words per
/// node and a leaf per primitive.
std::uint64_t SequenceRecount::words() const {
  return (primitives_ + 31) / 32 + primitives_ + 4 * elements_.size() + 5 * tree_.nodes() + primitives_;
}

}  // namespace csgsim::testing
