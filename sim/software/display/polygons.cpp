#include "sim/software/display/polygons.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

#include "host/convex/clip.h"
#include "sim/software/display/count_clipping.h"
#include "sim/software/methods/counts.h"
#include "sim/software/space/facet_shapes.h"

namespace csgsim::software {

namespace {

/// Minimum overhang beyond a wall for a cut, as a multiple of the tolerance of directories. The tolerance also moves
/// walls off faces that would lie on them.
constexpr double min_overhang = 10;

/// The sides of a plane on which points lie.
struct WallSides {
  bool above = false;
  bool below = false;
};

/// The cells of each polygon as numbers, in which every part of space is a contiguous range.
class CellNumbers {
 public:
  CellNumbers(const std::vector<SpacePart>& space, std::size_t polygons) : space_(space), of_(polygons) {
    ranges_.resize(space.size());
    number(0);
  }

  [[nodiscard]] bool has(std::uint32_t part, std::uint32_t polygon) const {
    const auto place = std::ranges::lower_bound(of_[polygon], ranges_[part].first);
    return place != of_[polygon].end() && *place < ranges_[part].end;
  }
  /// Number of polygons in several cells.
  [[nodiscard]] std::uint64_t shared() const {
    return static_cast<std::uint64_t>(std::ranges::count_if(of_, [](const auto& cells) { return cells.size() > 1; }));
  }

 private:
  struct Numbers {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };

  void number(std::uint32_t part) {
    ranges_[part].first = cells_;
    if (space_[part].is_cell()) {
      for (const std::uint32_t polygon : space_[part].facets) of_[polygon].push_back(cells_);
      ++cells_;
    } else {
      number(space_[part].low);
      number(space_[part].high);
    }
    ranges_[part].end = cells_;
  }

  const std::vector<SpacePart>& space_;
  std::vector<std::vector<std::uint32_t>> of_;  ///< cells of each polygon, ascending
  std::vector<Numbers> ranges_;                 ///< one per part
  std::uint32_t cells_ = 0;
};

/// Distributes polygons to the cells of a directory, top down.
template <class Count>
class CellFiller {
 public:
  CellFiller(const std::vector<SpacePart>& space, const ClippedFacets& clipped, const facet::Geometry& geometry,
             Count& count)
      : space_(space),
        numbers_(space, clipped.facets.size()),
        tolerance_(min_overhang * convex::tolerance(geometry.planes)),
        count_(count) {
    made_.canonical_planes = geometry.planes.planes().size();
    made_.clipped = clipped.polygons.polygon_count();
    made_.crossing_tests = clipped.crossing_tests;
    made_.overlap_tests = clipped.overlap_tests;
    made_.shared = numbers_.shared();
    made_.cells.resize(space.size());
    std::vector<Entry> entries;
    for (std::uint32_t i = 0; i < clipped.facets.size(); ++i) {
      const std::span<const glm::dvec3> corners = clipped.polygons.corners_of(i);
      entries.push_back(
          {i, {clipped.facets[i], {corners.begin(), corners.end()}, clipped.cuts[i], facet::box_of(corners)}});
    }
    fill(0, std::move(entries));
  }

  Polygons release() { return std::move(made_); }

 private:
  struct Entry {
    std::uint32_t polygon;  ///< index into ClippedFacets
    Piece piece;
  };

  void fill(std::uint32_t part, std::vector<Entry> entries) {
    const SpacePart& space = space_[part];
    PolygonCell& cell = made_.cells[part];
    cell.box = space.box;
    count_(Operation::load_long);
    count_(Operation::branch);
    if (space.is_cell()) {
      for (Entry& entry : entries) cell.bucket.push_back(std::move(entry.piece));
      count_(Operation::store_long, entries.size());
      return;
    }
    cell.wall = static_cast<std::uint32_t>(made_.walls.size());
    cell.low = space.low;
    cell.high = space.high;
    facet::Plane wall{glm::dvec3{0}, -space.wall};
    wall.normal[space.axis] = 1.0;
    made_.walls.push_back(wall);
    std::vector<Entry> low;
    std::vector<Entry> high;
    for (Entry& entry : entries) share(std::move(entry), space, cell.wall, low, high);
    fill(space.low, std::move(low));
    fill(space.high, std::move(high));
  }

  /// Puts a polygon, or its parts, on the sides of a wall where it has cells.
  void share(Entry entry, const SpacePart& space, std::uint32_t wall, std::vector<Entry>& low,
             std::vector<Entry>& high) {
    count_(Operation::load_long, 2);
    count_(Operation::compare_long, 2);
    count_(Operation::branch, 2);
    const bool is_low = numbers_.has(space.low, entry.polygon);
    const bool is_high = numbers_.has(space.high, entry.polygon);
    if (is_low != is_high) {
      (is_low ? low : high).push_back(std::move(entry));
      return;
    }
    const facet::Plane& plane = made_.walls[wall];
    if (entry.piece.corners.size() < 3) {
      glm::dvec3 middle{0};
      for (const glm::dvec3& corner : entry.piece.corners)
        middle += corner / static_cast<double>(entry.piece.corners.size());
      (plane.height(middle) > 0.0 ? high : low).push_back(std::move(entry));
      return;
    }
    const WallSides sides = sides_of(entry.piece.corners, plane);
    if (!sides.above || !sides.below) {
      (sides.above ? high : low).push_back(std::move(entry));
      return;
    }
    Entry above{entry.polygon, cut(entry.piece, static_cast<std::uint32_t>(made_.canonical_planes + wall), plane)};
    high.push_back(std::move(above));
    low.push_back(std::move(entry));
  }

