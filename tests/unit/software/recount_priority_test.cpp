// Recounts the operations of list priority: facets are clipped against each other as exact regions; the pieces are
// inserted into the directory, ordered by comparing pairs, and drawn at each pixel of their rectangles.

#include "host/convex/clip.h"
#include "host/view/eye_space.h"
#include "host/view/region.h"
#include "sim/software/display/clipped_facets.h"
#include "sim/software/display/facet_sheets.h"
#include "sim/software/display/polygons.h"
#include "sim/software/display/screen_pieces.h"
#include "sim/software/methods/counts.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/recount_display.h"
#include "tests/unit/software/recount_space.h"

using namespace csgsim;
using software::Event;
using software::Phase;
using software::Polygons;
using software::ScreenFacet;
using software::ScreenPieces;
using software::SpacePart;
using software::VisibleSurface;
using testing::DisplayRecount;
using testing::FacetEvent;
using testing::FacetScan;
using testing::Operations;
using testing::Scene;
using testing::Sequence;
using testing::SequenceRecount;
using testing::steps;

namespace {

using enum processors::Operation;

/// Heights of corners over a plane: three products of longs each.
Operations heights(std::uint64_t corners) {
  return corners *
         steps({{load_long, 6}, {multiply, 12}, {add_long, 15}, {compare_long, 2}, {branch, 2}, branch_taken});
}

/// Corners where edges cross a plane: a quotient of two digits and three products of longs.
Operations crossings(std::uint64_t times) {
  return times * steps({{divide, 2}, {multiply, 14}, {add_long, 20}, {load_long, 8}, {store_long, 3}});
}

/// Boxes of two new polygons, and their corners.
Operations kept(std::uint64_t corners) { return steps({{store_long, 6 + 3 * corners}}); }

/// Costs of clipping facets against each other and inserting them into a directory.
class Preprocessing {
 public:
  Preprocessing(DisplayRecount& recount, std::string directory, std::uint32_t bucket_size)
      : recount_(recount),
        sum_(recount.of(Phase::preprocessing)),
        directory_(std::move(directory)),
        bucket_size_(bucket_size),
        reach_(convex::tolerance(recount.scene.geometry.planes)),
        sheets_(recount.facets, recount.scene.geometry),
        regions_(recount.facets.facets.size()) {}

  void run() {
    const software::FacetShapes shapes(recount_.facets, reach_);
    const auto first = software::directory_of(directory_).make(shapes, {bucket_size_});
    add_built(shapes, *first);
    for (std::uint32_t facet = 0; facet < regions_.size(); ++facet) {
      software::Region whole = sheets_.whole(facet);
      if (!whole.empty()) regions_[facet].push_back(std::move(whole));
    }
    clip_in(first->parts());
    std::uint64_t polygons = 0;
    for (const auto& regions : regions_) polygons += std::max<std::size_t>(1, regions.size());
    software::UncountedMethod uncounted;
    const software::ClippedFacets clipped = software::clip_facets_against_each_other(
        recount_.facets, recount_.scene.geometry, software::directory_of(directory_), bucket_size_, uncounted);
    REQUIRE(clipped.facets.size() == polygons);
    const software::FacetShapes cut_shapes(clipped.polygons, reach_);
    const auto second = software::directory_of(directory_).make(cut_shapes, {bucket_size_});
    recount_.expected.words.buckets = add_built(cut_shapes, *second);
    parts_ = second->parts();
    fill(clipped);
  }

 private:
  struct Polygon {
    std::uint32_t number;
    std::vector<glm::dvec3> corners;
  };

  /// Returns the number of words.
  std::uint64_t add_built(const software::FacetShapes& shapes, const software::Directory& directory) {
    const software::SpaceBuilt built = testing::recounted_space(directory_, shapes, bucket_size_, directory);
    sum_ += built.operations;
    recount_.expected.overlap_tests += built.overlap_tests;
    return built.directory_words + built.bucket_words;
  }

  /// Visits the facets of a cell for each of them; compares each pair of different primitives once.
  void clip_in(const std::vector<SpacePart>& space) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> held;
    for (std::uint32_t facet = 0; facet < regions_.size(); ++facet) {
      for (const SpacePart& cell : space) {
        if (std::ranges::count(cell.facets, facet) == 0) continue;
        sum_ += cell.facets.size() * steps({{load, 2}, {compare, 2}, {branch, 2}});
        for (const std::uint32_t other : cell.facets) {
          const bool is_same = recount_.facets.facets[facet].primitive == recount_.facets.facets[other].primitive;
          if (other < facet && !is_same && held.insert({facet, other}).second) clip(facet, other);
        }
      }
    }
  }

