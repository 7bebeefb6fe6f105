#include "sim/software/space/excell.h"

#include <algorithm>
#include <utility>

#include "sim/software/space/halving_walk.h"

namespace csgsim::software {

ExcellCells::ExcellCells(const FacetShapes& shapes, const SpaceOptions& options)
    : shapes_(shapes), bucket_size_(options.bucket_size), has_two_(shapes.placed().size() >= excell_large_model) {
  lattice_ = {shapes.box(), (has_two_ ? excell_first_levels + excell_second_levels : excell_levels) / 3};
  buckets_.emplace_back();
  parts_.push_back({0, 0, 0, has_two_ ? excell_first_levels : excell_levels, {Entry{}}});
  for (const std::uint32_t facet : shapes.placed()) insert({}, facet);
}

std::uint32_t ExcellCells::address_of(const glm::uvec3& at) const {
  std::uint32_t address = 0;
  for (unsigned bit = lattice_.bits; bit-- > 0;) {
    for (int axis = 0; axis < 3; ++axis) address = address << 1U | (at[axis] >> bit & 1U);
  }
  return address;
}

facet::Box ExcellCells::box_of(std::uint32_t prefix, unsigned level) const {
  glm::uvec3 at{0};
  for (unsigned i = 0; i < level; ++i) {
    std::uint32_t& coordinate = at[axis_of(i)];
    coordinate = coordinate << 1U | (prefix >> (level - 1 - i) & 1U);
  }
  const glm::uvec3 depths = depths_of(level);
  for (int axis = 0; axis < 3; ++axis) at[axis] <<= lattice_.bits - depths[axis];
  return lattice_.block(at, depths);
}

double ExcellCells::wall_of(const Range& range) const {
  // The bits of the range's axis are every third bit of the prefix, starting with the third-last.
  const int axis = axis_of(range.level);
  std::uint32_t cells = 1;
  unsigned place = 1;
  for (unsigned level = range.level; level >= 3; level -= 3, ++place)
    cells |= (range.prefix >> (range.level - level + 2) & 1U) << place;
  return lattice_.wall(axis, cells << (lattice_.bits - place));
}

void ExcellCells::insert(Range range, std::uint32_t facet) {
  ++built_.overlap_tests;
  if (!shapes_.touches(facet, box_of(range.prefix, range.level), count_)) return;
  const RangeContent looked = content_of_range(range, count_);
  range = looked.range;
  if (looked.is_cell) {
    put(range, facet);
    return;
  }
  insert({range.directory, 2 * range.prefix, range.level + 1}, facet);
  insert({range.directory, 2 * range.prefix + 1, range.level + 1}, facet);
}

void ExcellCells::put(const Range& range, std::uint32_t facet) {
  const Part& part = parts_[range.directory];
  const std::uint32_t number = part.entries[index_in(part, range.prefix, range.level)].number;
  const unsigned last = part.base + part.max_level;
  Bucket& bucket = buckets_[number];
  count_(Operation::load, 2);
  count_(Operation::compare, 2);
  count_(Operation::branch, 2);
  if (bucket.facets.size() < bucket_size_ || (range.level == last && last == lattice_levels())) {
    count_(Operation::store_long);
    bucket.facets.push_back(facet);
    return;
  }
  Range divided = range;
  if (range.level == last) divided.directory = add_part(range, number);
  halve(divided);
  insert({divided.directory, 2 * range.prefix, range.level + 1}, facet);
  insert({divided.directory, 2 * range.prefix + 1, range.level + 1}, facet);
}

std::uint32_t ExcellCells::add_part(const Range& range, std::uint32_t bucket) {
  Part& part = parts_[range.directory];
  const auto added = static_cast<std::uint32_t>(parts_.size());
  part.entries[index_in(part, range.prefix, range.level)] = {added, true};
  parts_.push_back({range.prefix, range.level, 0, excell_second_levels, {Entry{bucket, false}}});
  count_(Operation::store_long, 4);
  return added;
}

void ExcellCells::halve(const Range& range) {
  Part& part = parts_[range.directory];
  if (range.level == part.base + part.level) {
    std::vector<Entry> doubled;
    doubled.reserve(2 * part.entries.size());
    for (const Entry& entry : part.entries) doubled.insert(doubled.end(), 2, entry);
    part.entries = std::move(doubled);
    ++part.level;
    count_(Operation::load_long, part.entries.size() / 2);
    count_(Operation::store_long, part.entries.size());
    count_(Operation::branch_taken, part.entries.size() / 2);
  }
  ++built_.splits;
  const std::size_t first = index_in(part, range.prefix, range.level);
  const std::uint32_t low = part.entries[first].number;
  const auto high = static_cast<std::uint32_t>(buckets_.size());
  buckets_.push_back({range.level + 1, {}});
  buckets_[low].level = range.level + 1;
  const std::size_t half = std::size_t{1} << (part.base + part.level - range.level - 1);
  for (std::size_t i = 0; i < half; ++i) part.entries[first + half + i].number = high;
  count_(Operation::store_long, 4 + half);
  const std::vector<std::uint32_t> facets = std::exchange(buckets_[low].facets, {});
  const facet::Box low_box = box_of(2 * range.prefix, range.level + 1);
  const facet::Box high_box = box_of(2 * range.prefix + 1, range.level + 1);
  built_.overlap_tests += 2 * facets.size();
  for (const std::uint32_t facet : facets) {
    if (shapes_.touches(facet, low_box, count_)) buckets_[low].facets.push_back(facet);
    if (shapes_.touches(facet, high_box, count_)) buckets_[high].facets.push_back(facet);
    count_(Operation::load_long);
    count_(Operation::store_long);
  }
}

void ExcellCells::add_part_of(const Range& asked, std::vector<SpacePart>& parts) const {
  Uncounted uncounted;
  const RangeContent looked = content_of_range(asked, uncounted);
  const Range& range = looked.range;
  const std::size_t number = parts.size();
  parts.push_back({box_of(range.prefix, range.level)});
  if (looked.is_cell) {
    parts[number].facets = looked.facets;
    return;
  }
  parts[number].axis = axis_of(range.level);
  parts[number].wall = wall_of(range);
  parts[number].low = static_cast<std::uint32_t>(parts.size());
  add_part_of({range.directory, 2 * range.prefix, range.level + 1}, parts);
  parts[number].high = static_cast<std::uint32_t>(parts.size());
  add_part_of({range.directory, 2 * range.prefix + 1, range.level + 1}, parts);
}

std::vector<SpacePart> ExcellCells::parts() const {
  std::vector<SpacePart> parts;
  add_part_of({}, parts);
  return parts;
}

SpaceBuilt ExcellCells::built() const {
  SpaceBuilt built = built_;
  built.operations = count_.done();
  built.cells = buckets_.size();
  for (const Part& part : parts_) {
    built.entries += part.entries.size();
    built.directory_words += 4 + part.entries.size();
  }
  for (const Bucket& bucket : buckets_) {
    const std::uint64_t chained = std::max<std::uint64_t>(1, overflow_words(bucket));
    built.references += bucket.facets.size();
    built.most_facets = std::max<std::uint64_t>(built.most_facets, bucket.facets.size());
    built.overflows += chained > 1 ? 1U : 0U;
    built.bucket_words += chained * (2 + bucket_size_);
  }
  return built;
}

namespace {

class Excell final : public DirectoryOf<Excell> {
 public:
  Excell(const FacetShapes& shapes, const SpaceOptions& options) : cells_(shapes, options) {}

