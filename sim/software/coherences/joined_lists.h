// List structure with merged branches.
// One of the rows of coherences().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "sim/software/coherences/list_structure.h"
#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// The list structure in which branches lead to the same element if the same primitives are active, independent of the
/// order of intersection. The thesis proposes it (end of 4.5.3) but did not implement it. Elements are sets of
/// primitives, and links between them are searched as sons are in the list structure.
template <class Count>
class JoinedLists {
 public:
  JoinedLists(const Tree& tree, Count& count) : alone_(tree, count), roots_(tree.leaf_of.size(), none) {
    elements_.push_back({{}, none, PointClass::out});
    found_.emplace(0, 0);
  }

  void begin_ray() { at_ = 0; }

  template <class Evaluate>
  bool is_in(std::span<const Event> events, std::size_t begin, std::size_t end, const Evaluate& evaluate,
             Count& count) {
    for (std::size_t i = begin; i < end; ++i) at_ = after(at_, events[i].primitive(), count);
    count(Operation::load);
    count(Operation::compare);
    count(Operation::branch);
    return is_in_cached(elements_[at_].kept, is_first_alone(begin, end), events[0].primitive(), alone_, evaluate,
                        count);
  }

  /// The empty set has an array of links indexed by primitive. An element has a pointer to its links, its class, and
  /// its set at half a word per primitive; a link has two pointers and a primitive; the table of sets has a pointer per
  /// element.
  [[nodiscard]] std::uint64_t words() const {
    std::uint64_t words = alone_.words() + roots_.size() + 3 * links_.size() + 3 * elements_.size();
    for (const Element& element : elements_) words += element.active.size() / 2;
    return words;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  struct Element {
    std::vector<std::uint32_t> active;  ///< primitives, sorted
    std::uint32_t first_link;
    PointClass kept;
  };
  struct Link {
    std::uint32_t primitive;
    std::uint32_t to;
    std::uint32_t next;
  };

  std::uint32_t after(std::uint32_t from, std::uint32_t primitive, Count& count) {
    count(Operation::load_long);
    if (from == 0) return first_element(primitive, count);
    for (std::uint32_t at = elements_[from].first_link; at != none; at = links_[at].next) {
      count.list_step();
      count(Operation::load);
      count(Operation::compare);
      count(Operation::branch);
      if (links_[at].primitive == primitive) {
        count(Operation::load_long);
        return links_[at].to;
      }
      count(Operation::load_long);
      count(Operation::compare_long);
      count(Operation::branch_taken);
    }
    const std::uint32_t to = find_or_add_element(with_flipped(elements_[from].active, primitive, count), count);
    links_.push_back({primitive, to, elements_[from].first_link});
    elements_[from].first_link = static_cast<std::uint32_t>(links_.size() - 1);
    count(Operation::store);
    count(Operation::store_long, 3);
    return to;
  }

  std::uint32_t first_element(std::uint32_t primitive, Count& count) {
    count.list_step();
    count(Operation::add);
    count(Operation::compare_long);
    count(Operation::branch);
    if (roots_[primitive] == none) {
      roots_[primitive] = find_or_add_element({primitive}, count);
      count(Operation::store_long);
    }
    return roots_[primitive];
  }

  static std::vector<std::uint32_t> with_flipped(std::vector<std::uint32_t> set, std::uint32_t primitive,
                                                 Count& count) {
    const auto place = std::ranges::lower_bound(set, primitive);
    count(Operation::load, set.size() + 1);
    count(Operation::store, set.size() + 1);
    count(Operation::compare, set.size() + 1);
    count(Operation::branch_taken, set.size() + 1);
    if (place != set.end() && *place == primitive) {
      set.erase(place);
    } else {
      set.insert(place, primitive);
    }
    return set;
  }

  /// Hashes the set word by word, and counts the operations of each word.
  static std::uint64_t hash_of(std::span<const std::uint32_t> set, Count& count) {
    std::uint64_t hash = 0;
    for (const std::uint32_t primitive : set) {
      constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
      hash = (hash ^ primitive) * factor;
      hash ^= hash >> 32U;
    }
    count(Operation::load, set.size());
    count(Operation::logic, set.size());
    count(Operation::multiply, set.size());
    count(Operation::branch_taken, set.size());
    return hash;
  }

  std::uint32_t find_or_add_element(std::vector<std::uint32_t> set, Count& count) {
    const std::uint64_t hash = hash_of(set, count);
    const auto [begin, end] = found_.equal_range(hash);
    for (auto at = begin; at != end; ++at) {
      count(Operation::load_long, 2);
      count(Operation::compare_long, 1 + set.size() / 2);
      count(Operation::branch_taken, 1 + set.size() / 2);
      if (elements_[at->second].active == set) return at->second;
    }
    const auto element = static_cast<std::uint32_t>(elements_.size());
    count.list_element();
    count(Operation::store_long, 3 + set.size() / 2);
    count(Operation::load_long, set.size() / 2);
    elements_.push_back({std::move(set), none, PointClass::unknown});
    found_.emplace(hash, element);
    return element;
  }

  SolePrimitivePoints<Count> alone_;
  std::vector<std::uint32_t> roots_;  ///< per primitive, the element of the set with only this primitive
  std::vector<Element> elements_;
  std::vector<Link> links_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> found_;  ///< elements by the hashes of their sets
  std::uint32_t at_ = 0;
};

}  // namespace csgsim::software
