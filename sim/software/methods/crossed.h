// Methods that combine a traversal with a coherence.
// Used by the rows of traversals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/software/coherences/all_points.h"
#include "sim/software/coherences/csg_buffer.h"
#include "sim/software/coherences/first_point.h"
#include "sim/software/coherences/joined_lists.h"
#include "sim/software/coherences/list_structure.h"
#include "sim/software/coherences/one_list.h"
#include "sim/software/cost/operations.h"
#include "sim/software/methods/evaluations.h"
#include "sim/software/methods/method.h"
#include "sim/software/methods/rows.h"
#include "sim/software/tree/owners.h"

namespace csgsim::software {

/// Index after the last event at the depth of event `begin`.
template <class Count>
std::size_t end_of_point(std::span<const Event> events, std::size_t begin, Count& count) {
  std::size_t end = begin + 1;
  while (end < events.size() && events[end].depth == events[begin].depth) ++end;
  count.point();
  count(Operation::load_long, 1 + end - begin);
  count(Operation::compare_long, end - begin);
  count(Operation::branch, end - begin);
  return end;
}

/// A method that applies a traversal and a coherence to a picture's rays.
template <class Traversal, class Coherence, class Count>
class Crossed : public Method {
 public:
  explicit Crossed(const Subject& subject)
      : subject_(subject), evaluations_(subject_, count_), coherence_(subject.tree, count_), owners_(subject.tree) {
    if constexpr (requires { Coherence::goes_by_layers; }) {
      coherence_.set_pixels(std::uint64_t{subject.view.sampling.width} * subject.view.sampling.height);
    }
  }

  void classify(const RayBand& band, std::span<VisibleSurface> seen) override {
    evaluations_.begin_band(band);
    if constexpr (requires { Coherence::goes_by_layers; }) {
      classify_by_layers(band, seen);
    } else {
      for (std::size_t ray = 0; ray < seen.size(); ++ray) seen[ray] = seen_along(ray, band.events_of(ray));
    }
  }

  [[nodiscard]] Counts counts() const override {
    Counts counts = count_.counts_so_far();
    counts.words = evaluations_.words() + coherence_.words();
    return counts;
  }

 private:
  [[nodiscard]] VisibleSurface nothing() const { return {subject_.farthest(), VisibleSurface::nothing_seen}; }

  VisibleSurface seen_at(std::span<const Event> events, std::size_t begin, std::size_t end) {
    return {events[begin].depth,
            owners_.visible_owner(events.first(begin), events.subspan(begin, end - begin), count_)};
  }

  VisibleSurface seen_along(std::size_t ray, std::span<const Event> events) {
    if (events.empty()) return nothing();
    evaluations_.begin_ray(ray, events);
    coherence_.begin_ray();
    for (std::size_t begin = 0; begin < events.size();) {
      const std::size_t end = end_of_point(events, begin, count_);
      if (coherence_.is_in(
              events, begin, end, [&] { return evaluations_.after(end); }, count_))
        return seen_at(events, begin, end);
      begin = end;
    }
    return nothing();
  }

  /// Progress of a pixel.
  struct Pixel {
    std::uint32_t ray;
    std::uint32_t element;
    std::size_t begin;
  };

  void classify_by_layers(const RayBand& band, std::span<VisibleSurface> seen) {
    std::vector<Pixel> open;
    for (std::uint32_t ray = 0; ray < seen.size(); ++ray) {
      seen[ray] = nothing();
      if (!band.events_of(ray).empty()) open.push_back({ray, ListElements<Count>::none, 0});
    }
    while (!open.empty()) {
      std::erase_if(open, [&](Pixel& pixel) { return is_done(pixel, band.events_of(pixel.ray), seen[pixel.ray]); });
    }
  }

  /// Processes a pixel's next surfaces; returns whether the pixel is finished.
  bool is_done(Pixel& pixel, std::span<const Event> events, VisibleSurface& seen) {
    const std::size_t begin = pixel.begin;
    const std::size_t end = end_of_point(events, begin, count_);
    count_(Operation::load_long);
    for (std::size_t i = begin; i < end; ++i)
      pixel.element = coherence_.after(pixel.element, events[i].primitive(), count_);
    count_(Operation::store_long);
    const auto evaluate = [&] {
      coherence_.count_walk_back(end, count_);
      evaluations_.begin_ray(pixel.ray, events);
      return evaluations_.after(end);
    };
    pixel.begin = end;
    if (!coherence_.is_in(pixel.element, is_first_alone(begin, end), evaluate, count_)) return end == events.size();
    seen = seen_at(events, begin, end);
    return true;
  }

  Subject subject_;
  Count count_;
  Evaluations<Traversal, Count> evaluations_;
  Coherence coherence_;
  Owners<Count> owners_;
};

/// Creates the method that combines a traversal with the given coherence.
template <template <class> class Traversal, class Count>
std::unique_ptr<Method> make_crossed_with(Coherent coherence, const Subject& subject) {
  using T = Traversal<Count>;
  switch (coherence) {
    case Coherent::all_points: return std::make_unique<Crossed<T, AllPoints<Count>, Count>>(subject);
    case Coherent::first_point: return std::make_unique<Crossed<T, FirstPoint<Count>, Count>>(subject);
    case Coherent::one_list: return std::make_unique<Crossed<T, OneList<Count>, Count>>(subject);
    case Coherent::list_structure: return std::make_unique<Crossed<T, ListStructure<Count>, Count>>(subject);
    case Coherent::joined_lists: return std::make_unique<Crossed<T, JoinedLists<Count>, Count>>(subject);
    case Coherent::csg_buffer: return std::make_unique<Crossed<T, CsgBuffer<Count>, Count>>(subject);
  }
  return nullptr;
}

/// Creates the method that combines a traversal with the given coherence; with `counts`, it counts operations.
template <template <class> class Traversal>
std::unique_ptr<Method> make_crossed(Coherent coherence, const Subject& subject, bool counts) {
  return counts ? make_crossed_with<Traversal, CountingMethod>(coherence, subject)
                : make_crossed_with<Traversal, UncountedMethod>(coherence, subject);
}

}  // namespace csgsim::software
