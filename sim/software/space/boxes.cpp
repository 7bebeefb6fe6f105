#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/software/space/box_tree.h"

namespace csgsim::software {

namespace {

/// A tree of boxes around primitives, divided at the median along the longest axis. A primitive's box is expanded in
/// the same way, down to single facets, when a ray first enters it (Rubin and Whitted 1980; thesis 5.1.1).
class Boxes final : public DirectoryOf<Boxes> {
 public:
  Boxes(const FacetShapes& shapes, const SpaceOptions& /*options*/) : shapes_(shapes), nodes_(1), is_open_(1) {
    const Facets& facets = shapes.facets();
    std::vector<Group> groups;
    for (std::size_t i = 0; i + 1 < facets.of_primitives.size(); ++i) {
      Group group;
      group.begin = static_cast<std::uint32_t>(facets_.size());
      for (std::size_t facet = facets.of_primitives[i]; facet < facets.of_primitives[i + 1]; ++facet) {
        const auto number = static_cast<std::uint32_t>(facet);
        if (!facets.corners_of(number).empty()) add(number, group);
      }
      group.end = static_cast<std::uint32_t>(facets_.size());
      if (group.begin < group.end) groups.push_back(group);
    }
    divide(0, groups, 0, groups.size(), false);
  }

  [[nodiscard]] SpaceBuilt built() const override {
    SpaceBuilt built = built_;
    built.operations = count_.done();
    count_boxes(nodes_, facets_.size(), built);
    return built;
  }

  [[nodiscard]] std::vector<SpaceBox> boxes() const override { return boxes_of(nodes_, facets_); }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    if (facets_.empty()) return;
    walk_boxes(
        nodes_, facets_, ray, [this](std::uint32_t node, Count&) { expand(node); }, visitor, count);
  }

 private:
  /// The content of a box: a primitive's facets, or one facet.
  struct Group {
    facet::Box box;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  void add(std::uint32_t facet, Group& group) {
    facets_.push_back(facet);
    const facet::Box& box = shapes_.box_of(facet);
    group.box = facets_.size() - 1 == group.begin ? box : facet::hull(group.box, box);
    count_comparisons(count_, 6);
  }

  void expand(std::uint32_t number) const {
    if (is_open_[number] != 0) return;
    std::vector<Group> groups;
    for (std::uint32_t i = nodes_[number].begin; i < nodes_[number].end; ++i)
      groups.push_back({shapes_.box_of(facets_[i]), i, i + 1});
    divide(number, groups, 0, groups.size(), true);
  }

  void divide(std::uint32_t number, std::vector<Group>& groups, std::size_t begin, std::size_t end,
              bool are_facets) const {
    if (begin == end) return;
    facet::Box box = groups[begin].box;
    for (std::size_t i = begin + 1; i < end; ++i) box = facet::hull(box, groups[i].box);
    count_comparisons(count_, 6 * (end - begin));
    nodes_[number].box = box;
    is_open_[number] = 1;
    if (end - begin == 1) {
      nodes_[number].begin = groups[begin].begin;
      nodes_[number].end = groups[begin].end;
      is_open_[number] = are_facets || groups[begin].end - groups[begin].begin == 1 ? 1 : 0;
      return;
    }
    const glm::dvec3 size = box.high - box.low;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return groups.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Group& a, const Group& b) {
      const double to_a = a.box.centre()[axis];
      const double to_b = b.box.centre()[axis];
      return to_a != to_b ? to_a < to_b : a.begin < b.begin;
    });
    count_comparisons(count_, 3 * (end - begin));
    ++built_.splits;
    const auto low = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    is_open_.resize(nodes_.size());
    nodes_[number].low = low;
    divide(low, groups, begin, middle, are_facets);
    divide(low + 1, groups, middle, end, are_facets);
  }

  const FacetShapes& shapes_;
  // The tree grows while rays are traced.
  mutable std::vector<std::uint32_t> facets_;
  mutable std::vector<BoxNode> nodes_;
  mutable std::vector<char> is_open_;  ///< whether a node is fully expanded
  mutable SpaceBuilt built_;
  mutable Counting count_;
};

}  // namespace

extern const DirectoryRow boxes_row{"boxes", "boxes around primitives, expanded to facets when a ray enters them",
                                    "Rubin and Whitted 1980; Jansen 1987, 5.1.1", make_directory<Boxes>};

}  // namespace csgsim::software