  /// A part that is cut off is appended to the regions of its facet, and is also compared with all regions of the other
  /// facet.
  void clip(std::uint32_t one, std::uint32_t other) {
    for (std::size_t i = 0; i < regions_[one].size(); ++i) {
      for (std::size_t j = 0; j < regions_[other].size(); ++j) {
        const software::Region of_one = regions_[one][i];
        const software::Region of_other = regions_[other][j];
        ++recount_.expected.crossing_tests;
        sum_ += steps({{load_long, 12}, {compare_long, 6}, {branch, 6}});
        const auto box_of = [&](std::uint32_t facet, const software::Region& region) {
          return sheets_.sheet_of(facet).bounds(region).box;
        };
        if (software::are_apart(box_of(one, of_one), box_of(other, of_other))) continue;
        sum_ += heights(of_one.corners.size() + of_other.corners.size());
        if (!sheets_.cross(one, of_one, other, of_other)) continue;
        // Two ends on each of them are compared.
        sum_ += crossings(4) + heights(4) + steps({{compare_long, 2}, {branch, 2}});
        cut(one, i, sheets_.plane_of(other));
        cut(other, j, sheets_.plane_of(one));
      }
    }
  }

  void cut(std::uint32_t facet, std::size_t number, std::uint32_t plane) {
    software::Parts parts = sheets_.sheet_of(facet).cut(regions_[facet][number], {plane, true});
    sum_ += crossings(2) + kept(parts.in.corners.size() + parts.out.corners.size());
    regions_[facet][number] = std::move(parts.in);
    regions_[facet].push_back(std::move(parts.out));
  }

  void fill(const software::ClippedFacets& clipped) {
    std::vector<Polygon> polygons;
    std::uint64_t shared = 0;
    for (std::uint32_t i = 0; i < clipped.facets.size(); ++i) {
      const auto corners = clipped.polygons.corners_of(i);
      polygons.push_back({i, {corners.begin(), corners.end()}});
      recount_.expected.pieces += corners.size() >= 3 ? 1U : 0U;
      const auto cells =
          std::ranges::count_if(parts_, [&](const SpacePart& part) { return std::ranges::count(part.facets, i) > 0; });
      shared += cells > 1 ? 1U : 0U;
    }
    recount_.expected.shared = shared;
    fill(parts_[0], std::move(polygons));
  }

  [[nodiscard]] bool has(const SpacePart& part, std::uint32_t polygon) const {
    if (part.is_cell()) return std::ranges::count(part.facets, polygon) > 0;
    return has(parts_[part.low], polygon) || has(parts_[part.high], polygon);
  }

  /// Inserts polygons downwards; a wall cuts those that belong to both sides and extend beyond it on both.
  void fill(const SpacePart& part, std::vector<Polygon> polygons) {
    sum_ += steps({load_long, branch});
    if (part.is_cell()) {
      sum_ += steps({{store_long, polygons.size()}});
      return;
    }
    std::vector<Polygon> low;
    std::vector<Polygon> high;
    for (Polygon& polygon : polygons) {
      sum_ += steps({{load_long, 2}, {compare_long, 2}, {branch, 2}});
      const bool is_low = has(parts_[part.low], polygon.number);
      const bool is_high = has(parts_[part.high], polygon.number);
      if (is_low != is_high) {
        (is_low ? low : high).push_back(std::move(polygon));
      } else {
        share(part, std::move(polygon), low, high);
      }
    }
    fill(parts_[part.low], std::move(low));
    fill(parts_[part.high], std::move(high));
  }

