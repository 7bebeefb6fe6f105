#pragma once

#include <cstdint>
#include <map>

#include "sim/checkpoint/snapshot.h"

namespace csgsim::debug {

/// States of a run in memory, to go back to. They are farther apart the longer the run is, so that their memory is
/// bounded.
class History {
 public:
  /// Number of the next instruction at which a state should be kept, if the run is at `number`.
  [[nodiscard]] std::uint64_t due(std::uint64_t number) const { return (number / stride_ + 1) * stride_; }

  /// Whether one kept near before that number serves as well.
  [[nodiscard]] bool is_kept(std::uint64_t number) const;

  /// Keeps the state before that instruction.
  void keep(std::uint64_t number, checkpoint::Snapshot snapshot);

  /// The last state kept at that number or before it. One has to be kept at the first from which anybody goes back.
  [[nodiscard]] const checkpoint::Snapshot& before(std::uint64_t number) const;

  void clear() { kept_.clear(); }
  [[nodiscard]] std::size_t size() const { return kept_.size(); }

 private:
  std::map<std::uint64_t, checkpoint::Snapshot> kept_;
  std::uint64_t stride_ = 256;
};

}  // namespace csgsim::debug
