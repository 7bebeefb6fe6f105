// Saved states for stepping back.
// Used by session.h.
#pragma once

#include <cstdint>
#include <map>

#include "sim/checkpoint/snapshot.h"

namespace csgsim::debug {

/// Saved states of a run, for stepping back. The distance between saved states grows with the length of the run, so
/// that their memory is bounded.
class History {
 public:
  /// Number of the next instruction at which a state should be saved, if the run is at `number`.
  [[nodiscard]] std::uint64_t next_save_number(std::uint64_t number) const { return (number / stride_ + 1) * stride_; }

  /// Whether a state was saved at that number, or less than one stride earlier.
  [[nodiscard]] bool has_recent_save(std::uint64_t number) const;

  /// Stores the state at the boundary in front of that instruction.
  void save_state(std::uint64_t number, checkpoint::Snapshot snapshot);

  /// The saved state with the greatest number that does not exceed `number`. There must be one.
  [[nodiscard]] const checkpoint::Snapshot& latest_at(std::uint64_t number) const;

  void clear() { kept_.clear(); }
  [[nodiscard]] std::size_t size() const { return kept_.size(); }

 private:
  std::map<std::uint64_t, checkpoint::Snapshot> kept_;
  std::uint64_t stride_ = 256;
};

}  // namespace csgsim::debug
