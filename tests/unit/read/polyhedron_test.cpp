#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using csgsim::model::Polyhedron;
using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

constexpr std::string_view box_points = "[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,1],[0,1,1]]";
constexpr std::string_view inward_box_faces = "[[0,1,2,3],[7,6,5,4],[4,5,1,0],[5,6,2,1],[6,7,3,2],[7,4,0,3]]";
constexpr std::string_view outward_box_faces = "[[3,2,1,0],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]";
constexpr std::string_view tetrahedron_points = "[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]";

std::string polyhedron(std::string_view points, std::string_view faces) {
  return fmt::format("polyhedron(points = {}, faces = {}, convexity = 1);", points, faces);
}

Polyhedron solid(const std::string& text) {
  const csgsim::model::Tree tree = read(text);
  REQUIRE(tree.primitives.size() == 1);
  return std::get<Polyhedron>(tree.primitives[0].shape);
}

/// Volume of all pieces together.
double volume(const csgsim::model::Tree& tree) {
  double sum = 0;
  for (const csgsim::model::Primitive& primitive : tree.primitives) {
    const auto& piece = std::get<Polyhedron>(primitive.shape);
    for (const auto& face : piece.faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        sum += glm::dot(piece.points[face[0]], glm::cross(piece.points[face[i]], piece.points[face[i + 1]])) / 6;
      }
    }
  }
  return sum;
}

/// Whether every point is on or below every face, with corners counter-clockwise as seen from outside.
bool faces_outwards(const Polyhedron& polyhedron) {
  return std::ranges::all_of(polyhedron.faces, [&](const auto& face) {
    const glm::dvec3& a = polyhedron.points[face[0]];
    const glm::dvec3 normal = glm::cross(polyhedron.points[face[1]] - a, polyhedron.points[face[2]] - a);
    return std::ranges::all_of(polyhedron.points,
                               [&](const glm::dvec3& point) { return glm::dot(normal, point - a) < 1e-9; });
  });
}

}  // namespace

TEST_CASE("a polyhedron's faces are turned outwards whatever their common orientation") {
  for (const std::string_view faces : {inward_box_faces, outward_box_faces}) {
    const Polyhedron box = solid(polyhedron(box_points, faces));
    CHECK(box.points.size() == 8);
    CHECK(box.faces.size() == 6);
    CHECK(faces_outwards(box));
  }
}

TEST_CASE("a mirrored polyhedron's faces point outwards in its own space") {
  CHECK(faces_outwards(solid("multmatrix([[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {" +
                             polyhedron(box_points, inward_box_faces) + "}")));
}

TEST_CASE("polyhedron() accepts its faces as the argument triangles or by position") {
  CHECK(solid("polyhedron(triangles = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]], points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]);")
            .faces.size() == 4);
  CHECK(solid("polyhedron([[0,0,0],[1,0,0],[0,1,0],[0,0,1]], [[0,1,2],[0,3,1],[0,2,3],[1,3,2]], 2);").faces.size() ==
        4);
}

TEST_CASE("points of a polyhedron that no face uses are dropped") {
  CHECK(solid(polyhedron("[[9,9,9],[0,0,0],[1,0,0],[0,1,0],[0,0,1]]", "[[1,2,3],[1,4,2],[1,3,4],[2,4,3]]"))
            .points.size() == 4);
}

TEST_CASE("equal points of a polyhedron are merged and faces that collapse dropped") {
  const Polyhedron soup = solid(
      polyhedron("[[0,0,0],[1,0,0],[0,1,0],[0,0,0],[0,0,1],[1,0,0],[-0,0,0],[0,1,0],[0,0,1],[1,0,0],[0,0,1],[0,1,0]]",
                 "[[0,1,2],[3,4,5],[6,7,8],[9,10,11],[0,3,6],[0,1,5,9]]"));
  CHECK(soup.points.size() == 4);
  CHECK(soup.faces.size() == 4);
  CHECK(faces_outwards(soup));
}

