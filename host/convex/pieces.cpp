#include "host/convex/pieces.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "host/convex/merge.h"
#include "host/convex/outside.h"
#include "host/convex/solid_products.h"
#include "hw/base/error.h"

namespace csgsim::convex {

namespace {

/// A convex part of a product, and the primitives still to be subtracted from it.
struct Part {
  Polytope polytope;
  /// Primitives whose boxes intersect the part's; the last one is subtracted first.
  std::vector<std::uint32_t> subtracted;
};

class Division {
 public:
  Division(const facet::Geometry& geometry, std::size_t max_count, const Work& work)
      : geometry_(geometry), max_count_(max_count), work_(work) {
    for (const facet::Convex& solid : geometry.solids) {
      boxes_.push_back({solid.box.low - geometry.planes.centre(), solid.box.high - geometry.planes.centre()});
    }
  }

  /// Divides the next product.
  void add(SolidProduct product) {
    std::vector<Polytope> done;
    std::reverse(product.subtracted.begin(), product.subtracted.end());
    open_.push_back({std::move(product.whole), std::move(product.subtracted)});
    while (!open_.empty()) {
      Part part = std::move(open_.back());
      open_.pop_back();
      if (part.subtracted.empty()) {
        done.push_back(std::move(part.polytope));
      } else {
        subtract(std::move(part));
      }
      require_few(pieces_.size() + done.size() + open_.size());
    }
    merge(done, geometry_.planes, work_);
    for (Polytope& polytope : done) pieces_.push_back({std::move(polytope), product.primitive, product_});
    if (!done.empty()) ++product_;
  }

  [[nodiscard]] std::vector<Piece> take() { return std::move(pieces_); }

 private:
  void require_few(std::size_t count) const {
    if (count > max_count_) {
      throw InputError("the model needs more than " + std::to_string(max_count_) +
                       " convex pieces; use fewer facets ($fn) for the subtracted solids, or subtract fewer");
    }
  }

  /// Subtracts the last of the part's primitives from it.
  void subtract(Part part) {
    const facet::Convex& solid = geometry_.solids[part.subtracted.back()];
    part.subtracted.pop_back();
    for (Polytope& polytope : outside(std::move(part.polytope), solid, geometry_.planes, work_))
      open(std::move(polytope), part.subtracted);
  }

  void open(Polytope polytope, const std::vector<std::uint32_t>& subtracted) {
    work_.charge(polytope.vertices.size() + 4 * subtracted.size(), "subtracting solids from convex pieces");
    const facet::Box box = box_of(polytope);
    Part part{std::move(polytope), {}};
    std::copy_if(subtracted.begin(), subtracted.end(), std::back_inserter(part.subtracted),
                 [&](std::uint32_t primitive) { return !common(boxes_[primitive], box).empty(); });
    open_.push_back(std::move(part));
  }

  const facet::Geometry& geometry_;
  std::size_t max_count_;
  const Work& work_;
  std::vector<facet::Box> boxes_;  ///< boxes of the primitives, relative to PlaneTable::centre()
  std::vector<Part> open_;
  std::vector<Piece> pieces_;
  std::uint32_t product_ = 0;
};

}  // namespace

std::vector<Piece> pieces(const facet::Geometry& geometry, const csg::PositiveTree& tree, std::size_t max_count,
                          const Work& work) {
  Division division(geometry, max_count, work);
  for_each_product(
      geometry, tree, [&](SolidProduct product) { division.add(std::move(product)); }, max_operands, work);
  return division.take();
}

}  // namespace csgsim::convex
