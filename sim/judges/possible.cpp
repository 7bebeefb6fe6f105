#include "sim/judges/possible.h"

#include <algorithm>
#include <optional>
#include <span>

#include "sim/judges/truth.h"

namespace csgsim::judges {

namespace {

/// Maximum number of undecided edges whose sides are enumerated; the others stay unknown.
constexpr std::size_t max_tried_edges = 6;

Maybe least(Maybe a, Maybe b) { return std::min(a, b); }

/// The depth of a surface: the greatest (or least) of the listed planes, which are the only candidates.
struct Surface {
  bool greatest = true;
  std::vector<std::uint32_t> planes;  ///< sorted
  Steps steps;

  [[nodiscard]] bool has(std::uint32_t plane) const { return std::binary_search(planes.begin(), planes.end(), plane); }
  [[nodiscard]] bool is(std::uint32_t plane) const { return planes.size() == 1 && planes.front() == plane; }
  [[nodiscard]] bool same_as(const Surface& other) const {
    return planes == other.planes && (greatest == other.greatest || planes.size() == 1);
  }
};

Surface make_surface(std::span<const Intersection> planes, bool greatest) {
  Surface surface{greatest, {}, planes.front().steps};
  for (const Intersection& met : planes) {
    surface.steps.low =
        greatest ? std::max(surface.steps.low, met.steps.low) : std::min(surface.steps.low, met.steps.low);
    surface.steps.high =
        greatest ? std::max(surface.steps.high, met.steps.high) : std::min(surface.steps.high, met.steps.high);
  }
  for (const Intersection& met : planes) {
    const bool can_be = greatest ? met.steps.high >= surface.steps.low : met.steps.low <= surface.steps.high;
    if (can_be) surface.planes.push_back(met.plane);
  }
  std::sort(surface.planes.begin(), surface.planes.end());
  return surface;
}

/// Whether the plane is at the surface's depth or nearer, as far as known.
Maybe not_behind(const Intersection& met, const Surface& surface) {
  if (surface.is(met.plane) || (surface.greatest && surface.has(met.plane))) return Maybe::yes;
  if (met.steps.high <= surface.steps.low) return Maybe::yes;
  return met.steps.low > surface.steps.high ? Maybe::no : Maybe::unknown;
}

/// One choice of sides for the undecided edges of a ray.
class Branch {
 public:
  Branch(const model::Tree& tree, const Ray& ray, std::uint32_t sides)
      : tree_(tree), ray_(ray), sides_(sides), of_primitive_(tree.primitives.size(), nullptr) {
    for (const Candidate& candidate : ray.candidates) of_primitive_[candidate.primitive] = &candidate;
    mark_subtracted();
  }

  [[nodiscard]] bool can_show(std::uint32_t owner, std::int64_t depth) const {
    if (owner == nothing) {
      return std::none_of(ray_.candidates.begin(), ray_.candidates.end(),
                          [&](const Candidate& one) { return state(one, visible_surface(one)) == Maybe::yes; });
    }
    if (owner >= of_primitive_.size() || of_primitive_[owner] == nullptr) return false;
    const Candidate& shown = *of_primitive_[owner];
    if (shown.is_doubtful) return true;
    Surface surface = visible_surface(shown);
    if (depth < surface.steps.low || depth > surface.steps.high) return false;
    surface.steps = {depth, depth};
    if (state(shown, surface) == Maybe::no) return false;
    return std::none_of(ray_.candidates.begin(), ray_.candidates.end(),
                        [&](const Candidate& other) { return certainly_before(other, owner, surface); });
  }

 private:
  /// Whether the other primitive's surface certainly hides the one shown at that depth.
  [[nodiscard]] bool certainly_before(const Candidate& other, std::uint32_t owner, const Surface& surface) const {
    if (other.primitive == owner || other.is_doubtful) return false;
    const Surface hiding = visible_surface(other);
    const bool first = other.primitive < owner;
    const bool nearer = hiding.steps.high < surface.steps.low ||
                        (first && (hiding.steps.high <= surface.steps.low || hiding.same_as(surface)));
    return nearer && state(other, hiding) == Maybe::yes;
  }

  [[nodiscard]] Surface visible_surface(const Candidate& candidate) const {
    const bool back = subtracted_[candidate.primitive];
    return make_surface(back ? candidate.backs : candidate.fronts, !back);
  }

