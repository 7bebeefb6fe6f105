#include <limits>

#include "sim/software/space/directory.h"

namespace csgsim::software {

namespace {

/// A single cell with all facets.
class None final : public DirectoryOf<None> {
 public:
  None(const FacetShapes& shapes, const SpaceOptions& /*options*/) : shapes_(shapes) {}

  [[nodiscard]] SpaceBuilt built() const override {
    SpaceBuilt built;
    built.cells = 1;
    built.references = built.most_facets = built.bucket_words = shapes_.placed().size();
    return built;
  }

  template <class Count>
  void walk_cells(const SpaceRay& ray, CellVisitor& visitor, Count& /*count*/) const {
    visitor.visit({ray.begin, ray.end, std::numeric_limits<double>::infinity(), shapes_.placed()});
  }

 private:
  const FacetShapes& shapes_;
};

}  // namespace

extern const DirectoryRow none_row{"none", "tests every ray against all facets", "brute force", make_directory<None>};

}  // namespace csgsim::software
