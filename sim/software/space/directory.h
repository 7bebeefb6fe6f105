#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/space/facet_shapes.h"

namespace csgsim::software {

/// origin + t direction, for t from begin to end. Model space, relative to PlaneTable::centre(); end may be infinite.
struct SpaceRay {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0};
  double begin = 0;
  double end = 0;

  [[nodiscard]] glm::dvec3 at(double t) const { return origin + direction * t; }
};

/// What a ray comes to: a cell, or a box with facets.
struct Cell {
  double t_in = 0;
  double t_out = 0;
  /// Every facet that the ray meets before this has been told of, in this cell or before. No less than in cells before.
  double settled = 0;
  std::span<const std::uint32_t> facets;  ///< indices into Facets::facets, in no order
};

class CellVisitor {
 public:
  CellVisitor() = default;
  virtual ~CellVisitor() = default;
  CellVisitor(const CellVisitor&) = delete;
  CellVisitor& operator=(const CellVisitor&) = delete;

  /// Returns whether to go on.
  virtual bool visit(const Cell& cell) = 0;
};

/// A part of space: halved by a wall across an axis, or a cell.
struct SpacePart {
  static constexpr std::uint32_t none = 0xffffffffU;

  facet::Box box;
  int axis = 0;
  double wall = 0;
  std::uint32_t low = none;  ///< parts on the sides of the wall; none of a cell
  std::uint32_t high = none;
  std::span<const std::uint32_t> facets{};  ///< of a cell

  [[nodiscard]] bool is_cell() const { return low == none; }
};

/// A node of a tree of boxes.
struct SpaceBox {
  facet::Box box;
  std::uint32_t low = 0;                    ///< two nodes, this one and the one behind it; 0 for a leaf
  std::span<const std::uint32_t> facets{};  ///< of a leaf
};

/// What was built, and what that took.
struct SpaceBuilt {
  std::uint64_t cells = 0;          ///< with or without facets; of a tree of boxes its leaves
  std::uint64_t entries = 0;        ///< of directories; nodes of trees
  std::uint64_t references = 0;     ///< facets in cells
  std::uint64_t most_facets = 0;    ///< of a cell
  std::uint64_t overflows = 0;      ///< cells that are not divided further though they are too full
  std::uint64_t splits = 0;         ///< of cells or boxes
  std::uint64_t overlap_tests = 0;  ///< of a facet and a cell
  std::uint64_t directory_words = 0;
  std::uint64_t bucket_words = 0;
  Operations operations;
};

/// Counts the cells of a tree, each with a bucket of facets; its other nodes have none. `is_cell(node)` tells which.
template <class Nodes, class IsCell>
void count_buckets(const Nodes& nodes, std::uint32_t bucket_size, const IsCell& is_cell, SpaceBuilt& built) {
  built.entries = nodes.size();
  for (const auto& node : nodes) {
    if (!is_cell(node)) continue;
    ++built.cells;
    built.references += node.facets.size();
    built.most_facets = std::max<std::uint64_t>(built.most_facets, node.facets.size());
    built.overflows += node.facets.size() > bucket_size ? 1U : 0U;
  }
  built.bucket_words = built.references + built.cells;
}

/// Where facets are in space.
class Directory {
 public:
  Directory() = default;
  virtual ~Directory() = default;
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  /// The cells along a ray from the front, until the visitor has enough. Facets without corners are in none.
  virtual void walk(const SpaceRay& ray, CellVisitor& visitor, Counting& count) const = 0;
  virtual void walk(const SpaceRay& ray, CellVisitor& visitor, Uncounted& count) const = 0;
  /// So far: some are built as rays come.
  [[nodiscard]] virtual SpaceBuilt built() const = 0;
  /// Of a directory whose walls halve space, all of space first; nothing of others. Keeps references to it.
  [[nodiscard]] virtual std::vector<SpacePart> parts() const { return {}; }
  /// The nodes of a tree of boxes as far as it is built, the root first; empty for others. Keeps references to it.
  [[nodiscard]] virtual std::vector<SpaceBox> boxes() const { return {}; }
};

/// A directory that has a template `go` for both.
template <class Own>
class DirectoryOf : public Directory {
 public:
  void walk(const SpaceRay& ray, CellVisitor& visitor, Counting& count) const final {
    static_cast<const Own&>(*this).go(ray, visitor, count);
  }
  void walk(const SpaceRay& ray, CellVisitor& visitor, Uncounted& count) const final {
    static_cast<const Own&>(*this).go(ray, visitor, count);
  }
};

/// How directories are built.
struct SpaceOptions {
  std::uint32_t bucket_size = 8;  ///< facets of a cell, from 1: cells with more are divided as long as there are levels
};

/// A row of the table of directories.
struct DirectoryRow {
  std::string_view name;
  std::string_view help;
  std::string_view source;
  /// Keeps a reference.
  std::unique_ptr<Directory> (*make)(const FacetShapes& shapes, const SpaceOptions& options) = nullptr;
  bool halves_space = false;  ///< has parts(); of rows with the same cells the first
};

std::span<const DirectoryRow* const> directories();
/// Names of those that halve space.
std::vector<std::string> halving_directories();
/// By name. Throws InputError that lists what there is.
const DirectoryRow& directory_of(const std::string& name);

template <class Own>
std::unique_ptr<Directory> made_directory(const FacetShapes& shapes, const SpaceOptions& options) {
  return std::make_unique<Own>(shapes, options);
}

}  // namespace csgsim::software