  void share(const SpacePart& part, Polygon polygon, std::vector<Polygon>& low, std::vector<Polygon>& high) {
    std::vector<double> over;
    for (const glm::dvec3& corner : polygon.corners) over.push_back(corner[part.axis] - part.wall);
    if (over.size() < 3) {
      double sum = 0;
      for (const double one : over) sum += one;
      (sum > 0 ? high : low).push_back(std::move(polygon));
      return;
    }
    sum_ += over.size() * steps({load_long, compare_long, branch, branch_taken});
    const double overhang = 10 * reach_;
    const bool is_above = std::ranges::max(over) > overhang;
    const bool is_below = std::ranges::min(over) < -overhang;
    if (!is_above || !is_below) {
      (is_above ? high : low).push_back(std::move(polygon));
      return;
    }
    Polygon above{polygon.number, {}};
    Polygon below{polygon.number, {}};
    std::uint64_t crossed = 0;
    for (std::size_t i = 0; i < over.size(); ++i) {
      const std::size_t next = (i + 1) % over.size();
      if (over[i] >= -overhang) above.corners.push_back(polygon.corners[i]);
      if (over[i] <= overhang) below.corners.push_back(polygon.corners[i]);
      if (std::min(over[i], over[next]) >= -overhang || std::max(over[i], over[next]) <= overhang) continue;
      ++crossed;
      const glm::dvec3 crossing =
          polygon.corners[i] + (polygon.corners[next] - polygon.corners[i]) * (over[i] / (over[i] - over[next]));
      above.corners.push_back(crossing);
      below.corners.push_back(crossing);
    }
    sum_ += crossings(crossed) + kept(above.corners.size() + below.corners.size());
    low.push_back(std::move(below));
    high.push_back(std::move(above));
  }

  DisplayRecount& recount_;
  Operations& sum_;
  std::string directory_;
  std::uint32_t bucket_size_;
  double reach_;
  software::FacetSheets sheets_;
  std::vector<std::vector<software::Region>> regions_;  ///< regions of each facet
  std::vector<SpacePart> parts_;
};

/// Cells from front to back.
class Retrieval {
 public:
  Retrieval(DisplayRecount& recount, const Polygons& polygons)
      : recount_(recount),
        polygons_(polygons),
        eye_(view::eye_space(recount.scene.view.camera, recount.scene.view.sampling)) {}

  std::vector<std::uint32_t> run() {
    look_into(0);
    recount_.expected.drawn_cells = cells_.size();
    recount_.of(Phase::sorting) += steps({{store_long, 2 * cells_.size()}});
    return cells_;
  }

 private:
  /// The eye's side of the cell's wall, then four sides of the picture at eight corners, by three products each.
  void look_into(std::uint32_t number) {
    ++recount_.expected.visited_parts;
    recount_.of(Phase::sorting) +=
        steps({{load_long, 8}, {compare_long, 33}, {multiply, 4 * 24}, {add_long, 4 * 30}, {branch, 33}});
    const software::PolygonCell& cell = polygons_.cells[number];
    if (is_out_of_sight(cell.box)) return;
    if (cell.low == software::PolygonCell::none) {
      if (!cell.bucket.empty()) cells_.push_back(number);
      return;
    }
    const facet::Plane& wall = polygons_.walls[cell.wall];
    const glm::dvec3 eye = eye_.eye - recount_.scene.geometry.planes.centre();
    const bool is_low_first = eye_.perspective ? wall.height(eye) < 0 : glm::dot(wall.normal, eye_.axes.forward) > 0;
    look_into(is_low_first ? cell.low : cell.high);
    look_into(is_low_first ? cell.high : cell.low);
  }

  /// Whether all corners of a box are outside one side of the picture, enlarged by one pixel.
  [[nodiscard]] bool is_out_of_sight(const facet::Box& box) const {
    const double width = recount_.scene.view.sampling.width;
    const double height = recount_.scene.view.sampling.height;
    // Functions of a point's right, up and unit coordinates that are negative beyond a side.
    const std::array<glm::dvec3, 4> sides{glm::dvec3{1, 0, eye_.middle_x + 1}, glm::dvec3{-1, 0, width - eye_.middle_x},
                                          glm::dvec3{0, -1, eye_.middle_y + 1},
                                          glm::dvec3{0, 1, height - eye_.middle_y}};
    const auto all = [&](const auto& is_beyond) {
      for (const double x : {box.low.x, box.high.x}) {
        for (const double y : {box.low.y, box.high.y}) {
          for (const double z : {box.low.z, box.high.z}) {
            if (!is_beyond(eye_.to_eye(glm::dvec3{x, y, z} + recount_.scene.geometry.planes.centre()))) return false;
          }
        }
      }
      return true;
    };
    if (eye_.perspective && all([](const glm::dvec3& place) { return place.z < 0; })) return true;
    return std::ranges::any_of(sides, [&](const glm::dvec3& side) {
      return all([&](const glm::dvec3& place) {
        const double unit = eye_.perspective ? eye_.pixel * place.z : eye_.pixel;
        return side.x * place.x + side.y * place.y + side.z * unit < 0;
      });
    });
  }

