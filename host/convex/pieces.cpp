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

/// A convex part of a product, and what has yet to be taken away from it.
struct Part {
  Polytope polytope;
  std::vector<std::uint32_t> taken_away;  ///< their boxes meet the part's; the last one goes first
};

class Division {
 public:
  Division(const facet::Geometry& geometry, std::size_t most, const Work& work)
      : geometry_(geometry), most_(most), work_(work) {
    for (const facet::Convex& solid : geometry.solids) {
      boxes_.push_back({solid.box.low - geometry.planes.centre(), solid.box.high - geometry.planes.centre()});
    }
  }

  /// Divides the next product.
  void add(SolidProduct product) {
    std::vector<Polytope> done;
    std::reverse(product.taken_away.begin(), product.taken_away.end());
    open_.push_back({std::move(product.whole), std::move(product.taken_away)});
    while (!open_.empty()) {
      Part part = std::move(open_.back());
      open_.pop_back();
      if (part.taken_away.empty()) {
        done.push_back(std::move(part.polytope));
      } else {
        take_away(std::move(part));
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
    if (count > most_) {
      throw InputError("the model falls into more than " + std::to_string(most_) +
                       " convex pieces; give what is subtracted fewer facets ($fn), or subtract less");
    }
  }

  /// Takes the last of its primitives away from a part.
  void take_away(Part part) {
    const facet::Convex& solid = geometry_.solids[part.taken_away.back()];
    part.taken_away.pop_back();
    for (Polytope& polytope : outside(std::move(part.polytope), solid, geometry_.planes, work_))
      open(std::move(polytope), part.taken_away);
  }

  void open(Polytope polytope, const std::vector<std::uint32_t>& taken_away) {
    work_.charge(polytope.vertices.size() + 4 * taken_away.size(), "taking solids away from convex pieces");
    const facet::Box box = box_of(polytope);
    Part part{std::move(polytope), {}};
    std::copy_if(taken_away.begin(), taken_away.end(), std::back_inserter(part.taken_away),
                 [&](std::uint32_t primitive) { return !common(boxes_[primitive], box).empty(); });
    open_.push_back(std::move(part));
  }

  const facet::Geometry& geometry_;
  std::size_t most_;
  const Work& work_;
  std::vector<facet::Box> boxes_;  ///< of the primitives, relative to PlaneTable::centre()
  std::vector<Part> open_;
  std::vector<Piece> pieces_;
  std::uint32_t product_ = 0;
};

}  // namespace

std::vector<Piece> pieces(const facet::Geometry& geometry, const csg::PositiveTree& tree, std::size_t most,
                          const Work& work) {
  Division division(geometry, most, work);
  for_each_product(
      geometry, tree, [&](SolidProduct product) { division.add(std::move(product)); }, most_operands, work);
  return division.take();
}

}  // namespace csgsim::convex
