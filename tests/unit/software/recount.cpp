#include "tests/unit/software/recount.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace csgsim::testing {

namespace {

using software::Event;
using Sequence = std::vector<std::uint32_t>;
using Active = std::set<std::uint32_t>;

bool is_first_alone(const Point& point) { return point.begin == 0 && point.end == 1; }

void flip(Active& active, std::uint32_t primitive) {
  if (!active.insert(primitive).second) active.erase(primitive);
}

/// Evaluates or looks up points in the order in which they come.
class Keeper {
 public:
  explicit Keeper(Coherence& coherence) : coherence_(coherence) {}

  void look_up() { ++coherence_.looked_up; }
  void evaluate(std::size_t ray, const Point& point, bool is_anew) {
    coherence_.evaluations.push_back({ray, point.end, is_anew});
  }
  /// Of a point that nothing is kept of.
  void find_out(std::size_t ray, const Point& point) {
    if (is_first_alone(point)) return look_up();
    const bool is_anew = coherence_.evaluations.empty() || coherence_.evaluations.back().ray != ray;
    evaluate(ray, point, is_anew);
  }

 private:
  Coherence& coherence_;
};

Coherence all_points(const std::vector<RecordedRay>& rays) {
  Coherence coherence;
  Keeper keeper(coherence);
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    for (const Point& point : rays[ray].points) keeper.evaluate(ray, point, point.begin == 0);
  }
  return coherence;
}

Coherence first_point(const std::vector<RecordedRay>& rays) {
  Coherence coherence;
  Keeper keeper(coherence);
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    for (const Point& point : rays[ray].points) keeper.find_out(ray, point);
  }
  return coherence;
}

/// The list is what the last ray had, as far as it has been followed, with what comes behind from rays before it.
Coherence one_list(const std::vector<RecordedRay>& rays) {
  Coherence coherence;
  Keeper keeper(coherence);
  Sequence list;
  std::set<std::size_t> known;  ///< lengths of beginnings of the list whose class is in it
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    for (const Point& point : rays[ray].points) {
      const Sequence sequence = rays[ray].sequence(point.end);
      const auto same = static_cast<std::size_t>(
          std::mismatch(list.begin(), list.end(), sequence.begin(), sequence.end()).first - list.begin());
      const std::size_t read = std::max(same, point.begin) - point.begin;
      coherence.list_steps += read;
      coherence.list_elements += point.end - point.begin - read;
      if (same < sequence.size()) {
        list = sequence;
        known.erase(known.upper_bound(same), known.end());
      }
      if (known.insert(point.end).second) {
        keeper.find_out(ray, point);
      } else {
        keeper.look_up();
      }
    }
  }
  return coherence;
}

/// Places that have links to others by primitive, of which a new one becomes the first.
template <class Place>
class Links {
 public:
  /// How many links are looked at to find that one, which is made where there is none.
  std::uint64_t follow(const Place& from, std::uint32_t primitive) {
    Sequence& links = links_[from];
    const auto found = std::ranges::find(links, primitive);
    if (found != links.end()) return static_cast<std::uint64_t>(found - links.begin()) + 1;
    const std::uint64_t looked_at = links.size();
    links.insert(links.begin(), primitive);
    return looked_at;
  }

 private:
  std::map<Place, Sequence> links_;
};

/// All beginnings of sequences that rays have had; the first element is found in a table, by one look.
class Sequences {
 public:
  explicit Sequences(Coherence& coherence) : coherence_(coherence), keeper_(coherence) {}

  void pass(std::size_t number, const RecordedRay& ray, const Point& point, bool always_anew) {
    for (std::size_t i = point.begin; i < point.end; ++i) {
      const Sequence before = ray.sequence(i);
      if (before.empty()) {
        ++coherence_.list_steps;
      } else {
        coherence_.list_steps += links_.follow(before, ray.events[i].primitive());
      }
      elements_.insert(ray.sequence(i + 1));
    }
    coherence_.list_elements = elements_.size();
    if (!known_.insert(ray.sequence(point.end)).second) return keeper_.look_up();
    if (always_anew && !is_first_alone(point)) return keeper_.evaluate(number, point, true);
    keeper_.find_out(number, point);
  }

 private:
  Coherence& coherence_;
  Keeper keeper_;
  Links<Sequence> links_;
  std::set<Sequence> elements_;
  std::set<Sequence> known_;
};

