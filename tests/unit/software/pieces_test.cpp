// Pieces of polygons, order of cells and surfaces of pixels, by hand calculation.

#include <glm/vec3.hpp>

#include "host/read/read.h"
#include "host/view/eye_space.h"
#include "sim/software/display/clipped_facets.h"
#include "sim/software/display/facet_sheets.h"
#include "sim/software/display/polygons.h"
#include "sim/software/display/screen_pieces.h"
#include "sim/software/methods/counts.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::PolygonCell;
using software::Polygons;
using Places = std::vector<glm::dvec3>;

namespace {

/// Eight columns and four rows of one unit each; the eye looks along y, with x to its right and z up. The pixel beyond
/// the last sampled one is 4.5 to the left and right, 2.5 up and down, at a distance of 1.
view::EyeSpace plain_eye(bool perspective) {
  return {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {0, 0, 0}, perspective, 1, 3.5, 1.5};
}

PolygonCell cell_with(const facet::Box& box) {
  PolygonCell cell;
  cell.box = box;
  cell.bucket.push_back({0, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}});
  return cell;
}

bool is_seen(const facet::Box& box, bool perspective) {
  // The centre of planes is elsewhere.
  const glm::dvec3 centre{1, -2, 3};
  Polygons polygons;
  polygons.cells.push_back(cell_with({box.low - centre, box.high - centre}));
  const software::CellOrder order = software::order_front_to_back(polygons, plain_eye(perspective), centre, 8, 4);
  CHECK(order.looked_at == 1);
  return order.cells.size() == 1;
}

constexpr double little = 0x1p-20;

/// Order of two cells divided by a wall; the lower one is number 1.
std::vector<std::uint32_t> order_of_two(int axis, const view::EyeSpace& eye) {
  Polygons polygons;
  facet::Box low{{-9, -9, -9}, {9, 9, 9}};
  facet::Box high = low;
  low.high[axis] = high.low[axis] = 2;
  PolygonCell whole;
  whole.box = {{-9, -9, -9}, {9, 9, 9}};
  whole.wall = 0;
  whole.low = 1;
  whole.high = 2;
  polygons.cells = {whole, cell_with(low), cell_with(high)};
  facet::Plane wall{glm::dvec3{0}, -2};
  wall.normal[axis] = 1;
  polygons.walls.push_back(wall);
  const software::CellOrder order = software::order_front_to_back(polygons, eye, glm::dvec3{0}, 8000, 8000);
  CHECK(order.looked_at == 3);
  return order.cells;
}

testing::Scene drawn(const std::string& csg, const view::Camera& camera, double edge_on_fraction = 1.0 / 256) {
  view::Sampling sampling;
  sampling.width = 120;
  sampling.height = 90;
  sampling.edge_on_fraction = edge_on_fraction;
  return testing::make_scene(read::read_csg_text(csg, "drawn"), camera, sampling);
}

Polygons pieces_of(const software::Facets& facets, const testing::Scene& scene, std::uint32_t bucket_size) {
  software::UncountedMethod uncounted;
  return software::clipped(facets, scene.geometry, {software::directory_of("excell"), bucket_size}, uncounted);
}

/// Corners of each polygon after clipping.
std::vector<Places> corners_after_clipping(const software::Facets& facets, const testing::Scene& scene) {
  software::UncountedMethod uncounted;
  const software::ClippedFacets clipped = software::clip_facets_against_each_other(
      facets, scene.geometry, software::directory_of("excell"), 100, uncounted);
  std::vector<Places> corners;
  for (std::uint32_t i = 0; i < clipped.facets.size(); ++i) {
    CHECK(clipped.facets[i] == i);
    CHECK(clipped.cuts[i].empty());
    CHECK(clipped.polygons.facets[i].primitive == facets.facets[i].primitive);
    const std::span<const glm::dvec3> own = clipped.polygons.corners_of(i);
    corners.emplace_back(own.begin(), own.end());
  }
  CHECK(clipped.polygons.of_primitives == facets.of_primitives);
  return corners;
}

