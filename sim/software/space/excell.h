// The spatial directory of the thesis.
// Used by excell.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sim/software/space/directory.h"
#include "sim/software/space/lattice.h"

namespace csgsim::software {

/// Numbers of halving levels, alternating between x, y and z. They are assumptions; the thesis does not specify them.
inline constexpr unsigned excell_levels = 15;            ///< single directory
inline constexpr unsigned excell_first_levels = 12;      ///< first of two levels of directories
inline constexpr unsigned excell_second_levels = 9;      ///< directories of the second level
inline constexpr std::size_t excell_large_model = 4096;  ///< minimum number of facets for two levels of directories

/// The cells of EXCELL (Tamminen 1981; thesis 5.1.3, algorithm 5.1). A facet is in every cell within reach of it.
///
/// A directory is an array of cells at the level of the smallest cell, so that a position is found by a computed
/// address; larger cells have several entries. A full bucket is split, after doubling the directory if its level
/// requires that. At the last level, the cell gets a separate directory or else an overflow.
class ExcellCells {
 public:
  ExcellCells(const FacetShapes& shapes, const SpaceOptions& options);

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] SpaceBuilt built() const;

  /// A range of a directory: all positions whose address starts with `prefix`.
  struct Range {
    std::uint32_t directory = 0;
    std::uint32_t prefix = 0;
    unsigned level = 0;  ///< number of bits of the prefix
  };

  /// The cell that contains a position.
  template <class Count>
  Located locate(const glm::uvec3& at, Count& count) const {
    const std::uint32_t address = address_of(at);
    // Three tables spread the bits of the coordinates.
    count(Operation::load_long, 3);
    count(Operation::logic_long, 2);
    std::uint32_t directory = 0;
    for (;;) {
      const Part& part = parts_[directory];
      const Entry& entry = part.entries[index_in(part, address, lattice_levels())];
      count.shift(1);
      count(Operation::logic_long);
      count(Operation::add_long);
      count(Operation::load_long);
      count(Operation::branch);
      if (!entry.is_directory) {
        const Bucket& bucket = buckets_[entry.number];
        count(Operation::load, 2);
        count(Operation::load_long, overflow_words(bucket));
        return {bucket.facets, depths_of(bucket.level)};
      }
      directory = entry.number;
    }
  }

  /// Result of looking up a range: its facets if it is one cell.
  struct RangeContent {
    bool is_cell = false;
    std::span<const std::uint32_t> facets;
    Range range;  ///< the range looked up; in the cell's own directory if it has one
  };
  template <class Count>
  RangeContent content_of_range(Range range, Count& count) const {
    for (;;) {
      const Part& part = parts_[range.directory];
      const Entry& entry = part.entries[index_in(part, range.prefix, range.level)];
      count.shift(1);
      count(Operation::add_long);
      count(Operation::load_long);
      count(Operation::load);
      count(Operation::compare);
      count(Operation::branch);
      if (entry.is_directory && range.level == part.base + part.level) {
        range.directory = entry.number;
        continue;
      }
      if (entry.is_directory || buckets_[entry.number].level > range.level) return {false, {}, range};
      count(Operation::load_long, overflow_words(buckets_[entry.number]));
      return {true, buckets_[entry.number].facets, range};
    }
  }

  /// See Directory.
  [[nodiscard]] std::vector<SpacePart> parts() const;

  /// The wall that halves a range.
  [[nodiscard]] double wall_of(const Range& range) const;
  static int axis_of(unsigned level) { return static_cast<int>(level % 3); }

 private:
  struct Entry {
    std::uint32_t number = 0;  ///< index of a bucket or a directory
    bool is_directory = false;
  };
  struct Part {
    std::uint32_t prefix = 0;  ///< prefix of the cell that it divides
    unsigned base = 0;         ///< level of that cell
    unsigned level = 0;        ///< levels below `base`
    unsigned max_level = 0;
    std::vector<Entry> entries;
  };
  struct Bucket {
    unsigned level = 0;  ///< level of its cell, from the top
    std::vector<std::uint32_t> facets;
  };

  [[nodiscard]] unsigned lattice_levels() const { return 3 * lattice_.bits; }
  /// Interleaved bits of the coordinates, x first.
  [[nodiscard]] std::uint32_t address_of(const glm::uvec3& at) const;
  static glm::uvec3 depths_of(unsigned level) { return {(level + 2) / 3, (level + 1) / 3, level / 3}; }
  /// Index of the first entry with that address; `level` bits of the address are given.
  static std::size_t index_in(const Part& part, std::uint32_t address, unsigned level) {
    const unsigned deepest = part.base + part.level;
    const std::uint32_t at = level >= deepest ? address >> (level - deepest) : address << (deepest - level);
    return at - (part.prefix << part.level);
  }
  [[nodiscard]] std::uint64_t overflow_words(const Bucket& bucket) const {
    return (bucket.facets.size() + bucket_size_ - 1) / bucket_size_;
  }
  [[nodiscard]] facet::Box box_of(std::uint32_t prefix, unsigned level) const;

  void add_part_of(const Range& asked, std::vector<SpacePart>& parts) const;
  /// Adds the facet to each cell of the range that it touches.
  void insert(Range range, std::uint32_t facet);
  /// Adds the facet to the cell of this range; divides the cell if it is full.
  void put(const Range& range, std::uint32_t facet);
  /// Divides the cell into two, and doubles its directory if necessary.
  void halve(const Range& range);
  std::uint32_t add_part(const Range& range, std::uint32_t bucket);

  const FacetShapes& shapes_;
  std::uint32_t bucket_size_;
  bool has_two_;
  Lattice lattice_;
  std::vector<Part> parts_;
  std::vector<Bucket> buckets_;
  SpaceBuilt built_;
  Counting count_;
};

}  // namespace csgsim::software
