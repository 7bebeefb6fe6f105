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

/// Evaluates points, or finds them in a table, in the order of the rays.
class Keeper {
 public:
  explicit Keeper(Coherence& coherence) : coherence_(coherence) {}

  void look_up() { ++coherence_.looked_up; }
  void evaluate(std::size_t ray, const Point& point, bool is_anew) {
    coherence_.evaluations.push_back({ray, point.end, is_anew});
  }
  /// Coherence that keeps nothing between points.
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

/// Keeps one list: the last ray's sequence as far as followed, and the rest from earlier rays.
Coherence one_list(const std::vector<RecordedRay>& rays) {
  Coherence coherence;
  Keeper keeper(coherence);
  Sequence list;
  std::set<std::size_t> known;  ///< lengths of the list's prefixes with a known class
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

/// Places with links to others by primitive; a new link becomes the first.
template <class Place>
class Links {
 public:
  /// Returns the number of links visited to find this one; inserts it if absent.
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

/// All prefixes of the rays' sequences; the first element is found by one table lookup.
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

/// First points of the rays of 16 rows, then their second points, and so on.
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

/// Visits of a traversal over successive evaluations.
class Traversal {
 public:
  Traversal(const PlainTree& tree, std::size_t primitives, std::string name)
      : tree_(tree), held_(primitives), name_(std::move(name)) {}

  TreeVisits evaluate(const RecordedRay& ray, const Evaluation& evaluation) {
    TreeVisits tally;
    if (evaluation.is_anew) {
      for (const std::uint32_t primitive : in_) tally += changed(primitive);
      in_.clear();
      taken_in_ = 0;
    }
    for (; taken_in_ < evaluation.end; ++taken_in_) {
      const std::uint32_t primitive = ray.events[taken_in_].primitive();
      keep(primitive);
      tally += changed(primitive);
    }
    tally += evaluated();
    return tally;
  }

 private:
  /// Primitives in the order of their removal: as inserted, with the last one moved to each freed place.
  void keep(std::uint32_t primitive) {
    const auto place = std::ranges::find(in_, primitive);
    if (place == in_.end()) return in_.push_back(primitive);
    *place = in_.back();
    in_.pop_back();
  }

  TreeVisits changed(std::uint32_t primitive) {
    if (name_ == "status") return tree_.update_tree(held_, primitive);
    held_[primitive] = !held_[primitive];
    return {};
  }

  [[nodiscard]] TreeVisits evaluated() const {
    if (name_ == "status") return {};
    if (name_ == "early-out") return tree_.early_out(held_);
    if (name_ == "positional") return tree_.positional(held_);
    if (name_ == "standard" || name_ == "bit-sequential") return {tree_.nodes(), 0};
    if (name_ != "bit-parallel") throw std::invalid_argument(name_);
    // Each word of 32 bits, and the operations that combine words in pairs.
    const std::uint64_t words = tree_.levels() > 5 ? std::uint64_t{1} << (tree_.levels() - 5) : 1;
    return {2 * words - 1, 0};
  }

  const PlainTree& tree_;
  Held held_;
  std::string name_;
  Sequence in_;
  std::size_t taken_in_ = 0;
};

/// Owner at a ray's entry if several surfaces qualify: all active primitives are inserted into a status tree in the
/// order of their events and removed again.
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
    if (i >= hit.begin && event.leaves() == tree.is_subtracted(event.primitive())) {
      candidates.push_back(event.primitive());
    }
  }
  if (candidates.size() == 1) return;
  ++counts.ties;
  Held held(primitives);
  TreeVisits tally;
  for (const std::uint32_t primitive : active) tally += tree.update_tree(held, primitive);
  for (const std::uint32_t primitive : candidates) {
    if (tree.shows(held, primitive, tally)) break;
  }
  for (const std::uint32_t primitive : active) tally += tree.update_tree(held, primitive);
  counts.node_visits += tally.visits;
  counts.early_outs += tally.early_outs;
}

}  // namespace

std::vector<std::uint32_t> RecordedRay::sequence(std::size_t end) const {
  Sequence sequence;
  for (std::size_t i = 0; i < end; ++i) sequence.push_back(events[i].primitive());
  return sequence;
}

std::vector<RecordedRay> record_rays(const software::RayCaster& rays, const std::vector<Seen>& seen,
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

software::Survey survey_rays(const std::vector<RecordedRay>& rays) {
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

software::Counts recount_traversal(const PlainTree& tree, std::size_t primitives, const std::string& traversal,
                                   const Coherence& coherence, const std::vector<RecordedRay>& rays) {
  software::Counts counts;
  counts.evaluations = coherence.evaluations.size();
  counts.looked_up = coherence.looked_up;
  counts.list_elements = coherence.list_elements;
  counts.list_steps = coherence.list_steps;
  TreeVisits tally;
  Traversal traversed(tree, primitives, traversal);
  for (const Evaluation& one : coherence.evaluations) tally += traversed.evaluate(rays[one.ray], one);
  if (coherence.looks_up_first) {
    counts.precomputed = primitives;
    Held held(primitives);
    // Insertion and removal.
    for (std::uint32_t primitive = 0; primitive < primitives; ++primitive) {
      tally += tree.update_tree(held, primitive);
      tally += tree.update_tree(held, primitive);
    }
  }
  counts.node_visits = tally.visits;
  counts.early_outs = tally.early_outs;
  for (const RecordedRay& ray : rays) {
    counts.points += ray.points.size();
    if (ray.hits) count_tie(tree, primitives, ray, counts);
  }
  return counts;
}

}  // namespace csgsim::testing