TEST_CASE("a polyhedron without faces or volume or with a non-finite point is empty") {
  CHECK(outline(read(polyhedron("[]", "[]"))) == "nothing");
  CHECK(outline(read(polyhedron(tetrahedron_points, "[]"))) == "nothing");
  CHECK(outline(read(polyhedron(tetrahedron_points, "undef"))) == "nothing");
  CHECK(outline(read(polyhedron("undef", "undef"))) == "nothing");
  CHECK(outline(read(polyhedron("[[0,0,0],[1,0,0],[0,1,0]]", "[[0,1,2],[2,1,0]]"))) == "nothing");
  CHECK(outline(read(polyhedron("[[0,0,0],[1,0,0],[0,1,0],[1,1,0]]", "[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]"))) ==
        "nothing");
  CHECK(outline(read(polyhedron("[[5,5,5],[5,5,5],[5,5,5],[5,5,5]]", "[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]"))) ==
        "nothing");
  CHECK(outline(read(polyhedron("[[0,0,0],[1,0,0],[0,1,0],[0,0,inf]]", "[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]"))) ==
        "nothing");
}

TEST_CASE("a polyhedron with a malformed point is empty and other solids are drawn") {
  for (const char* point :
       {"undef", "3", "\"a\"", "[0,5]", "[5,2,3,1]", "[1,undef,2]", "[0,0,inf]", "[nan,1,1]", "[]"}) {
    CAPTURE(point);
    const std::string text =
        polyhedron(std::string("[[0,0,0],[1,0,0],[0,1,0],") + point + "]", "[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]");
    CHECK(outline(read(text)) == "nothing");
    CHECK(outline(read(text + " cube(4);")) == "cube");
  }
}

TEST_CASE("a thin polyhedron and a tiny and a huge one are kept") {
  const std::string_view faces = "[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]";
  CHECK(outline(read(polyhedron("[[0,0,0],[1,0,0],[0,1,0],[0,0,1e-7]]", faces))) == "polyhedron");
  CHECK(outline(read(polyhedron("[[0,0,0],[1e-300,0,0],[0,1e-300,0],[0,0,1e-300]]", faces))) == "polyhedron");
  CHECK(outline(read(polyhedron("[[-1e308,0,0],[1e308,0,0],[0,1e308,0],[0,0,1e308]]", faces))) == "polyhedron");
}

TEST_CASE("an open polyhedron is rejected at the face next to the hole") {
  CHECK(error_of(polyhedron(tetrahedron_points, "[[0,1,2],[0,3,1],[0,2,3]]")) ==
        "m.csg:1:65: the mesh is open: no other face has the edge of faces[0] from points[1] to points[2]; add one");
}

TEST_CASE("the error for an open polyhedron names the edge that no other face has") {
  CHECK(error_of(polyhedron(tetrahedron_points, "[[0,1,2]]")) ==
        "m.csg:1:65: the mesh is open: no other face has the edge of faces[0] from points[0] to points[1]; add one");
  CHECK(error_of(polyhedron(tetrahedron_points, "[[0,1,2],[2,1,3]]")) ==
        "m.csg:1:65: the mesh is open: no other face has the edge of faces[0] from points[0] to points[1]; add one");
}

TEST_CASE("a concave polyhedron with coordinates beyond 1e12 is rejected") {
  // A prism with a W-shaped base: a wedge is cut out of it.
  const std::string far = polyhedron("[[0,0,0],[1e300,1,0],[0,2,0],[1,1,0],[0,0,1],[1e300,1,1],[0,2,1],[1,1,1]]",
                                     "[[3,2,1,0],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]");
  CHECK(error_of(far).find("points[1] has a coordinate beyond 1e+12; scale the solid down") != std::string::npos);
}

TEST_CASE("a polyhedron's single reversed face is turned") {
  CHECK(volume(read(polyhedron(tetrahedron_points, "[[0,1,2],[0,1,3],[0,2,3],[1,3,2]]"))) == doctest::Approx(1.0 / 6));
}

