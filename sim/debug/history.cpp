#include "sim/debug/history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace csgsim::debug {

namespace {

constexpr std::uint64_t max_bytes = std::uint64_t{256} << 20U;
constexpr std::uint64_t max_kept = 32;

std::uint64_t bytes_of(const checkpoint::Snapshot& snapshot) {
  std::uint64_t bytes = 0;
  for (const std::vector<std::uint64_t>& plane : snapshot.run.planes) bytes += plane.size() * sizeof(std::uint64_t);
  const observe::Frame& frame = snapshot.picture.frame;
  for (const std::vector<std::uint32_t>* values :
       {&frame.colour, &frame.depth, &frame.owner, &snapshot.picture.candidate_owner, &frame.opaque_depth,
        &frame.opaque_owner, &snapshot.picture.panes.owner, &snapshot.picture.panes.depth})
    bytes += values->size() * sizeof(std::uint32_t);
  return bytes;
}

}  // namespace

bool History::has_recent_save(std::uint64_t number) const {
  const auto after = kept_.upper_bound(number);
  return after != kept_.begin() && number - std::prev(after)->first < stride_;
}

void History::save_state(std::uint64_t number, checkpoint::Snapshot snapshot) {
  const std::uint64_t fit = max_bytes / std::max<std::uint64_t>(bytes_of(snapshot), 1);
  kept_.insert_or_assign(number, std::move(snapshot));
  while (kept_.size() > std::clamp<std::uint64_t>(fit, 2, max_kept)) {
    stride_ *= 2;
    // Keep the first, and of the others those at least a stride apart.
    std::uint64_t last = kept_.begin()->first;
    std::erase_if(kept_, [&, is_first = true](const auto& one) mutable {
      const bool stays = std::exchange(is_first, false) || one.first - last >= stride_;
      if (stays) last = one.first;
      return !stays;
    });
  }
}

const checkpoint::Snapshot& History::latest_at(std::uint64_t number) const {
  return std::prev(kept_.upper_bound(number))->second;
}

}  // namespace csgsim::debug
