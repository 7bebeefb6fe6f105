#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "sim/software/methods/counts.h"
#include "sim/software/rays/ray_band.h"
#include "tests/unit/software/plain_tree.h"

namespace csgsim::testing {

/// Primitives in the order in which a ray meets their surfaces.
using Sequence = std::vector<std::uint32_t>;

/// Evaluation order of a new sequence.
enum class Evaluate : std::uint8_t {
  back,   ///< evaluates its surfaces from the last to the first, independent of earlier evaluations
  along,  ///< continues the last evaluation of the same ray
};

/// Recounts the costs of classification by the list structure and a status tree (thesis 4.5.3 and 4.3.4) from surface
/// sequences and a tree as written. Each function adds to the counts passed to it.
class SequenceRecount {
 public:
  /// Precomputes the class of each single primitive. Keeps a reference.
  SequenceRecount(const PlainTree& tree, std::size_t primitives, software::Counts& counts,
                  Evaluate evaluate = Evaluate::back);

  /// Adds a surface to a sequence.
  void follow(Sequence& sequence, std::uint32_t primitive, software::Counts& counts);
  /// Whether points after a sequence are inside; the last `at` surfaces of the sequence are at one depth.
  bool is_in(const Sequence& sequence, std::size_t at, software::Counts& counts);
  /// Owner of the visible surface among entering events `at`, after the events `before`.
  std::uint32_t owner(std::span<const software::Event> before, std::span<const software::Event> at,
                      software::Counts& counts) const;
  /// Owner of the visible surface of a sequence whose last `at` surfaces are entered.
  std::uint32_t owner(const Sequence& sequence, std::size_t at, software::Counts& counts) const;
  /// Returns the visible surface of a ray's events; `used` is their number up to it, or all.
  software::VisibleSurface along(std::span<const software::Event> events, std::uint32_t farthest, std::size_t& used,
                                 software::Counts& counts);
  /// Primitives that contain the points after a sequence, found by following it back.
  std::vector<std::uint32_t> held(const Sequence& sequence, software::Counts& counts) const;

  [[nodiscard]] std::uint64_t words() const;

 private:
  void change(Held& held, std::uint32_t primitive, software::Counts& counts) const;
  void undo_flips(software::Counts& traversal);
  void take_in(std::uint32_t primitive, software::Counts& counts, software::Counts& traversal);
  bool evaluated(const Sequence& sequence, software::Counts& counts);

  const PlainTree& tree_;
  std::size_t primitives_;
  Evaluate evaluate_;
  std::vector<bool> alone_;
  std::map<Sequence, Sequence> links_;  ///< successors of each sequence, the latest one first
  std::set<Sequence> elements_;
  std::map<Sequence, bool> classes_;
  Held held_;                 ///< primitives in the status tree
  Sequence in_;               ///< inserted primitives in the order of their removal
  std::size_t taken_in_ = 0;  ///< surfaces of the ray, for evaluation along it
};

}  // namespace csgsim::testing