Coherence list_structure(const std::vector<RecordedRay>& rays) {
  Coherence coherence;
  Sequences sequences(coherence);
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    for (const Point& point : rays[ray].points) sequences.pass(ray, rays[ray], point, false);
  }
  return coherence;
}

/// The first points of the rays of 16 rows, then the second ones, and so on.
Coherence csg_buffer(const std::vector<RecordedRay>& rays, std::size_t width) {
  Coherence coherence;
  Sequences sequences(coherence);
  for (std::size_t first = 0; first < rays.size(); first += 16 * width) {
    const std::size_t behind = std::min(first + 16 * width, rays.size());
    bool is_open = true;
    for (std::size_t layer = 0; is_open; ++layer) {
      is_open = false;
      for (std::size_t ray = first; ray < behind; ++ray) {
        if (layer >= rays[ray].points.size()) continue;
        is_open = true;
        sequences.pass(ray, rays[ray], rays[ray].points[layer], true);
      }
    }
  }
  return coherence;
}

Coherence joined_lists(const std::vector<RecordedRay>& rays) {
  Coherence coherence;
  Keeper keeper(coherence);
  Links<Active> links;
  std::set<Active> elements{{}};
  std::set<Active> known{{}};
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    Active active;
    for (const Point& point : rays[ray].points) {
      for (std::size_t i = point.begin; i < point.end; ++i) {
        const std::uint32_t primitive = rays[ray].events[i].primitive();
        // The empty set has an array of links.
        coherence.list_steps += active.empty() ? 1 : links.follow(active, primitive);
        flip(active, primitive);
        elements.insert(active);
      }
      if (known.insert(active).second) {
        keeper.find_out(ray, point);
      } else {
        keeper.look_up();
      }
    }
  }
  coherence.list_elements = elements.size() - 1;
  return coherence;
}

/// What a traversal looks at, evaluation after evaluation.
class Traversal {
 public:
  Traversal(const PlainTree& tree, std::size_t primitives, std::string name)
      : tree_(tree), held_(primitives), name_(std::move(name)) {}

  Looks evaluate(const RecordedRay& ray, const Evaluation& evaluation) {
    Looks looks;
    if (evaluation.is_anew) {
      for (const std::uint32_t primitive : in_) looks += changed(primitive);
      in_.clear();
      taken_in_ = 0;
    }
    for (; taken_in_ < evaluation.end; ++taken_in_) {
      const std::uint32_t primitive = ray.events[taken_in_].primitive();
      keep(primitive);
      looks += changed(primitive);
    }
    looks += evaluated();
    return looks;
  }

 private:
  /// In the order in which they are taken back: as they came, with the last one in the place of one that was left.
  void keep(std::uint32_t primitive) {
    const auto place = std::ranges::find(in_, primitive);
    if (place == in_.end()) return in_.push_back(primitive);
    *place = in_.back();
    in_.pop_back();
  }

  Looks changed(std::uint32_t primitive) {
    if (name_ == "status") return tree_.change(held_, primitive);
    held_[primitive] = !held_[primitive];
    return {};
  }

  [[nodiscard]] Looks evaluated() const {
    if (name_ == "status") return {};
    if (name_ == "early-out") return tree_.early_out(held_);
    if (name_ == "positional") return tree_.positional(held_);
    if (name_ == "standard" || name_ == "bit-sequential") return {tree_.nodes(), 0};
    if (name_ != "bit-parallel") throw std::invalid_argument(name_);
    // Each word of 32 bits, and what puts them together in pairs.
    const std::uint64_t words = tree_.levels() > 5 ? std::uint64_t{1} << (tree_.levels() - 5) : 1;
    return {2 * words - 1, 0};
  }

  const PlainTree& tree_;
  Held held_;
  std::string name_;
  Sequence in_;
  std::size_t taken_in_ = 0;
};