namespace {

/// Number of convex pieces of the model's only polyhedron.
std::size_t piece_count(const std::string& text) {
  const csgsim::model::Tree tree = read(text);
  const csgsim::model::Counts counts = csgsim::model::count(tree);
  CHECK(counts.primitives == 1);
  CHECK(counts.unions == 0);
  for (std::size_t i = 0; i < tree.primitives.size(); ++i) {
    CHECK(tree.primitives[i].continues == (i > 0));
    CHECK(tree.primitives[i].node == "polyhedron");
    CHECK(tree.primitives[i].location.line == 1);
  }
  return tree.primitives.size();
}

}  // namespace

TEST_CASE("a box with one raised corner has at most two pieces") {
  // The raised corner is on the diagonal along which a quadrangle is cut, or it is not.
  CHECK(piece_count(polyhedron("[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,1.25],[0,1,1]]",
                               outward_box_faces)) <= 2);
}

TEST_CASE("a polyhedron bent by less than 0.1 degrees is one primitive in a Boolean") {
  // Two corners of the top are lowered by 0.0005; in this orientation OpenSCAD cuts the top along the valley edge.
  const std::string bent =
      polyhedron("[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,0.9995],[1,1,1],[0,1,0.9995]]", outward_box_faces);
  const std::string turned = "multmatrix([[0,-1,0,0],[1,0,0,0],[0,0,1,0],[0,0,0,1]]) {" + bent + "}";
  CHECK(std::max(read(bent).primitives.size(), read(turned).primitives.size()) == 2);
  for (const std::string& one : {bent, turned}) {
    CHECK(read(one + "cube(9);").primitives.size() == 2);
    CHECK(read("difference() {" + one + "cube(9);}").primitives.size() == 2);
    CHECK(read("group() {" + one + "group();}").primitives.size() == read(one).primitives.size());
  }
}

TEST_CASE("a bent square's diagonal is chosen after its transforms up to the next Boolean") {
  // As in OpenSCAD 2021.01's export: two pieces if the top is split into a valley, one if it is split into a ridge.
  const std::string bent =
      polyhedron("[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,0.9],[1,1,1],[0,1,0.9]]", outward_box_faces);
  const auto turned = [](const std::string& what) {
    return "multmatrix([[0,-1,0,0],[1,0,0,0],[0,0,1,0],[0,0,0,1]]) {" + what + "}";
  };
  const std::size_t as_is = read(bent).primitives.size();
  CHECK(as_is + read(turned(bent)).primitives.size() == 3);
  CHECK(read("group() {" + bent + "cube(1);}").primitives.size() == as_is + 1);
  CHECK(read(turned(bent) + "cube(1);").primitives.size() == 3 - as_is + 1);
  CHECK(read(turned("group() {" + bent + "cube(1);}")).primitives.size() == as_is + 1);
}

TEST_CASE("a polyhedron with crossing faces is the solid they wind around") {
  // One polyhedron of two boxes that overlap in a quarter of each.
  const std::string_view points =
      "[[0,0,0],[2,0,0],[2,2,0],[0,2,0],[0,0,2],[2,0,2],[2,2,2],[0,2,2],"
      "[1,1,-1],[3,1,-1],[3,3,-1],[1,3,-1],[1,1,3],[3,1,3],[3,3,3],[1,3,3]]";
  const std::string faces =
      "[[0,1,2,3],[7,6,5,4],[4,5,1,0],[5,6,2,1],[6,7,3,2],[7,4,0,3],[8,9,10,11],[15,14,13,12],"
      "[12,13,9,8],[13,14,10,9],[14,15,11,10],[15,12,8,11]]";
  CHECK(volume(read(polyhedron(points, faces))) == doctest::Approx(8 + 16 - 2));
}

