#include "sim/software/display/faults.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace csgsim::software {

namespace {

/// No more than a step apart.
bool are_near(std::uint32_t a, std::uint32_t b) { return std::max(a, b) - std::min(a, b) <= 1; }

std::size_t events_near(std::span<const Event> exact, std::uint32_t depth) {
  return static_cast<std::size_t>(
      std::ranges::count_if(exact, [&](const Event& event) { return are_near(event.depth, depth); }));
}

}  // namespace

void Faults::add(Fault fault) {
  switch (fault) {
    case Fault::coincident: ++coincident; break;
    case Fault::three_way: ++three_way; break;
    case Fault::order: ++order; break;
  }
}

Fault fault_of(std::span<const Event> exact, std::span<const Event> drawn) {
  std::vector<Event> left(exact.begin(), exact.end());
  std::size_t most = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto place = std::ranges::find(left, drawn[i].crossing, &Event::crossing);
    if (place == left.end() || !are_near(place->depth, left.front().depth)) return Fault::order;
    if (place != left.begin() || i + 1 == drawn.size()) most = std::max(most, events_near(exact, place->depth));
    left.erase(place);
  }
  if (most < 2) return Fault::order;
  return most == 2 ? Fault::coincident : Fault::three_way;
}

}  // namespace csgsim::software
