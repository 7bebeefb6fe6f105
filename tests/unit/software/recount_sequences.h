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

/// How a new sequence is evaluated.
enum class Evaluate : std::uint8_t {
  back,   ///< from its last surface back to the first, whatever was evaluated before
  along,  ///< from where the same ray was evaluated last
};

/// What classification by the list structure and a status tree takes (thesis 4.5.3 and 4.3.4), counted again from
/// sequences of surfaces and a tree as it is written. Each function adds to the counts that it is given.
class SequenceRecount {
 public:
  /// Looks up the class of each primitive alone beforehand. Keeps a reference.
  SequenceRecount(const PlainTree& tree, std::size_t primitives, software::Counts& counts,
                  Evaluate evaluate = Evaluate::back);

  /// Adds a surface to a sequence.
  void follow(Sequence& sequence, std::uint32_t primitive, software::Counts& counts);
  /// Whether the points behind a sequence are in, of whose surfaces the last `at` are at one depth.
  bool is_in(const Sequence& sequence, std::size_t at, software::Counts& counts);
  /// Whose surface is seen at events that lead in, behind those before.
  std::uint32_t owner(std::span<const software::Event> before, std::span<const software::Event> at,
                      software::Counts& counts) const;
  /// The same of a sequence, the last `at` of whose surfaces lead in.
  std::uint32_t owner(const Sequence& sequence, std::size_t at, software::Counts& counts) const;
  /// What is seen of a ray's events; `used` are those up to there, or all.
  software::Seen along(std::span<const software::Event> events, std::uint32_t farthest, std::size_t& used,
                       software::Counts& counts);
  /// Primitives that hold what is behind a sequence, by following it back.
  std::vector<std::uint32_t> held(const Sequence& sequence, software::Counts& counts) const;

  [[nodiscard]] std::uint64_t words() const;

 private:
  void change(Held& held, std::uint32_t primitive, software::Counts& counts) const;
  void take_back(software::Counts& traversal);
  void take_in(std::uint32_t primitive, software::Counts& counts, software::Counts& traversal);
  bool evaluated(const Sequence& sequence, software::Counts& counts);

  const PlainTree& tree_;
  std::size_t primitives_;
  Evaluate evaluate_;
  std::vector<bool> alone_;
  std::map<Sequence, Sequence> links_;  ///< of each sequence what has come next, the last one first
  std::set<Sequence> elements_;
  std::map<Sequence, bool> classes_;
  Held held_;                 ///< by the status tree
  Sequence in_;               ///< what it was changed for, in the order in which that is taken back
  std::size_t taken_in_ = 0;  ///< surfaces of the ray; of evaluations along it
};

}  // namespace csgsim::testing
