#include "host/csg/kept_results.h"

#include <utility>

namespace csgsim::csg {

namespace {

/// Maximum number of kept 32-bit numbers (64 Mbyte).
constexpr std::size_t most_kept = std::size_t{1} << 24;

/// How many numbers of a key, or test results, a host reads in the time of one node visit: each takes a load, an
/// addition and a comparison, but no call.
constexpr std::uint64_t looked_up_per_visit = 3;

constexpr std::size_t numbers_of_step = 6;
constexpr std::size_t numbers_of_node = 24;
constexpr std::size_t numbers_of_excluder = 8;

}  // namespace

ReuseCounts& ReuseCounts::operator+=(const ReuseCounts& more) {
  lookups += more.lookups;
  trees += more.trees;
  nodes += more.nodes;
  certificates += more.certificates;
  return *this;
}

std::size_t KeptResults::Hash::operator()(const std::vector<std::uint32_t>& key) const {
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const std::uint32_t number : key) hash = (hash ^ number) * 0x100000001b3ULL;
  return hash;
}

void KeptResults::begin_frame() {
  for (const auto& pairs : pairs_) pairs->begin_frame();
}

void KeptResults::begin_program(const facet::Geometry& geometry) {
  reused_ = {};
  geometry_ = &geometry;
  drawings_ = 0;
}

void KeptResults::forget_geometry() {
  pairs_.clear();
  used_ -= numbers_of_excluder * excluders_.size();
  excluders_.clear();
}

std::shared_ptr<PairTable> KeptResults::pair_table_for(const facet::Geometry& geometry) {
  if (&geometry != geometry_) return std::make_shared<PairTable>(geometry);
  if (drawings_ == pairs_.size()) pairs_.push_back(std::make_shared<PairTable>(geometry));
  pairs_[drawings_]->begin_program();
  return pairs_[drawings_++];
}

bool KeptResults::applies_to(const model::Tree& tree, const Pruning& pruning) {
  if (tree_ == nullptr) {
    tree_ = &tree;
    pruning_ = pruning;
  }
  return tree_ == &tree && pruning_ == pruning;
}

bool KeptResults::reserve(std::size_t numbers) {
  if (most_kept - used_ < numbers) return false;
  used_ += numbers;
  return true;
}

KeptResults::Search KeptResults::search(std::span<const std::uint32_t> set, std::span<const std::uint32_t> meeting) {
  ++reused_.lookups;
  std::vector<std::uint32_t> key{static_cast<std::uint32_t>(set.size())};
  key.insert(key.end(), set.begin(), set.end());
  key.insert(key.end(), meeting.begin(), meeting.end());
  auto found = roots_.find(key);
  if (found == roots_.end() && reserve(key.size() + numbers_of_step))
    found = roots_.emplace(std::move(key), model::no_index).first;
  return {*this, found == roots_.end() ? nullptr : &found->second, 1 + meeting.size()};
}

Excluder* KeptResults::excluder(std::uint32_t set, std::uint32_t primitive) {
  constexpr unsigned index_bits = 32;
  const std::uint64_t pair = std::uint64_t{set} << index_bits | primitive;
  const auto found = excluders_.find(pair);
  if (found != excluders_.end()) return &found->second;
  return reserve(numbers_of_excluder) ? &excluders_[pair] : nullptr;
}

KeptResults::Search::Search(KeptResults& kept, std::uint32_t* root, std::size_t key_length)
    : kept_(kept), root_(root), key_length_(key_length), at_(root == nullptr ? model::no_index : *root) {}

std::optional<std::uint32_t> KeptResults::Search::next_primitive() const {
  if (at_ == model::no_index || kept_.steps_[at_].tree != model::no_index) return std::nullopt;
  return kept_.steps_[at_].primitive;
}

void KeptResults::Search::continue_with(Containment known) {
  results_.push_back(known);
  last_ = at_;
  at_ = kept_.steps_[at_].next[static_cast<std::size_t>(known)];
}

const ActiveTree* KeptResults::Search::tree() const {
  return at_ == model::no_index ? nullptr : &kept_.trees_[kept_.steps_[at_].tree].tree;
}

std::uint64_t KeptResults::Search::visits() const {
  return 1 + (key_length_ + results_.size() + looked_up_per_visit - 1) / looked_up_per_visit;
}

void KeptResults::Search::count_found(std::uint64_t visits) {
  ++kept_.reused_.trees;
  const std::uint64_t replaced = kept_.trees_[kept_.steps_[at_].tree].visits;
  kept_.reused_.nodes += replaced > visits ? replaced - visits : 0;
}

/// Makes `step` the successor of the test results until now.
void KeptResults::Search::link(std::uint32_t step) {
  std::uint32_t& before =
      last_ == model::no_index ? *root_ : kept_.steps_[last_].next[static_cast<std::size_t>(results_.back())];
  before = step;
}

void KeptResults::Search::add(std::uint32_t primitive, Containment known) {
  if (root_ != nullptr && kept_.reserve(numbers_of_step)) {
    const auto step = static_cast<std::uint32_t>(kept_.steps_.size());
    kept_.steps_.push_back({.primitive = primitive});
    link(step);
    last_ = step;
  } else {
    root_ = nullptr;
  }
  results_.push_back(known);
  ++next_result_;
}

void KeptResults::Search::keep(const ActiveTree& tree, std::uint64_t visits) {
  if (root_ == nullptr || !kept_.reserve(numbers_of_step + numbers_of_node * (1 + tree.nodes.size()))) return;
  const auto step = static_cast<std::uint32_t>(kept_.steps_.size());
  kept_.steps_.push_back({.tree = static_cast<std::uint32_t>(kept_.trees_.size())});
  kept_.trees_.push_back({tree, visits});
  link(step);
}

}  // namespace csgsim::csg