TEST_CASE("a polyhedron with faces crossing along edges is the solid they wind around") {
  // A box with a void; one corner of the void, (8, 8, 1), is moved to an edge of the box: the void is inside out there,
  // and the faces wind around 24.5 twice (24.4 by counting 10^6 points).
  const std::string_view points =
      "[[0,9,0],[9,9,0],[9,0,0],[0,0,0],[0,0,9],[9,0,9],[9,9,9],[0,9,9],"
      "[1,1,1],[8,1,1],[0,0,8],[1,8,1],[1,8,8],[8,8,8],[8,1,8],[1,1,8]]";
  const std::string_view faces =
      "[[3,2,1,0],[7,6,5,4],[4,5,2,3],[5,6,1,2],[6,7,0,1],[7,4,3,0],[10,9,8],[8,11,10],[15,14,13,12],[8,9,14,15],"
      "[13,14,9],[9,10,13],[13,10,12],[12,10,11],[11,8,15,12]]";
  CHECK(volume(read(polyhedron(points, faces))) == doctest::Approx(4178.0 / 6 - 24.5));
}

TEST_CASE("a bow-tie face of zero net area contributes to the winding") {
  // 0.501 by counting 2 * 10^6 points.
  const std::string_view points = "[[0,1,2],[1,1,0],[1,0,0],[0,0,0],[0,0,1],[1,0,1],[1,1,1],[0,1,1]]";
  const std::string_view faces = "[[2,1,0],[3,2,0],[7,6,5,4],[4,5,2,3],[5,6,1,2],[6,7,0,1],[7,4,3,0]]";
  CHECK(volume(read(polyhedron(points, faces))) == doctest::Approx(0.5));
}

TEST_CASE("a concave polyhedron is one primitive of several convex pieces") {
  CHECK(piece_count(polyhedron("[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0.1,0.1,0.1]]",
                               "[[0,2,1],[0,1,3],[0,3,2],[1,2,4],[2,3,4],[3,1,4]]")) > 1);
}

TEST_CASE("two solids in one polyhedron are two pieces of it") {
  CHECK(piece_count(polyhedron("[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[5,0,0],[6,0,0],[5,1,0],[5,0,1]]",
                               "[[0,1,2],[0,3,1],[0,2,3],[1,3,2],[4,5,6],[4,7,5],[4,6,7],[5,7,6]]")) == 2);
}

TEST_CASE("a polyhedron of one triangle or two with a common edge is rejected as open") {
  CHECK(error_of(polyhedron(tetrahedron_points, "[[0,1,2]]")).find("the mesh is open") != std::string::npos);
  CHECK(error_of(polyhedron(tetrahedron_points, "[[0,1,2],[1,3,2]]")).find("the mesh is open") != std::string::npos);
}

TEST_CASE("a polyhedron's face without area closes the gap between its neighbours") {
  CHECK(piece_count(polyhedron("[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0.5,0,0]]",
                               "[[0,4,1,2],[0,3,1],[0,1,4],[0,2,3],[1,3,2]]")) == 1);
}

TEST_CASE("a rotated box with coordinates of 6 digits is one polyhedron") {
  // A box rotated about (1, 2, 3), as OpenSCAD prints its corners.
  CHECK(outline(read(polyhedron("[[0,0,0],[0.728028,0.543834,-0.0389452],[0.202868,1.27183,0.484494],"
                                "[-0.525161,0.727999,0.523439],[0.314285,-0.273332,0.744126],"
                                "[1.04231,0.270502,0.705181],[0.517153,0.998502,1.22862],"
                                "[-0.210876,0.454667,1.26757]]",
                                outward_box_faces))) == "polyhedron");
}

namespace {

/// Checks that the faces give a tetrahedron of volume 1/6, as in OpenSCAD 2021.01, with exactly this warning.
void check_drawn(const std::string& faces, const std::string& warning) {
  CAPTURE(faces);
  const auto [tree, warnings] = read_with_warnings(polyhedron(tetrahedron_points, faces));
  CHECK(volume(tree) == doctest::Approx(1.0 / 6));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == "m.csg:1:" + warning + ", as in OpenSCAD");
}

}  // namespace