  DisplayRecount& recount_;
  const Polygons& polygons_;
  view::EyeSpace eye_;
  std::vector<std::uint32_t> cells_;
};

/// The order in which pieces of a bucket are drawn.
class Order {
 public:
  Order(DisplayRecount& recount, const software::ScreenFacets& pieces)
      : recount_(recount), pieces_(pieces), sum_(recount.of(Phase::sorting)), longs_(recount.numbers.longs) {}

  std::vector<std::uint32_t> of(std::uint32_t begin, std::uint32_t end) {
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t piece = begin; piece < end; ++piece) waiting.push_back(piece);
    sum_ += (4 * longs_ * waiting.size()) * steps({multiply, add_long});
    std::uint64_t compared = 0;
    std::ranges::stable_sort(waiting, [&](std::uint32_t a, std::uint32_t b) {
      ++compared;
      return depths_of(a).first < depths_of(b).first;
    });
    sum_ += testing::sorted(compared);
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;  // the first hides the second
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      for (std::size_t j = i + 1; j < waiting.size(); ++j) {
        const int first = first_of(waiting[i], waiting[j]);
        if (first == 0) continue;
        pairs.insert(first < 0 ? std::pair{waiting[i], waiting[j]} : std::pair{waiting[j], waiting[i]});
        sum_ += steps({store, store_long, add});
      }
    }
    return taken(std::move(waiting), std::move(pairs));
  }

 private:
  using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

  /// Least and greatest depth over the rectangle.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> depths_of(std::uint32_t piece) const {
    const ScreenFacet& facet = pieces_.facets[piece];
    std::pair<std::int64_t, std::int64_t> range{std::numeric_limits<std::int64_t>::max(),
                                                std::numeric_limits<std::int64_t>::min()};
    for (const std::int32_t x : {facet.pixels.x0, facet.pixels.x1}) {
      for (const std::int32_t y : {facet.pixels.y0, facet.pixels.y1}) {
        const std::int64_t value = view::value_at(facet.depth, x, y);
        range = {std::min(range.first, value), std::max(range.second, value)};
      }
    }
    return range;
  }

  void count_values(std::uint64_t corners) {
    sum_ += steps({{load_long, 3 * longs_}});
    sum_ += corners *
            steps({{load_long, 2}, {multiply, 2 * longs_}, {add_long, 3 * longs_}, compare_long, branch, branch_taken});
  }

  /// Negative if one must be drawn before the other, positive if after.
  int first_of(std::uint32_t one, std::uint32_t other) {
    const ScreenFacet& a = pieces_.facets[one];
    const ScreenFacet& b = pieces_.facets[other];
    sum_ += steps({{load, 8}, {compare, 5}, {branch, 5}});
    const view::PixelRect both{std::max(a.pixels.x0, b.pixels.x0), std::max(a.pixels.y0, b.pixels.y0),
                               std::min(a.pixels.x1, b.pixels.x1), std::min(a.pixels.y1, b.pixels.y1)};
    if (both.empty()) return 0;
    if (a.primitive == b.primitive) return static_cast<int>(a.leaves) - static_cast<int>(b.leaves);
    sum_ += steps({{load_long, 4}, {compare_long, 2}, {branch, 2}});
    if (depths_of(one).second < depths_of(other).first) return -1;
    if (depths_of(other).second < depths_of(one).first) return 1;
    // The common polygon, edge by edge, and the difference of the depths at its corners.
    view::Region common(both);
    std::vector<view::FixedLinear> edges;
    for (const ScreenFacet* const piece : {&a, &b}) {
      for (const view::FixedLinear& edge : pieces_.bounds_of(*piece)) edges.push_back(edge);
    }
    for (const view::FixedLinear& edge : edges) {
      count_values(common.corners().size());
      common.clip(edge);
      if (common.empty()) return 0;
    }
    count_values(common.corners().size());
    const auto [low, high] = common.range(view::difference(b.depth, a.depth));
    if (low == 0 && high == 0) return 0;
    return high + low >= 0 ? -1 : 1;
  }

  /// The first in depth order that no waiting piece must precede; in a cycle, the first.
  std::vector<std::uint32_t> taken(std::vector<std::uint32_t> waiting, Pairs pairs) {
    std::vector<std::uint32_t> order;
    while (!waiting.empty()) {
      const auto is_free = [&](std::uint32_t piece) {
        return std::ranges::none_of(pairs, [&](const auto& pair) { return pair.second == piece; });
      };
      auto next = std::ranges::find_if(waiting, is_free);
      const bool is_conflict = next == waiting.end();
      const auto looked_at = static_cast<std::uint64_t>(next - waiting.begin()) + (is_conflict ? 0U : 1U);
      sum_ += looked_at * steps({load, branch});
      if (is_conflict) {
        next = waiting.begin();
        ++recount_.expected.conflicts;
      }
      const std::uint32_t piece = *next;
      waiting.erase(next);
      order.push_back(piece);
      sum_ += steps({{store_long, 2}});
      const std::uint64_t released = std::erase_if(pairs, [&](const auto& pair) { return pair.first == piece; });
      sum_ += released * steps({load_long, add});
    }
    return order;
  }

  DisplayRecount& recount_;
  const software::ScreenFacets& pieces_;
  Operations& sum_;
  std::uint64_t longs_;
};

