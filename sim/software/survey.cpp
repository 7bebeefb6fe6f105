#include "sim/software/survey.h"

#include <algorithm>
#include <cstddef>

#include "hw/base/hash.h"

namespace csgsim::software {

std::size_t Surveyor::Hash::operator()(const std::vector<std::uint32_t>& sequence) const {
  csgsim::Hash hash;
  hash.add(sequence);
  return hash.value();
}

void Surveyor::add(const RayBand& band, std::span<const VisibleSurface> seen) {
  for (std::size_t ray = 0; ray < band.rays(); ++ray) add_ray(band.events_of(ray), seen[ray]);
}

void Surveyor::add_ray(std::span<const Event> events, const VisibleSurface& seen) {
  ++survey_.rays;
  if (events.empty()) return;
  ++survey_.met;
  if (seen.owner != VisibleSurface::nothing_seen) ++survey_.hits;
  sequence_.clear();
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < events.size() && events[i].depth <= seen.depth; ++i) {
    if (i == 0 || events[i].depth != events[i - 1].depth) ++points;
    sequence_.push_back(events[i].primitive());
  }
  survey_.points += points;
  survey_.max_points = std::max(survey_.max_points, points);
  if (survey_.sequences > 0 && sequence_ == last_) return;
  ++survey_.sequences;
  last_ = sequence_;
  if (!found_.insert(sequence_).second) return;
  std::ranges::sort(sequence_);
  sequence_.erase(std::unique(sequence_.begin(), sequence_.end()), sequence_.end());
  combinations_.insert(sequence_);
}

Survey Surveyor::result() const {
  Survey survey = survey_;
  survey.different_sequences = found_.size();
  survey.combinations = combinations_.size();
  return survey;
}

}  // namespace csgsim::software
