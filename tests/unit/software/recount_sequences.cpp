#include "tests/unit/software/recount_sequences.h"

#include <algorithm>

#include "tests/unit/software/recount_steps.h"

namespace csgsim::testing {

using software::Counts;
using software::Event;
using software::Seen;

SequenceRecount::SequenceRecount(const PlainTree& tree, std::size_t primitives, Counts& counts, Evaluate evaluate)
    : tree_(tree), primitives_(primitives), evaluate_(evaluate), held_(primitives) {
  Held one(primitives);
  for (std::uint32_t primitive = 0; primitive < primitives; ++primitive) {
    change(one, primitive, counts);
    alone_.push_back(tree.holds(one));
    change(one, primitive, counts);
    counts.operations += steps({{Operation::load, 1}, {Operation::come_back, 1}});
    ++counts.precomputed;
  }
}

/// A leaf is inverted, and each node above it worked out again until one stays as it is.
void SequenceRecount::change(Held& held, std::uint32_t primitive, Counts& counts) const {
  const Looks looks = tree_.change(held, primitive);
  counts.node_visits += looks.visits;
  counts.early_outs += looks.early_outs;
  const std::uint64_t nodes = looks.visits - 1;
  counts.operations += steps({{Operation::load_long, 1},
                              {Operation::add, 1},
                              {Operation::load, 1},
                              {Operation::logic, 1},
                              {Operation::store, 1},
                              {Operation::come_back, 1},
                              {Operation::branch_taken, 1}});
  // Father, operands and their status, the operator, and the status so far.
  counts.operations += nodes * steps({{Operation::load_long, 3},
                                      {Operation::load, 4},
                                      {Operation::compare, 3},
                                      {Operation::branch_taken, 1},
                                      {Operation::logic, 1}});
  counts.operations += steps({{Operation::logic, looks.differences}});
  counts.operations +=
      (nodes - looks.early_outs) * steps({{Operation::branch, 1}, {Operation::branch_taken, 1}, {Operation::store, 1}});
}

void SequenceRecount::follow(Sequence& sequence, std::uint32_t primitive, Counts& counts) {
  counts.operations += steps({{Operation::compare_long, 1}, {Operation::branch, 1}});
  Sequence& links = links_[sequence];
  const auto found = std::ranges::find(links, primitive);
  const bool is_new = found == links.end();
  if (sequence.empty()) {
    // The first elements are in a table by primitive.
    ++counts.list_steps;
    counts.operations +=
        steps({{Operation::add, 1}, {Operation::load_long, 1}, {Operation::compare_long, 1}, {Operation::branch, 1}});
  } else {
    const auto passed = static_cast<std::uint64_t>(found - links.begin());
    const std::uint64_t looked_at = passed + (is_new ? 0 : 1);
    counts.list_steps += looked_at;
    counts.operations += steps({{Operation::load_long, 1}});
    counts.operations +=
        looked_at *
        steps({{Operation::load, 1}, {Operation::compare, 1}, {Operation::compare_long, 1}, {Operation::branch, 1}});
    counts.operations += passed * steps({{Operation::load_long, 1}, {Operation::branch_taken, 1}});
  }
  if (is_new) {
    links.insert(links.begin(), primitive);
    ++counts.list_elements;
    counts.operations += steps({{Operation::store, 2}, {Operation::store_long, 4}, {Operation::add_long, 1}});
    counts.operations += calls(1);
  }
  sequence.push_back(primitive);
  elements_.insert(sequence);
}

void SequenceRecount::take_back(Counts& traversal) {
  for (const std::uint32_t primitive : in_) change(held_, primitive, traversal);
  in_.clear();
}

/// What has been taken in is searched for it; the last one takes the place of what is left.
void SequenceRecount::take_in(std::uint32_t primitive, Counts& counts, Counts& traversal) {
  const auto place = std::ranges::find(in_, primitive);
  counts.operations += steps({{Operation::load_long, 1}, {Operation::branch, 1}, {Operation::store, 1}});
  counts.operations += static_cast<std::uint64_t>(place - in_.begin()) *
                       steps({{Operation::load, 1}, {Operation::compare, 1}, {Operation::branch_taken, 1}});
  if (place == in_.end()) {
    in_.push_back(primitive);
  } else {
    *place = in_.back();
    in_.pop_back();
  }
  traversal.operations += steps({{Operation::call, 1}});
  change(held_, primitive, traversal);
}

bool SequenceRecount::evaluated(const Sequence& sequence, Counts& counts) {
  ++counts.evaluations;
  Counts traversal;
  if (evaluate_ == Evaluate::back) {
    counts.operations +=
        sequence.size() * steps({{Operation::load_long, 1}, {Operation::load, 1}, {Operation::branch_taken, 1}});
    take_back(traversal);
    for (std::size_t i = sequence.size(); i-- > 0;) take_in(sequence[i], counts, traversal);
  } else {
    if (taken_in_ == 0) take_back(traversal);
    for (; taken_in_ < sequence.size(); ++taken_in_) take_in(sequence[taken_in_], counts, traversal);
  }
  traversal.operations += steps({{Operation::load, 1}});
  traversal.operations += calls(1);
  counts.node_visits += traversal.node_visits;
  counts.early_outs += traversal.early_outs;
  counts.operations += traversal.operations;
  counts.traversal += traversal.operations;
  return tree_.holds(held_);
}

bool SequenceRecount::is_in(const Sequence& sequence, std::size_t at, Counts& counts) {
  counts.operations += steps({{Operation::load, 1}, {Operation::compare, 1}, {Operation::branch, 1}});
  if (const auto known = classes_.find(sequence); known != classes_.end()) {
    ++counts.looked_up;
    return known->second;
  }
  counts.operations += steps({{Operation::store, 1}});
  if (sequence.size() > 1 || at > 1) return classes_[sequence] = evaluated(sequence, counts);
  ++counts.looked_up;
  counts.operations += steps({{Operation::load, 2}, {Operation::logic, 1}});
  return classes_[sequence] = alone_[sequence.front()];
}

std::uint32_t SequenceRecount::owner(std::span<const Event> before, std::span<const Event> at, Counts& counts) const {
  counts.operations += at.size() * steps({{Operation::load, 2}, {Operation::compare, 1}, {Operation::branch, 1}});
  std::vector<std::uint32_t> candidates;
  for (const Event& event : at) {
    if (event.leaves() == tree_.is_taken_away(event.primitive())) candidates.push_back(event.primitive());
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
  std::uint32_t owner = Seen::nothing_seen;
  Looks looks;
  for (std::size_t i = 0; i < candidates.size() && owner == Seen::nothing_seen; ++i) {
    if (tree_.shows(held, candidates[i], looks)) owner = candidates[i];
  }
  counts.node_visits += looks.visits;
  counts.operations +=
      looks.visits *
      steps({{Operation::load_long, 2}, {Operation::load, 3}, {Operation::compare, 2}, {Operation::branch, 2}});
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

Seen SequenceRecount::along(std::span<const Event> events, std::uint32_t farthest, std::size_t& used, Counts& counts) {
  Sequence sequence;
  taken_in_ = 0;
  for (used = 0; used < events.size();) {
    const std::size_t begin = used;
    while (used < events.size() && events[used].depth == events[begin].depth)
      follow(sequence, events[used++].primitive(), counts);
    const std::uint64_t at = used - begin;
    ++counts.points;
    counts.operations +=
        steps({{Operation::load_long, 1 + at}, {Operation::compare_long, at}, {Operation::branch, at}});
    if (is_in(sequence, at, counts))
      return {events[begin].depth, owner(events.first(begin), events.subspan(begin, at), counts)};
  }
  return {farthest, Seen::nothing_seen};
}

std::vector<std::uint32_t> SequenceRecount::held(const Sequence& sequence, Counts& counts) const {
  counts.operations +=
      sequence.size() * steps({{Operation::load_long, 1}, {Operation::load, 1}, {Operation::branch_taken, 1}});
  // The last one that was met comes first.
  std::vector<std::uint32_t> held;
  for (std::size_t i = sequence.size(); i-- > 0;) {
    if (std::ranges::find(held, sequence[i]) != held.end()) continue;
    if (std::ranges::count(sequence, sequence[i]) % 2 != 0) held.push_back(sequence[i]);
  }
  return held;
}

/// A bit and a first element a primitive; three pointers and a class an element; five words a node and a leaf a
/// primitive, of the status tree.
std::uint64_t SequenceRecount::words() const {
  return (primitives_ + 31) / 32 + primitives_ + 4 * elements_.size() + 5 * tree_.nodes() + primitives_;
}

}  // namespace csgsim::testing