/// Pixels while pieces are drawn from front to back.
class Drawing {
 public:
  Drawing(DisplayRecount& recount, bool has_depth_buffer)
      : recount_(recount),
        has_depth_buffer_(has_depth_buffer),
        sequences_(recount.tree, recount.primitives, recount.csg),
        pixels_(recount.rays.size()) {
    recount.of(Phase::initialisation) +=
        pixels_.size() * steps({{store_long, has_depth_buffer ? 2U : 1U}, {store, has_depth_buffer ? 1U : 0U}});
  }

  void draw(const FacetScan& scan) {
    scanning() += testing::conversion(scan, recount_.numbers);
    if (has_depth_buffer_) tested() += testing::depths(scan.columns, recount_.numbers);
    recount_.expected.pixel_events += scan.events.size();
    for (const FacetEvent& one : scan.events) {
      Pixel& pixel = pixels_[recount_.pixel(one)];
      if (has_depth_buffer_) {
        test(pixel, one.event);
      } else {
        set_next(pixel, one.event);
      }
      recount_.seen[recount_.pixel(one)] = pixel.seen;
    }
  }

  [[nodiscard]] std::uint64_t words() const { return sequences_.words(); }

 private:
  struct Pixel {
    Sequence sequence{};
    std::vector<Event> events{};
    std::size_t level = 0;  ///< number of last events at one depth
    bool is_set = false;
    VisibleSurface seen{0, VisibleSurface::nothing_seen};
  };

  Operations& scanning() { return recount_.of(Phase::scan_conversion); }
  Operations& tested() { return recount_.of(Phase::depth_test); }

  /// A surface behind all earlier ones; ignored if the pixel is set.
  void set_next(Pixel& pixel, const Event& event) {
    scanning() += steps({load_long, branch});
    if (pixel.is_set) return;
    add(pixel, event, 1);
  }

  void add(Pixel& pixel, const Event& event, std::size_t level) {
    sequences_.follow(pixel.sequence, event.primitive(), recount_.csg);
    scanning() += steps({store_long});
    pixel.events.push_back(event);
    pixel.level = level;
    ++recount_.csg.points;
    pixel.is_set = sequences_.is_in(pixel.sequence, level, recount_.csg);
    pixel.seen = {recount_.farthest, VisibleSurface::nothing_seen};
    if (!pixel.is_set) return;
    scanning() += steps({{store_long, has_depth_buffer_ ? 2U : 1U}});
    const bool is_alone = level == 1;
    pixel.seen = {event.depth, is_alone ? event.primitive() : sequences_.owner(pixel.sequence, level, recount_.csg)};
  }

  /// Compares a surface with the depth of the last one: it is behind, equal, or exchanged with it.
  void test(Pixel& pixel, const Event& event) {
    tested() += testing::comparisons(1) + steps({branch});
    if (pixel.events.empty() || event.depth > pixel.events.back().depth) {
      tested() += steps({store_long});
      return set_next(pixel, event);
    }
    if (event.depth == pixel.events.back().depth) return add(pixel, event, pixel.level + 1);
    const Event last = pixel.events.back();
    pixel.events.pop_back();
    pixel.sequence.pop_back();
    scanning() += steps({load_long, load});
    add(pixel, event, 1);
    if (!pixel.is_set) add(pixel, last, 1);
  }