TEST_CASE("a face's index without a point is skipped with a warning like in OpenSCAD") {
  const std::string rest = ",[0,3,1],[0,2,3],[1,3,2]]";
  const auto no_point = [](int column, const char* index) {
    return fmt::format("{}: warning: points[{}] does not exist; there are points[0] to points[3]; the index is dropped",
                       column, index);
  };
  check_drawn("[[0,1,2,4]" + rest, no_point(72, "4"));
  check_drawn("[[0,1,-1,2]" + rest, no_point(70, "-1"));
  check_drawn("[[0,1,nan,2]" + rest, no_point(70, "nan"));
  check_drawn("[[0,7,1,4,2]" + rest, no_point(68, "7"));
  check_drawn("[[1,0,9],[0,1,2]" + rest, no_point(70, "9"));
}

TEST_CASE("fractional indices of faces are truncated and others count as 0 like in OpenSCAD") {
  const std::string rest = ",[0,3,1],[0,2,3],[1,3,2]]";
  check_drawn("[[0,1,2.9]" + rest, "70: warning: the index of a point is 2.9, not a whole number; it counts as 2");
  check_drawn("[[-0.5,1,2]" + rest, "66: warning: the index of a point is -0.5, not a whole number; it counts as 0");
  for (const std::string index : {"undef", "\"a\"", "true", "[3]"})
    check_drawn("[[" + index + ",1,2]" + rest, "66: warning: the index of a point is not a number; it counts as 0");
}

TEST_CASE("a malformed face is dropped with a warning like in OpenSCAD") {
  const std::string rest = ",[0,1,2],[0,3,1],[0,2,3],[1,3,2]]";
  for (const std::string face : {"[0,1]", "[2]", "[]"})
    check_drawn("[" + face + rest, "65: warning: a face has fewer than 3 corners; it is dropped");
  for (const std::string face : {"undef", "7"})
    check_drawn("[" + face + rest, "65: warning: this is not a vector of point indices; it is dropped");
}

TEST_CASE("faces after a malformed one keep their numbers in messages") {
  CHECK(error_of(polyhedron(tetrahedron_points, "[[0,9],[0,1,2],[0,3,1],[0,2,3]]")) ==
        "m.csg:1:71: the mesh is open: no other face has the edge of faces[1] from points[1] to points[2]; add one");
}

TEST_CASE("a polyhedron without valid faces is empty and warns") {
  for (const auto& one : {std::pair("[]", "[[0,1,2]]"), std::pair("[[0,0,0]]", "[[1,2,3]]"),
                          std::pair("[[0,0,0],[1,0,0],[0,1,0]]", "[0,1,2]")}) {
    CAPTURE(one.second);
    const auto [tree, warnings] = read_with_warnings(polyhedron(one.first, one.second));
    CHECK(outline(tree) == "nothing");
    CHECK(warnings.size() == 1);
  }
}

TEST_CASE("arguments of a polyhedron of the wrong type are rejected") {
  CHECK(error_of(polyhedron(tetrahedron_points, "true")) ==
        "m.csg:1:64: faces of polyhedron() must be a vector of faces");
  CHECK(error_of(polyhedron("3", "[]")) == "m.csg:1:21: points of polyhedron() must be a vector of [x, y, z]");
  CHECK(error_of("polyhedron(points = []);") ==
        "m.csg:1:1: polyhedron() lacks its faces; add faces = [[0, 1, 2], ...]");
  CHECK(error_of("polyhedron(faces = []);") ==
        "m.csg:1:1: polyhedron() lacks its points; add points = [[x, y, z], ...]");
  CHECK(error_of("polyhedron(points = [], faces = [], triangles = []);") ==
        "m.csg:1:1: faces and triangles are both given; remove one");
}
