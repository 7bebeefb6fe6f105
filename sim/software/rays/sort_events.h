// Sorting of events along rays.
// Used by the ray caster.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/software/cost/operations.h"
#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Rays with more events are sorted with std::sort.
inline constexpr std::size_t max_inserted = 32;

/// Insertion sort: rays have few events, and primitives that are close in the tree are close in depth.
template <class Count>
void insertion_sort(std::span<Event> events, Count& count) {
  for (std::size_t i = 1; i < events.size(); ++i) {
    const Event event = events[i];
    count(Operation::load_long, 2);
    std::size_t place = i;
    while (place > 0 && event < events[place - 1]) {
      events[place] = events[place - 1];
      --place;
      count(Operation::load_long, 2);
      count(Operation::compare_long);
      count(Operation::store_long, 2);
      count(Operation::branch_taken, 2);
    }
    events[place] = event;
    count(Operation::load_long);
    count(Operation::compare_long);
    count(Operation::branch);
    count(Operation::store_long, 2);
  }
}

/// std::sort, with each comparison counted.
template <class Count>
void standard_sort(std::span<Event> events, Count& count) {
  std::ranges::sort(events, [&](const Event& a, const Event& b) {
    count(Operation::load_long, 2);
    count(Operation::compare_long);
    count(Operation::branch_taken);
    count(Operation::store_long);
    return a < b;
  });
}

/// Computes the sorted events of a band's intervals. Leaving a primitive at `farthest` is not an event.
template <class Count>
void sort_events(RayBand& band, std::uint32_t farthest, Count& count) {
  band.events.clear();
  band.event_begins.assign(1, 0);
  for (std::size_t ray = 0; ray < band.rays(); ++ray) {
    const std::size_t begin = band.events.size();
    for (const Interval& interval : band.intervals_of(ray)) {
      band.events.push_back({interval.front, 2 * interval.primitive});
      if (interval.back < farthest) band.events.push_back({interval.back, 2 * interval.primitive + 1});
      count(Operation::load_long, 2);
      count(Operation::load);
      count(Operation::store_long, 2);
      count(Operation::store, 2);
    }
    const std::span<Event> events = std::span(band.events).subspan(begin);
    if (events.size() <= max_inserted) {
      insertion_sort(events, count);
    } else {
      standard_sort(events, count);
    }
    band.event_begins.push_back(band.events.size());
  }
}

}  // namespace csgsim::software