  DisplayRecount& recount_;
  bool has_depth_buffer_;
  SequenceRecount sequences_;
  std::vector<Pixel> pixels_;
};

struct Tally {
  std::uint64_t cuts = 0;
  std::uint64_t conflicts = 0;
  std::uint64_t ties = 0;
};

void check_scene(const Scene& scene, const std::string& directory, std::uint32_t bucket_size, bool has_depth_buffer,
                 Tally& tally) {
  CAPTURE(directory);
  CAPTURE(bucket_size);
  CAPTURE(has_depth_buffer);
  DisplayRecount recount(scene);
  recount.expected.pieces = 0;
  Preprocessing(recount, directory, bucket_size).run();
  software::UncountedMethod uncounted;
  const Polygons polygons =
      software::clipped(recount.facets, scene.geometry, {software::directory_of(directory), bucket_size}, uncounted);
  const std::vector<std::uint32_t> cells = Retrieval(recount, polygons).run();
  const ScreenPieces screen = software::screen_pieces(polygons, cells, recount.screen, scene.geometry, scene.view);
  const software::ScreenFacets& pieces = screen.pieces;
  std::uint64_t drawn_corners = 0;
  for (const std::uint32_t cell : cells) {
    for (const software::Piece& piece : polygons.cells[cell].bucket) drawn_corners += piece.corners.size();
  }
  recount.of(Phase::transformation) =
      testing::transformed(drawn_corners, recount.screen.facets.size(), pieces.linears.size());
  Drawing drawing(recount, has_depth_buffer);
  for (std::size_t i = 0; i < recount.scans.size(); ++i) {
    if (recount.screen.facets[i].facet == ScreenFacet::near_cap) drawing.draw(recount.scans[i]);
  }
  Order order(recount, pieces);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    for (const std::uint32_t piece : order.of(screen.begins[cell], screen.begins[cell + 1]))
      drawing.draw(testing::scanned(pieces, pieces.facets[piece], recount.rays));
  }
  software::DisplayCounts& expected = recount.expected;
  expected.drawn_polygons = pieces.facets.size();
  std::uint64_t corners = 0;
  for (const software::PolygonCell& cell : polygons.cells) {
    expected.cells += cell.bucket.empty() ? 0U : 1U;
    expected.overfull_cells += cell.bucket.size() > bucket_size ? 1U : 0U;
    expected.references += cell.bucket.size();
    for (const software::Piece& piece : cell.bucket) corners += piece.corners.size();
  }
  // Corners; per piece its facet, its box and a pointer; planes, edges, and those in the picture.
  expected.words.polygons =
      3 * corners + 8 * expected.references + 6 * pieces.linears.size() + 10 * expected.drawn_polygons;
  expected.words.pixels += (has_depth_buffer ? 3 : 1) * recount.rays.size();
  expected.words.sequences = drawing.words();
  const software::Displayed found =
      recount.by(has_depth_buffer ? "list-priority/depth-buffer" : "list-priority", bucket_size, directory);
  recount.check(found);
  tally.cuts += found.counts.pieces - found.counts.polygons;
  tally.conflicts += found.counts.conflicts;
  tally.ties += found.counts.csg.ties;
}

}  // namespace

TEST_CASE("list priority counts as a plain recount of regions and pieces and rays does") {
  Tally tally;
  std::uint64_t scenes = 0;
  const std::vector<std::string> directories = software::halving_directories();
  for (std::uint64_t seed = 1; scenes < 60; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    CAPTURE(seed);
    ++scenes;
    for (const bool has_depth_buffer : {false, true})
      check_scene(*scene, directories[seed % directories.size()], static_cast<std::uint32_t>(4 + seed % 30),
                  has_depth_buffer, tally);
  }
  MESSAGE(scenes, " scenes, ", tally.cuts, " cuts, ", tally.conflicts, " conflicts, ", tally.ties, " ties");
  CHECK(tally.cuts > 10 * scenes);
  CHECK(tally.conflicts > 0);
  CHECK(tally.ties > 0);
}
