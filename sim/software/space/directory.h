// Interface of spatial directories.
// Implemented by all directories and used by ray tracing and list priority.
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

/// A ray: origin + t direction, for t from begin to end. In model space relative to PlaneTable::centre(); `end` may be
/// infinite.
struct SpaceRay {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0};
  double begin = 0;
  double end = 0;

  [[nodiscard]] glm::dvec3 at(double t) const { return origin + direction * t; }
};

/// A part of space that a ray visits: a cell, or a box with facets.
struct Cell {
  double t_in = 0;
  double t_out = 0;
  /// Every facet that the ray hits before this t is in this cell or an earlier one. Does not decrease from cell to
  /// cell.
  double settled = 0;
  std::span<const std::uint32_t> facets;  ///< unordered indices into Facets::facets
};

/// Receives the cells along a ray.
class CellVisitor {
 public:
  CellVisitor() = default;
  virtual ~CellVisitor() = default;
  CellVisitor(const CellVisitor&) = delete;
  CellVisitor& operator=(const CellVisitor&) = delete;

  /// Returns whether the ray must visit further cells.
  virtual bool visit(const Cell& cell) = 0;
};

/// A part of space: divided by a wall perpendicular to an axis, or a cell.
struct SpacePart {
  static constexpr std::uint32_t none = 0xffffffffU;

  facet::Box box;
  int axis = 0;
  double wall = 0;
  std::uint32_t low = none;  ///< parts on the two sides of the wall; none for a cell
  std::uint32_t high = none;
  std::span<const std::uint32_t> facets{};  ///< facets of a cell

  [[nodiscard]] bool is_cell() const { return low == none; }
};

/// A node of a tree of boxes.
struct SpaceBox {
  facet::Box box;
  std::uint32_t low = 0;                    ///< index of the first of two adjacent child nodes; 0 for a leaf
  std::span<const std::uint32_t> facets{};  ///< facets of a leaf
};

/// Statistics of a directory and of its construction.
struct SpaceBuilt {
  std::uint64_t cells = 0;          ///< including empty ones; for a tree of boxes, its leaves
  std::uint64_t entries = 0;        ///< entries of directories, or nodes of trees
  std::uint64_t references = 0;     ///< total number of facets in cells
  std::uint64_t most_facets = 0;    ///< maximum per cell
  std::uint64_t overflows = 0;      ///< overfull cells that are not divided further
  std::uint64_t splits = 0;         ///< divisions of cells or boxes
  std::uint64_t overlap_tests = 0;  ///< tests of a facet against a cell
  std::uint64_t directory_words = 0;
  std::uint64_t bucket_words = 0;
  Operations operations;
};

/// Counts the cells of a tree, each with a bucket of facets; other nodes have none. `is_cell(node)` distinguishes them.
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

/// A spatial index of facets.
class Directory {
 public:
  Directory() = default;
  virtual ~Directory() = default;
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  /// Visits the cells along a ray from the front until the visitor returns false. Facets without corners are in no
  /// cell.
  virtual void walk(const SpaceRay& ray, CellVisitor& visitor, Counting& count) const = 0;
  virtual void walk(const SpaceRay& ray, CellVisitor& visitor, Uncounted& count) const = 0;
  /// Statistics of the current state; some directories are built incrementally while rays are traced.
  [[nodiscard]] virtual SpaceBuilt built() const = 0;
  /// The parts of a directory whose walls halve space, the whole space first; empty for others. Refers to the
  /// directory's data.
  [[nodiscard]] virtual std::vector<SpacePart> parts() const { return {}; }
  /// The current nodes of a tree of boxes, the root first; empty for others. Refers to the directory's data.
  [[nodiscard]] virtual std::vector<SpaceBox> boxes() const { return {}; }
};

/// Implements both overloads of walk() by a member function template of `Own`, the derived class.
template <class Own>
class DirectoryOf : public Directory {
 public:
  void walk(const SpaceRay& ray, CellVisitor& visitor, Counting& count) const final {
    static_cast<const Own&>(*this).walk_cells(ray, visitor, count);
  }
  void walk(const SpaceRay& ray, CellVisitor& visitor, Uncounted& count) const final {
    static_cast<const Own&>(*this).walk_cells(ray, visitor, count);
  }
};

/// Options of directories.
struct SpaceOptions {
  std::uint32_t bucket_size = 8;  ///< maximum facets per cell, at least 1; fuller cells are divided while levels remain
};

/// A row of the table of directories.
struct DirectoryRow {
  std::string_view name;
  std::string_view help;
  std::string_view source;
  /// Creates the directory, which keeps a reference to `shapes`.
  std::unique_ptr<Directory> (*make)(const FacetShapes& shapes, const SpaceOptions& options) = nullptr;
  bool halves_space = false;  ///< whether it has parts(); set for the first of rows with the same cells
};

std::span<const DirectoryRow* const> directories();
/// Names of the directories that halve space.
std::vector<std::string> halving_directories();
/// Finds a directory by name. Throws InputError that lists the valid names.
const DirectoryRow& directory_of(const std::string& name);

template <class Own>
std::unique_ptr<Directory> make_directory(const FacetShapes& shapes, const SpaceOptions& options) {
  return std::make_unique<Own>(shapes, options);
}

}  // namespace csgsim::software