/// Two cubes of two units, displaced by `apart` along each axis.
testing::Scene two_cubes(double apart) {
  return drawn(
      fmt::format("cube(size=[2,2,2],center=true);"
                  "multmatrix([[1,0,0,{0}],[0,1,0,{0}],[0,0,1,{0}],[0,0,0,1]]){{cube(size=[2,2,2],center=true);}}",
                  apart),
      {{5, -60, 10}, {5, 0, 0}, view::Projection::orthographic});
}

/// Replaces the corners of a facet.
void put_corners(software::Facets& facets, std::uint32_t facet, const Places& corners) {
  facets.facets[facet].begin = facets.corners.size();
  facets.corners.insert(facets.corners.end(), corners.begin(), corners.end());
  facets.facets[facet].end = facets.corners.size();
}

}  // namespace

TEST_CASE("a cell is out of sight if it is beyond one side of the picture or behind the eye") {
  struct Row {
    const char* where;
    facet::Box box;  ///< just in sight
    int axis;        ///< a small step along it puts the cell out of sight
    double by;
  };
  const std::vector<Row> flat{
      {"left", {{-9, 1, -1}, {-4.5, 2, 1}}, 0, -little},
      {"right", {{4.5, 1, -1}, {9, 2, 1}}, 0, little},
      {"above", {{-1, 1, 2.5}, {1, 2, 9}}, 2, little},
      {"below", {{-1, 1, -9}, {1, 2, -2.5}}, 2, -little},
  };
  // The boxes are 2 to 4 units from the eye; their far ends determine whether they are in sight.
  const std::vector<Row> deep{
      {"left", {{-30, 2, -1}, {-18, 4, 1}}, 0, -little}, {"right", {{18, 2, -1}, {30, 4, 1}}, 0, little},
      {"above", {{-1, 2, 10}, {1, 4, 30}}, 2, little},   {"below", {{-1, 2, -30}, {1, 4, -10}}, 2, -little},
      {"behind", {{-1, -8, -1}, {1, 0, 1}}, 1, -little},
  };
  for (const bool perspective : {false, true}) {
    for (const Row& row : perspective ? deep : flat) {
      CAPTURE(perspective);
      CAPTURE(row.where);
      facet::Box box = row.box;
      CHECK(is_seen(box, perspective));
      box.low[row.axis] += row.by;
      box.high[row.axis] += row.by;
      CHECK(!is_seen(box, perspective));
      // A box that extends into sight is visible.
      (row.by < 0 ? box.high : box.low)[row.axis] = row.axis == 1 ? 3 : 0;
      CHECK(is_seen(box, perspective));
    }
  }
  // A box behind the eye is visible without perspective; one around the eye is visible with it.
  CHECK(is_seen({{-1, -8, -1}, {1, -2, 1}}, false));
  CHECK(is_seen({{-9, -9, -9}, {9, 9, 9}}, true));
}
TEST_CASE("the cell on the eye's side of a wall comes before the other") {
  using Order = std::vector<std::uint32_t>;
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    for (const double at : {-5.0, 1.75, 2.25, 7.0}) {
      view::EyeSpace eye = plain_eye(true);
      eye.pixel = 0.01;
      eye.middle_x = eye.middle_y = 4000;
      eye.eye = {0, -3, 0};
      eye.eye[axis] = at;
      const Order order = order_of_two(axis, eye);
      // If both cells are in sight, the nearer one is first.
      if (order.size() == 2) CHECK(order == (at < 2 ? Order{1, 2} : Order{2, 1}));
      if (axis != 1) CHECK(order.size() == 2);
    }
    for (const double along : {-1.0, 1.0}) {
      view::EyeSpace eye = plain_eye(false);
      eye.pixel = 0.01;
      eye.middle_x = eye.middle_y = 4000;
      eye.eye = {0, 50, 0};
      glm::dvec3 forward{0.1, 0.1, 0.1};
      forward[axis] = along;
      eye.axes.forward = glm::normalize(forward);
      CHECK(order_of_two(axis, eye) == (along > 0 ? Order{1, 2} : Order{2, 1}));
    }
  }
}
TEST_CASE("cells without pieces are not drawn and pieces without area are not counted") {
  Polygons polygons;
  for (const std::size_t corners : {2U, 3U, 0U, 4U, 1U}) {
    PolygonCell cell;
    cell.box = {{-1, 1, -1}, {1, 2, 1}};
    if (corners > 0) cell.bucket.push_back({0, Places(corners), {}, {}});
    polygons.cells.push_back(cell);
  }
  polygons.cells[3].bucket.push_back({0, Places(3), {}, {}});
  CHECK(polygons.piece_count() == 3);
  CHECK(polygons.filled_cells() == 4);
  CHECK(Polygons{}.piece_count() == 0);
  CHECK(Polygons{}.filled_cells() == 0);
  polygons.cells = {polygons.cells[2]};
  CHECK(software::order_front_to_back(polygons, plain_eye(false), glm::dvec3{0}, 8, 4).cells.empty());
}
TEST_CASE("a facet without area has its own corners or else a corner of its primitive") {
  for (const double apart : {-10.0, 10.0}) {
    CAPTURE(apart);
    const testing::Scene scene = two_cubes(apart);
    const software::Facets whole = software::facets_of(scene.tree, scene.geometry);
    REQUIRE(whole.facets.size() == 12);
    const auto corners_of_first = [&](const Places& corners) {
      software::Facets facets = whole;
      put_corners(facets, 0, corners);
      const std::vector<Places> clipped = corners_after_clipping(facets, scene);
      // A face that misses its neighbour keeps its size.
      software::FacetSheets sheets(facets, scene.geometry);
      for (std::uint32_t facet = 1; facet < 12; ++facet) {
        CHECK(sheets.whole(facet).corners.size() == 4);
        CHECK(clipped[facet].size() == 4);
        const facet::Box box = facet::box_of(clipped[facet]);
        const facet::Box expected = facet::box_of(whole.corners_of(facet));
        CHECK(glm::length(box.low - expected.low) < 1e-9);
        CHECK(glm::length(box.high - expected.high) < 1e-9);
      }
      return clipped[0];
    };
    const glm::dvec3 a{0.5, 0.25, -1};
    const glm::dvec3 b{-1, 1, 0.75};
    CHECK(corners_of_first({a}) == Places{a, a});
    CHECK(corners_of_first({a, b}) == Places{a, b});
    CHECK(corners_of_first({b, a}) == Places{b, a});
    // A facet without corners takes the first corner of its primitive.
    CHECK(corners_of_first({}) == Places{whole.corners_of(1)[0]});
    software::Facets second = whole;
    for (std::uint32_t facet = 6; facet < 12; ++facet) put_corners(second, facet, facet == 9 ? Places{b} : Places{});
    std::vector<Places> corners = corners_after_clipping(second, scene);
    for (std::uint32_t facet = 6; facet < 12; ++facet) CHECK(corners[facet] == (facet == 9 ? Places{b, b} : Places{b}));
    for (std::uint32_t facet = 6; facet < 12; ++facet) put_corners(second, facet, {});
    corners = corners_after_clipping(second, scene);
    for (std::uint32_t facet = 6; facet < 12; ++facet) CHECK(corners[facet] == Places{glm::dvec3{0}});
  }
}
TEST_CASE("a facet thinner than 1e-8 of the model is reduced to its longest extent") {
  const testing::Scene scene = two_cubes(10);
  const software::Facets whole = software::facets_of(scene.tree, scene.geometry);
  // A face of the first cube gets a plane of the second, where the cube is empty.
  const auto entered = [&](const Places& corners) {
    software::Facets facets = whole;
    facets.facets[0].halfspace = whole.facets[6].halfspace;
    for (std::uint32_t facet = 6; facet < 12; ++facet) {
      const double x = whole.corners_of(facet)[0].x;
      const bool is_across = std::ranges::all_of(whole.corners_of(facet), [&](const auto& one) { return one.x == x; });
      if (is_across) facets.facets[0].halfspace = whole.facets[facet].halfspace;
    }
    put_corners(facets, 0, corners);
    return corners_after_clipping(facets, scene)[0];
  };
  const glm::dvec3 from{0, 0, 0};
  const glm::dvec3 to{3, 0, 0};
  const glm::dvec3 between{1, 0, 0};
  CHECK(entered({from, to, between}) == Places{from, to});
  CHECK(entered({between, from, to}) == Places{from, to});
  CHECK(entered({from, between, to}) == Places{from, to});
  CHECK(entered({to, between, from, {2, 0, 0}}) == Places{to, from});
  // Twice the area of a triangle is its length, 3, times its height: compared with 10^-8 of the model's diagonal times
  // the triangle's.
  const double limit = 1e-8 * scene.geometry.planes.diagonal();
  CHECK(scene.geometry.planes.diagonal() > 12);
  CHECK(entered({from, to, {1, 0.999 * limit, 0}}) == Places{from, to});
  CHECK(entered({from, to, {1, 1.001 * limit, 0}}) == Places{from, to, {1, 1.001 * limit, 0}});
}
TEST_CASE("a degenerate facet across a wall of cells is on the side of its middle") {
  const testing::Scene scene =
      drawn("cube(size=[8,8,8],center=true);", {{0, -60, 10}, {0, 0, 0}, view::Projection::orthographic});
  const auto is_above = [&](double from, double to) {
    software::Facets facets = software::facets_of(scene.tree, scene.geometry);
    put_corners(facets, 0, {{from, 0.5, 0.5}, {to, 0.5, 0.5}});
    // The first wall halves the box along x, at 0.
    const Polygons polygons = pieces_of(facets, scene, 1);
    REQUIRE(polygons.walls[polygons.cells[0].wall].normal == glm::dvec3{1, 0, 0});
    CHECK(polygons.walls[polygons.cells[0].wall].offset == 0);
    int found = 0;
    bool above = false;
    for (const PolygonCell& cell : polygons.cells) {
      for (const software::Piece& piece : cell.bucket) {
        if (piece.facet != 0) continue;
        ++found;
        above = cell.box.low.x > -1e-12;
        CHECK(piece.corners.size() == 2);
      }
    }
    CHECK(found == 1);
    return above;
  };
  CHECK(is_above(-1, 1.5));
  CHECK(is_above(1.01, -1));
  CHECK(!is_above(-1.5, 1));
  CHECK(!is_above(1, -1.01));
  CHECK(!is_above(-1, 1));  // on the wall
}
TEST_CASE("a facet's piece has exactly one bound per side in the picture") {
  // A post passes through a wall from below to above: the wall's front is cut along both sides of the post.
  const testing::Scene scene = drawn("cube(size=[20,2,10],center=true);cube(size=[4,12,16],center=true);",
                                     {{14, -30, 17}, {0, 0, 0}, view::Projection::perspective});
  const software::Facets facets = software::facets_of(scene.tree, scene.geometry);
  const Polygons polygons = pieces_of(facets, scene, 1000);
  REQUIRE(polygons.cells.size() == 1);
  const software::ScreenFacets seen = software::screen_facets(scene.tree, scene.geometry, scene.view, facets);
  const std::vector<std::uint32_t> cells{0};
  const software::ScreenPieces pieces = software::screen_pieces(polygons, cells, seen, scene.geometry, scene.view);
  CHECK(pieces.begins == std::vector<std::uint32_t>{0, static_cast<std::uint32_t>(pieces.pieces.facets.size())});
  int fronts = 0;
  for (const software::ScreenFacet& piece : pieces.pieces.facets) {
    const std::span<const glm::dvec3> corners = facets.corners_of(piece.facet);
    const bool is_front =
        std::ranges::all_of(corners, [](const glm::dvec3& one) { return std::abs(one.y + 1) < 1e-9; });
    if (!is_front) continue;
    ++fronts;
    CHECK(pieces.pieces.bounds_of(piece).size() == 4);
    const auto facet = std::ranges::find(seen.facets, piece.facet, &software::ScreenFacet::facet);
    CHECK(pieces.pieces.opposites_of(piece).size() == seen.opposites_of(*facet).size());
  }
  CHECK(fronts == 3);
  // Each linear function belongs to a piece.
  std::size_t used = 0;
  for (const software::ScreenFacet& piece : pieces.pieces.facets) used += piece.end - piece.bounds;
  CHECK(used == pieces.pieces.linears.size());
  CHECK(pieces.pieces.farthest == seen.farthest);
  CHECK(pieces.pieces.fraction_bits == seen.fraction_bits);
}
TEST_CASE("pieces of a box's facets are counter-clockwise from outside and keep its area") {
  // Large primitives with small remainders.
  for (const char* const csg :
       {"cube(size=[6,5,4],center=true);multmatrix([[1,0,0,2],[0,1,0,2],[0,0,1,2],[0,0,0,1]]){cube(size=[6,5,4],center="
        "true);}",
        "intersection(){cube(size=[900,800,700],center=true);cube(size=[6,5,4],center=true);}"}) {
    CAPTURE(csg);
    const testing::Scene scene = drawn(csg, {{14, -30, 17}, {0, 0, 0}, view::Projection::orthographic});
    const software::Facets facets = software::facets_of(scene.tree, scene.geometry);
    const Polygons polygons = pieces_of(facets, scene, 4);
    std::vector<double> areas(facets.facets.size());
    for (const PolygonCell& cell : polygons.cells) {
      for (const software::Piece& piece : cell.bucket) {
        const facet::Halfspace halfspace = facets.facets[piece.facet].halfspace;
        const glm::dvec3 out =
            scene.geometry.planes.planes()[halfspace.plane].normal * (halfspace.positive ? 1.0 : -1.0);
        for (std::size_t i = 2; i < piece.corners.size(); ++i) {
          areas[piece.facet] +=
              glm::dot(out, glm::cross(piece.corners[i - 1] - piece.corners[0], piece.corners[i] - piece.corners[0])) /
              2;
        }
      }
    }
    for (std::uint32_t facet = 0; facet < areas.size(); ++facet) {
      // Faces of boxes: the product of two sides.
      const facet::Box box = facet::box_of(facets.corners_of(facet));
      const glm::dvec3 size = box.high - box.low;
      CHECK(areas[facet] == doctest::Approx(size.x * size.y + size.y * size.z + size.z * size.x).epsilon(1e-9));
    }
  }
}
TEST_CASE("a wall beyond the number range is rejected only where it cuts a facet") {
  const testing::Scene scene =
      drawn("cube(size=[8,8,8],center=true);", {{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic}, 1e-15);
  const software::Facets facets = software::facets_of(scene.tree, scene.geometry);
  const software::ScreenFacets seen = software::screen_facets(scene.tree, scene.geometry, scene.view, facets);
  Polygons polygons = pieces_of(facets, scene, 1000);
  // Steep, but not edge-on: some 2^15 steps per pixel for each unit of height, and 12 bits of fraction.
  polygons.walls = {{glm::normalize(glm::dvec3{1, 1e-12, 0}), 0}};
  REQUIRE(!view::screen_plane(scene.view, polygons.walls[0], scene.geometry.planes.centre()).representable);
  const std::vector<std::uint32_t> cells{0};
  const auto pieces = [&] {
    return software::screen_pieces(polygons, cells, seen, scene.geometry, scene.view).pieces.facets.size();
  };
  CHECK(pieces() == 2);
  for (software::Piece& piece : polygons.cells[0].bucket)
    piece.cuts = {{static_cast<std::uint32_t>(polygons.canonical_planes), true}};
  CHECK_THROWS_WITH_AS(pieces(), doctest::Contains("a plane that clips polygons is too large"), InputError);
}
