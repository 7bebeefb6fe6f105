#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sim/software/space/directory.h"
#include "sim/software/space/lattice.h"

namespace csgsim::software {

/// Levels of halving, x, y and z by turns: assumed, the thesis does not tell them.
inline constexpr unsigned excell_levels = 15;            ///< of a directory that is alone
inline constexpr unsigned excell_first_levels = 12;      ///< of the first of two
inline constexpr unsigned excell_second_levels = 9;      ///< of those behind it
inline constexpr std::size_t excell_large_model = 4096;  ///< facets from which there are two

/// The cells of EXCELL (Tamminen 1981; thesis 5.1.3, algorithm 5.1). A facet is in every cell that it is within reach
/// of.
///
/// A directory is an array of cells at the level of the smallest of them, so that a place is found by an address that
/// is worked out; a larger cell has several entries. A bucket that is full is split, at the directory's level after
/// this has been doubled; at the last level the cell gets a directory of its own, or else an overflow.
class ExcellCells {
 public:
  ExcellCells(const FacetShapes& shapes, const SpaceOptions& options);

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] SpaceBuilt built() const;

  /// A range of a directory: all places whose address begins so.
  struct Range {
    std::uint32_t directory = 0;
    std::uint32_t prefix = 0;
    unsigned level = 0;  ///< bits of the prefix
  };

  /// The cell that holds a place.
  template <class Count>
  Located locate(const glm::uvec3& at, Count& count) const {
    const std::uint32_t address = address_of(at);
    // Three tables tell how a coordinate's bits are spread.
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

  /// The facets of a range, if it is one cell.
  struct Looked {
    bool is_cell = false;
    std::span<const std::uint32_t> facets;
    Range range;  ///< the same places; in the directory of the cell where it has one
  };
  template <class Count>
  Looked look(Range range, Count& count) const {
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
    std::uint32_t number = 0;  ///< of a bucket or a directory
    bool is_directory = false;
  };
  struct Part {
    std::uint32_t prefix = 0;  ///< of the cell that it divides
    unsigned base = 0;         ///< that cell's level
    unsigned level = 0;        ///< its own, below that
    unsigned most = 0;
    std::vector<Entry> entries;
  };
  struct Bucket {
    unsigned level = 0;  ///< of its cell, from the top
    std::vector<std::uint32_t> facets;
  };

  [[nodiscard]] unsigned lattice_levels() const { return 3 * lattice_.bits; }
  /// Bits of the coordinates by turns, those of x first.
  [[nodiscard]] std::uint32_t address_of(const glm::uvec3& at) const;
  static glm::uvec3 depths_of(unsigned level) { return {(level + 2) / 3, (level + 1) / 3, level / 3}; }
  /// Of the first entry with that address, of which `level` bits are given.
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
  void insert(Range range, std::uint32_t facet);
  void put(const Range& range, std::uint32_t facet);
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
