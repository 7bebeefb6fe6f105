#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "sim/software/space/box_tree.h"

namespace csgsim::software {

namespace {

/// Boxes around facets, divided by the surface area heuristic with 16 bins of box centres per axis (Wald 2007).
class Bvh final : public DirectoryOf<Bvh> {
 public:
  Bvh(const FacetShapes& shapes, const SpaceOptions& options)
      : shapes_(shapes),
        bucket_size_(options.bucket_size),
        facets_(shapes.placed().begin(), shapes.placed().end()),
        nodes_(1) {
    divide(0, 0, static_cast<std::uint32_t>(facets_.size()));
  }

  [[nodiscard]] SpaceBuilt built() const override {
    SpaceBuilt built = built_;
    built.operations = count_.done();
    count_boxes(nodes_, facets_.size(), built);
    for (const BoxNode& node : nodes_)
      built.overflows += node.low == 0 && node.end - node.begin > bucket_size_ ? 1U : 0U;
    return built;
  }

  [[nodiscard]] std::vector<SpaceBox> boxes() const override { return boxes_of(nodes_, facets_); }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& count) const {
    if (facets_.empty()) return;
    walk_boxes(
        nodes_, facets_, ray, [](std::uint32_t, Count&) {}, visitor, count);
  }

 private:
  static constexpr std::size_t bins = 16;
  struct Bin {
    facet::Box box;
    std::uint32_t facets = 0;
  };
  struct Choice {
    int axis = -1;
    std::size_t bin = 0;  ///< first bin on the upper side
    double cost = 0;
  };

  static double surface(const facet::Box& box) {
    if (box.empty()) return 0;
    const glm::dvec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }

  static std::size_t bin_of(const facet::Box& middles, int axis, double at) {
    const double part = (at - middles.low[axis]) / (middles.high[axis] - middles.low[axis]);
    return static_cast<std::size_t>(std::clamp(part * bins, 0.0, bins - 1.0));
  }

  void choose(std::uint32_t begin, std::uint32_t end, const facet::Box& middles, int axis, Choice& best) {
    std::array<Bin, bins> all;
    for (std::uint32_t i = begin; i < end; ++i) {
      const facet::Box& box = shapes_.box_of(facets_[i]);
      Bin& bin = all[bin_of(middles, axis, box.centre()[axis])];
      bin.box = bin.facets == 0 ? box : facet::hull(bin.box, box);
      ++bin.facets;
    }
    count_quotients(count_, end - begin);
    count_comparisons(count_, 6 * std::uint64_t{end - begin});
    count_products(count_, 8 * bins);
    std::array<double, bins> above{};
    Bin sum;
    for (std::size_t i = bins - 1; i > 0; --i) {
      if (all[i].facets > 0) sum.box = sum.facets == 0 ? all[i].box : facet::hull(sum.box, all[i].box);
      sum.facets += all[i].facets;
      above[i] = surface(sum.box) * sum.facets;
    }
    sum = {};
    for (std::size_t i = 1; i < bins; ++i) {
      if (all[i - 1].facets > 0) sum.box = sum.facets == 0 ? all[i - 1].box : facet::hull(sum.box, all[i - 1].box);
      sum.facets += all[i - 1].facets;
      const double cost = surface(sum.box) * sum.facets + above[i];
      if (sum.facets > 0 && sum.facets < end - begin && (best.axis < 0 || cost < best.cost)) best = {axis, i, cost};
    }
  }

  void divide(std::uint32_t number, std::uint32_t begin, std::uint32_t end) {
    facet::Box middles;
    facet::Box& box = nodes_[number].box;
    for (std::uint32_t i = begin; i < end; ++i) {
      const facet::Box& one = shapes_.box_of(facets_[i]);
      box = i == begin ? one : facet::hull(box, one);
      middles = i == begin ? facet::Box{one.centre(), one.centre()} : facet::hull(middles, one.centre());
    }
    nodes_[number].begin = begin;
    nodes_[number].end = end;
    if (end - begin <= bucket_size_) return;
    Choice best;
    for (int axis = 0; axis < 3; ++axis) {
      if (middles.high[axis] > middles.low[axis]) choose(begin, end, middles, axis, best);
    }
    if (best.axis < 0) return;
    ++built_.splits;
    const auto first = facets_.begin() + begin;
    const auto middle = std::partition(first, facets_.begin() + end, [&](std::uint32_t facet) {
      return bin_of(middles, best.axis, shapes_.box_of(facet).centre()[best.axis]) < best.bin;
    });
    const auto upper = static_cast<std::uint32_t>(middle - facets_.begin());
    const auto low = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[number].low = low;
    divide(low, begin, upper);
    divide(low + 1, upper, end);
  }

  const FacetShapes& shapes_;
  std::uint32_t bucket_size_;
  std::vector<std::uint32_t> facets_;
  std::vector<BoxNode> nodes_;
  SpaceBuilt built_;
  Counting count_;
};

}  // namespace

extern const DirectoryRow bvh_row{"bvh", "boxes around facets, divided by the surface area heuristic", "Wald 2007",
                                  make_directory<Bvh>};

}  // namespace csgsim::software
