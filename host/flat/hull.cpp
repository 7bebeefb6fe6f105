#include "host/flat/hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <iterator>
#include <vector>

#include "host/model/exact_coordinate.h"

namespace csgsim::flat {

Area hull(std::span<const Area> areas) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> points;
  for (const Area& area : areas) {
    for (const Outline& outline : area.outlines) {
      for (const glm::dvec2& corner : outline) points.push_back(model::exact_point<Point>(corner.x, corner.y));
    }
  }
  std::vector<Point> around;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(around));
  if (around.size() < 3) return {};
  Outline outline;
  for (const Point& point : around) outline.emplace_back(point.x(), point.y());
  return {{outline}};
}

}  // namespace csgsim::flat