/// The owner where a ray gets in, if several surfaces could be it: all that are active are put into a status tree in
/// the order in which they were met, and taken out again.
void count_tie(const PlainTree& tree, std::size_t primitives, const RecordedRay& ray, software::Counts& counts) {
  Sequence active;
  Sequence candidates;
  const Point& hit = ray.points.back();
  for (std::size_t i = 0; i < hit.end; ++i) {
    const Event& event = ray.events[i];
    if (event.leaves()) {
      std::erase(active, event.primitive());
    } else {
      active.push_back(event.primitive());
    }
    if (i >= hit.begin && event.leaves() == tree.is_taken_away(event.primitive())) {
      candidates.push_back(event.primitive());
    }
  }
  if (candidates.size() == 1) return;
  ++counts.ties;
  Held held(primitives);
  Looks looks;
  for (const std::uint32_t primitive : active) looks += tree.change(held, primitive);
  for (const std::uint32_t primitive : candidates) {
    if (tree.shows(held, primitive, looks)) break;
  }
  for (const std::uint32_t primitive : active) looks += tree.change(held, primitive);
  counts.node_visits += looks.visits;
  counts.early_outs += looks.early_outs;
}

}  // namespace

std::vector<std::uint32_t> RecordedRay::sequence(std::size_t end) const {
  Sequence sequence;
  for (std::size_t i = 0; i < end; ++i) sequence.push_back(events[i].primitive());
  return sequence;
}

std::vector<RecordedRay> recorded(const software::RayCaster& rays, const std::vector<Seen>& seen,
                                  software::RayCounts& counts) {
  std::vector<RecordedRay> all;
  software::RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band, &counts);
    for (std::size_t ray = 0; ray < band.rays(); ++ray) {
      RecordedRay one;
      const auto events = band.events_of(ray);
      one.events.assign(events.begin(), events.end());
      const Seen& by_rules = seen[all.size()];
      one.hits = by_rules.owner != 0xffffffffU;
      for (std::size_t i = 0; i < events.size() && events[i].depth <= by_rules.depth; ++i) {
        if (i == 0 || events[i].depth != events[i - 1].depth) one.points.push_back({i, i});
        one.points.back().end = i + 1;
      }
      all.push_back(one);
    }
  }
  return all;
}

software::Survey surveyed(const std::vector<RecordedRay>& rays) {
  software::Survey survey;
  std::vector<Sequence> of_rays;
  for (const RecordedRay& ray : rays) {
    ++survey.rays;
    survey.points += ray.points.size();
    survey.max_points = std::max<std::uint64_t>(survey.max_points, ray.points.size());
    survey.hits += ray.hits ? 1U : 0U;
    if (ray.events.empty()) continue;
    ++survey.met;
    of_rays.push_back(ray.sequence(ray.end()));
  }
  survey.different_sequences = std::set<Sequence>(of_rays.begin(), of_rays.end()).size();
  std::set<Active> combinations;
  for (const Sequence& sequence : of_rays) combinations.emplace(sequence.begin(), sequence.end());
  survey.combinations = combinations.size();
  of_rays.erase(std::unique(of_rays.begin(), of_rays.end()), of_rays.end());
  survey.sequences = of_rays.size();
  return survey;
}

Coherence coherence_of(const std::string& name, const std::vector<RecordedRay>& rays, std::size_t width) {
  if (name == "all-points") return all_points(rays);
  Coherence coherence;
  if (name == "first-point") coherence = first_point(rays);
  if (name == "one-list") coherence = one_list(rays);
  if (name == "list-structure") coherence = list_structure(rays);
  if (name == "joined-lists") coherence = joined_lists(rays);
  if (name == "csg-buffer") coherence = csg_buffer(rays, width);
  coherence.looks_up_first = true;
  return coherence;
}

software::Counts recounted(const PlainTree& tree, std::size_t primitives, const std::string& traversal,
                           const Coherence& coherence, const std::vector<RecordedRay>& rays) {
  software::Counts counts;
  counts.evaluations = coherence.evaluations.size();
  counts.looked_up = coherence.looked_up;
  counts.list_elements = coherence.list_elements;
  counts.list_steps = coherence.list_steps;
  Looks looks;
  Traversal traversed(tree, primitives, traversal);
  for (const Evaluation& one : coherence.evaluations) looks += traversed.evaluate(rays[one.ray], one);
  if (coherence.looks_up_first) {
    counts.precomputed = primitives;
    Held held(primitives);
    // In and out again.
    for (std::uint32_t primitive = 0; primitive < primitives; ++primitive) {
      looks += tree.change(held, primitive);
      looks += tree.change(held, primitive);
    }
  }
  counts.node_visits = looks.visits;
  counts.early_outs = looks.early_outs;
  for (const RecordedRay& ray : rays) {
    counts.points += ray.points.size();
    if (ray.hits) count_tie(tree, primitives, ray, counts);
  }
  return counts;
}

}  // namespace csgsim::testing