  /// Whether the primitive's visible surface is present and no operator removes it.
  [[nodiscard]] Maybe state(const Candidate& candidate, const Surface& surface) const {
    const Maybe there = least(on_ray(candidate), not_empty(candidate));
    return there == Maybe::no ? there : least(there, shows(candidate.primitive, surface));
  }

  [[nodiscard]] Maybe on_ray(const Candidate& candidate) const {
    Maybe result = candidate.is_doubtful ? Maybe::unknown : Maybe::yes;
    for (const EdgeUse& edge : candidate.edges) {
      const auto at = std::find(ray_.undecided_edges.begin(), ray_.undecided_edges.end(), edge.plane);
      const auto bit = static_cast<std::size_t>(at - ray_.undecided_edges.begin());
      if (bit >= max_tried_edges) {
        result = least(result, Maybe::unknown);
      } else if ((((sides_ >> bit) & 1U) != 0) != edge.positive) {
        return Maybe::no;
      }
    }
    return result;
  }

  [[nodiscard]] static Maybe not_empty(const Candidate& candidate) {
    const Surface front = make_surface(candidate.fronts, true);
    Maybe result = Maybe::yes;
    for (const Intersection& back : candidate.backs) result = least(result, opposite(not_behind(back, front)));
    return result;
  }

  [[nodiscard]] Maybe holds(const Candidate& candidate, const Surface& surface) const {
    Maybe result = on_ray(candidate);
    for (const Intersection& front : candidate.fronts) result = least(result, not_behind(front, surface));
    for (const Intersection& back : candidate.backs) result = least(result, opposite(not_behind(back, surface)));
    return result;
  }

  /// Whether all operators above the primitive are inside (outside, where they are subtracted) at the surface.
  [[nodiscard]] Maybe shows(std::uint32_t primitive, const Surface& surface) const {
    values_.assign(tree_.nodes.size(), Maybe::no);
    std::uint32_t on_path = model::no_index;
    Maybe result = Maybe::yes;
    for (std::uint32_t i = 0; i < tree_.nodes.size(); ++i) {
      const model::Node& node = tree_.nodes[i];
      bool through = false;
      if (node.is_leaf) {
        through = node.primitive == primitive;
        const Candidate* candidate = of_primitive_[node.primitive];
        if (candidate != nullptr) values_[i] = holds(*candidate, surface);
        // A solid that is present is inside at its own front and outside at its back.
        if (through) values_[i] = subtracted_[primitive] ? Maybe::no : Maybe::yes;
      } else {
        values_[i] = combine(node);
        through = std::find(node.children.begin(), node.children.end(), on_path) != node.children.end();
      }
      if (!through) continue;
      on_path = i;
      result = least(result, node_subtracted_[i] ? opposite(values_[i]) : values_[i]);
    }
    return result;
  }

  [[nodiscard]] Maybe combine(const model::Node& node) const {
    Maybe result = values_[node.children.front()];
    for (std::size_t c = 1; c < node.children.size(); ++c) {
      const Maybe other = values_[node.children[c]];
      switch (node.op) {
        case model::Operator::unite: result = std::max(result, other); break;
        case model::Operator::intersect: result = least(result, other); break;
        case model::Operator::subtract: result = least(result, opposite(other)); break;
      }
    }
    return result;
  }

  void mark_subtracted() {
    node_subtracted_.assign(tree_.nodes.size(), false);
    subtracted_.assign(tree_.primitives.size(), false);
    for (std::size_t i = tree_.nodes.size(); i-- > 0;) {
      const model::Node& node = tree_.nodes[i];
      if (node.is_leaf) subtracted_[node.primitive] = node_subtracted_[i];
      for (std::size_t c = 0; c < node.children.size(); ++c) {
        node_subtracted_[node.children[c]] = node_subtracted_[i] != (node.op == model::Operator::subtract && c > 0);
      }
    }
  }

  const model::Tree& tree_;
  const Ray& ray_;
  std::uint32_t sides_;
  std::vector<const Candidate*> of_primitive_;
  std::vector<bool> node_subtracted_;
  std::vector<bool> subtracted_;
  mutable std::vector<Maybe> values_;
};

}  // namespace

bool can_show(const model::Tree& tree, const Ray& ray, std::uint32_t owner, std::int64_t depth) {
  const std::size_t tried = std::min(ray.undecided_edges.size(), max_tried_edges);
  for (std::uint32_t sides = 0; sides < (1U << tried); ++sides) {
    if (Branch(tree, ray, sides).can_show(owner, depth)) return true;
  }
  return false;
}

}  // namespace csgsim::judges