  [[nodiscard]] SpaceBuilt built() const override { return cells_.built(); }
  [[nodiscard]] std::vector<SpacePart> parts() const override { return cells_.parts(); }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    const auto locate = [&](const glm::uvec3& at, Count& counted) { return cells_.locate(at, counted); };
    PointWalk(cells_.lattice(), ray, locate, count).walk_cells(visitor);
  }

 private:
  ExcellCells cells_;
};

class RecursiveExcell final : public DirectoryOf<RecursiveExcell> {
 public:
  RecursiveExcell(const FacetShapes& shapes, const SpaceOptions& options) : cells_(shapes, options) {}

  [[nodiscard]] SpaceBuilt built() const override { return cells_.built(); }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    using Range = ExcellCells::Range;
    const auto look = [&](const Range& asked, Count& counted) {
      const ExcellCells::RangeContent looked = cells_.content_of_range(asked, counted);
      if (looked.is_cell) return Halved<Range>{true, looked.facets};
      const Range& range = looked.range;
      counted.shift(1);
      count_products(counted, 1);
      counted(Operation::add_long, 2);
      return Halved<Range>{false,
                           {},
                           ExcellCells::axis_of(range.level),
                           cells_.wall_of(range),
                           {range.directory, 2 * range.prefix, range.level + 1},
                           {range.directory, 2 * range.prefix + 1, range.level + 1}};
    };
    walk_halves(cells_.lattice().box, Range{}, ray, look, visitor, count);
  }

 private:
  ExcellCells cells_;
};

}  // namespace

extern const DirectoryRow excell_row{
    "excell", "halved cells found by address computation, visited from query point to query point",
    "Tamminen 1981; Jansen 1987, 5.1.3, algorithm 5.3", make_directory<Excell>, true};
extern const DirectoryRow recursive_excell_row{"excell-recursive",
                                               "halved cells, visited by clipping the ray to halves of the array",
                                               "Jansen 1987, algorithm 5.4", make_directory<RecursiveExcell>};

}  // namespace csgsim::software