  WallSides sides_of(std::span<const glm::dvec3> corners, const facet::Plane& plane) {
    WallSides sides;
    for (const glm::dvec3& corner : corners) {
      const double height = plane.height(corner);
      sides.above = sides.above || height > tolerance_;
      sides.below = sides.below || height < -tolerance_;
    }
    count_(Operation::load_long, corners.size());
    count_(Operation::compare_long, corners.size());
    count_(Operation::branch, corners.size());
    count_(Operation::branch_taken, corners.size());
    return sides;
  }

  /// Keeps the part below the plane and returns the part above.
  Piece cut(Piece& piece, std::uint32_t number, const facet::Plane& plane) {
    Piece above{piece.facet, {}, piece.cuts, {}};
    std::vector<glm::dvec3> below;
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      const glm::dvec3& here = piece.corners[i];
      const glm::dvec3& next = piece.corners[(i + 1) % piece.corners.size()];
      const double height = plane.height(here);
      const double beyond = plane.height(next);
      if (height >= -tolerance_) above.corners.push_back(here);
      if (height <= tolerance_) below.push_back(here);
      if ((height > tolerance_ && beyond < -tolerance_) || (height < -tolerance_ && beyond > tolerance_)) {
        const glm::dvec3 crossing = here + (next - here) * (height / (height - beyond));
        above.corners.push_back(crossing);
        below.push_back(crossing);
        ++crossings;
      }
    }
    count_crossings(count_, crossings);
    count_(Operation::store_long, 6 + 3 * (above.corners.size() + below.size()));
    piece.corners = std::move(below);
    piece.cuts.push_back({number, true});
    above.cuts.push_back({number, false});
    piece.box = facet::box_of(piece.corners);
    above.box = facet::box_of(above.corners);
    return above;
  }

  const std::vector<SpacePart>& space_;
  CellNumbers numbers_;
  double tolerance_;
  Count& count_;
  Polygons made_;
};

/// Whether a cell is invisible: entirely beyond one side of the view, or behind the eye.
bool is_outside(const facet::Box& box, const view::EyeSpace& eye, const glm::dvec3& centre, double width,
                double height) {
  std::array<bool, 5> beyond{true, true, true, true, eye.perspective};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point{(corner & 1U) != 0 ? box.high.x : box.low.x, (corner & 2U) != 0 ? box.high.y : box.low.y,
                           (corner & 4U) != 0 ? box.high.z : box.low.z};
    const glm::dvec3 in_eye = eye.to_eye(point + centre);
    const double unit = eye.perspective ? eye.pixel * in_eye.z : eye.pixel;
    beyond[0] = beyond[0] && in_eye.x < -(eye.middle_x + 1.0) * unit;
    beyond[1] = beyond[1] && in_eye.x > (width - eye.middle_x) * unit;
    beyond[2] = beyond[2] && in_eye.y > (eye.middle_y + 1.0) * unit;
    beyond[3] = beyond[3] && in_eye.y < -(height - eye.middle_y) * unit;
    beyond[4] = beyond[4] && in_eye.z < 0.0;
  }
  return std::ranges::any_of(beyond, [](bool is) { return is; });
}

}  // namespace

std::size_t Polygons::piece_count() const {
  std::size_t sum = 0;
  for (const PolygonCell& cell : cells) {
    for (const Piece& piece : cell.bucket) sum += piece.corners.size() >= 3 ? 1U : 0U;
  }
  return sum;
}

std::size_t Polygons::filled_cells() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cells, [](const PolygonCell& cell) { return !cell.bucket.empty(); }));
}

template <class Count>
Polygons clipped(const Facets& facets, const facet::Geometry& geometry, const PolygonOptions& options, Count& count) {
  const ClippedFacets clipped =
      clip_facets_against_each_other(facets, geometry, options.directory, options.bucket_size, count);
  const FacetShapes shapes(clipped.polygons, convex::tolerance(geometry.planes));
  const std::unique_ptr<Directory> directory = options.directory.make(shapes, {options.bucket_size});
  const std::vector<SpacePart> space = directory->parts();
  if (space.empty()) throw std::logic_error("this directory does not halve space");
  Polygons polygons = CellFiller<Count>(space, clipped, geometry, count).release();
  const SpaceBuilt built = directory->built();
  add_build_counts(count, built.operations);
  polygons.overlap_tests += built.overlap_tests;
  polygons.words = built.directory_words + built.bucket_words;
  return polygons;
}

template Polygons clipped(const Facets&, const facet::Geometry&, const PolygonOptions&, CountingMethod&);
template Polygons clipped(const Facets&, const facet::Geometry&, const PolygonOptions&, UncountedMethod&);

CellOrder order_front_to_back(const Polygons& polygons, const view::EyeSpace& eye, const glm::dvec3& centre,
                              std::uint32_t width, std::uint32_t height) {
  CellOrder order;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    ++order.looked_at;
    const PolygonCell& cell = polygons.cells[at];
    if (is_outside(cell.box, eye, centre, width, height)) continue;
    if (cell.wall == PolygonCell::none) {
      if (!cell.bucket.empty()) order.cells.push_back(at);
      continue;
    }
    const facet::Plane& wall = polygons.walls[cell.wall];
    const bool is_low_first =
        eye.perspective ? wall.height(eye.eye - centre) < 0.0 : glm::dot(wall.normal, eye.axes.forward) > 0.0;
    open.push_back(is_low_first ? cell.high : cell.low);
    open.push_back(is_low_first ? cell.low : cell.high);
  }
  return order;
}

}  // namespace csgsim::software
