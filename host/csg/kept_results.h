// Results of pruning that are kept from one block to the next, and from one frame to the next.
// Used by host/emit and sim/session.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "host/csg/active_tree.h"
#include "host/csg/locate.h"
#include "host/csg/pair_table.h"
#include "host/csg/pruning.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"

namespace csgsim::csg {

/// The work that a frame saved by reusing results of earlier frames.
struct ReuseCounts {
  std::uint64_t lookups = 0;       ///< active trees that were looked up
  std::uint64_t trees = 0;         ///< active trees that were found
  std::uint64_t nodes = 0;         ///< visits of tree nodes that finding the trees has replaced
  std::uint64_t certificates = 0;  ///< primitives excluded again by the half-space that had excluded them before

  ReuseCounts& operator+=(const ReuseCounts& more);
  bool operator==(const ReuseCounts&) const = default;
};

/// Stores active trees, keyed by their set and the primitives that meet its block; the half-spaces that exclude
/// primitives; and the planes between pairs of primitives. A kept tree belongs to the results of the tests at its
/// leaves, which are made again for each block, in the order in which a traversal of the CSG tree makes them. Found
/// trees are therefore those that a traversal would have built. A kept half-space is tested before the others of its
/// primitive; this does not change the result.
///
/// A look-up reads each primitive of the key and each result: three of these take the host as long as a visit of a node
/// (docs/host.md).
class KeptResults {
 public:
  /// Begins another frame.
  void begin_frame();

  /// Begins another Program of the frame, for the model with this geometry.
  void begin_program(const facet::Geometry& geometry);

  /// Removes the results that depend on the model's half-spaces. Called before these change.
  void forget_geometry();

  /// The table of pairs for the next drawing of the Program. Drawings of another geometry, such as a reflected one, get
  /// a new table.
  [[nodiscard]] std::shared_ptr<PairTable> pair_table_for(const facet::Geometry& geometry);

  /// Work that was replaced in the last Program.
  [[nodiscard]] const ReuseCounts& reused() const { return reused_; }

  /// Whether the kept results are those of this tree and these prunings, which the first call determines.
  [[nodiscard]] bool applies_to(const model::Tree& tree, const Pruning& pruning);

  /// The search for one active tree.
  class Search {
   public:
    /// The primitive to be tested next; empty if the test results until now determine the outcome of the search.
    [[nodiscard]] std::optional<std::uint32_t> next_primitive() const;
    /// Continues the search with the result of that test.
    void continue_with(Containment known);
    /// The kept tree; null if there is none.
    [[nodiscard]] const ActiveTree* tree() const;
    /// Cost of this search for the host, as a number of node visits.
    [[nodiscard]] std::uint64_t visits() const;

    /// The result of testing a primitive during a traversal of the CSG tree: the one that the search has already used,
    /// if any; otherwise that of `test`, which is kept.
    template <class Test>
    Containment test_once(std::uint32_t primitive, const Test& test) {
      if (next_result_ < results_.size()) return results_[next_result_++];
      const Containment known = test();
      add(primitive, known);
      return known;
    }

    /// Counts a found tree, whose search cost `visits` node visits, in reused().
    void count_found(std::uint64_t visits);
    /// Keeps a tree whose traversal took `visits` node visits.
    void keep(const ActiveTree& tree, std::uint64_t visits);

   private:
    friend class KeptResults;
    Search(KeptResults& kept, std::uint32_t* root, std::size_t key_length);
    void add(std::uint32_t primitive, Containment known);
    void link(std::uint32_t step);

    KeptResults& kept_;
    std::uint32_t* root_;  ///< number of the key's first step; null if it cannot be kept
    std::size_t key_length_;
    std::uint32_t at_ = model::no_index;    ///< the current step
    std::uint32_t last_ = model::no_index;  ///< the step before
    std::vector<Containment> results_;
    std::size_t next_result_ = 0;
  };

  /// Starts the search for the active tree of a set over a block that the primitives `meeting` meet.
  [[nodiscard]] Search search(std::span<const std::uint32_t> set, std::span<const std::uint32_t> meeting);

  /// The half-space that excluded the primitive from the surface of a set the last time; null if it cannot be kept.
  [[nodiscard]] Excluder* excluder(std::uint32_t set, std::uint32_t primitive);
  void count_certificate() { ++reused_.certificates; }

 private:
  /// A node of the search graph: a test of a primitive, or the tree that the preceding tests determine.
  struct Step {
    std::uint32_t primitive = model::no_index;
    std::uint32_t tree = model::no_index;
    std::array<std::uint32_t, 3> next{model::no_index, model::no_index, model::no_index};  ///< by the test's result
  };
  struct KeptTree {
    ActiveTree tree;
    std::uint64_t visits = 0;  ///< node visits of the traversal that built the tree
  };
  struct Hash {
    std::size_t operator()(const std::vector<std::uint32_t>& key) const;
  };

  /// Reserves room for that number of 32-bit numbers. Returns false if the limit would be exceeded.
  [[nodiscard]] bool reserve(std::size_t numbers);

  const model::Tree* tree_ = nullptr;
  Pruning pruning_;
  std::unordered_map<std::vector<std::uint32_t>, std::uint32_t, Hash> roots_;
  std::vector<Step> steps_;
  std::vector<KeptTree> trees_;
  std::unordered_map<std::uint64_t, Excluder> excluders_;
  std::size_t used_ = 0;
  const facet::Geometry* geometry_ = nullptr;
  std::vector<std::shared_ptr<PairTable>> pairs_;  ///< by the order of the drawings
  std::size_t drawings_ = 0;                       ///< number of the Program's drawings until now
  ReuseCounts reused_;
};

}  // namespace csgsim::csg
