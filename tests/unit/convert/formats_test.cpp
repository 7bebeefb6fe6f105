#include "sim/software/convert/formats.h"

#include "host/read/read.h"
#include "host/solids/read_mesh.h"
#include "host/solids/unzip.h"
#include "places.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/flat_rounds.h"
#include "sim/software/convert/surface.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"

using namespace csgsim;
namespace convert = software::convert;

namespace {

convert::Surface surface_of_file(const std::string& name) {
  return convert::make_surface(
      convert::boundary(read::read_csg_file(CSGSIM_SOURCE_DIR "/tests/models/" + name + ".csg")));
}

testing::JudgedMesh read_back(const std::string& content, const std::string& ending) {
  const std::vector<solids::Mesh> meshes = solids::parse_meshes(content, "mesh" + ending);
  REQUIRE(meshes.size() == 1);
  return {meshes[0].points, meshes[0].faces};
}

}  // namespace

TEST_CASE("each mesh format reads back as a closed mesh of the same volume") {
  for (const char* const name : {"carburettor", "old_example003", "thesis_fig_2_3"}) {
    CAPTURE(name);
    const convert::Surface surface = surface_of_file(name);
    const double volume = testing::volume_of(testing::judged(surface));
    for (const convert::Format* const format : convert::formats()) {
      for (const bool is_text : {false, true}) {
        if (format->is_flat || (is_text && !format->has_text)) continue;
        CAPTURE(format->ending);
        CAPTURE(is_text);
        const testing::JudgedMesh mesh =
            read_back(format->write(surface, {.is_text = is_text}), std::string(format->ending));
        CHECK(testing::welded_fault_of(mesh) == "");
        // Single precision has 24 bits. STL texts are also read in single precision, as in OpenSCAD.
        const bool is_single = format->ending == ".stl";
        CHECK(testing::volume_of(mesh) == doctest::Approx(volume).epsilon(is_single ? 1e-6 : 1e-14));
      }
    }
  }
}

TEST_CASE("OFF has polygons with shared points and no point on an edge") {
  const convert::Surface surface = surface_of_file("carburettor");
  const testing::JudgedMesh mesh = read_back(convert::format_of(".off")->write(surface, {}), ".off");
  CHECK(testing::fault_of(mesh) == "");
  CHECK(mesh.points.size() == surface.points.size());
  CHECK(mesh.faces.size() < surface.triangles.size());
  const testing::JudgedMesh cube =
      read_back(convert::format_of(".off")->write(testing::converted("cube([1,2,3]);"), {}), ".off");
  CHECK(cube.faces.size() == 6);
}

TEST_CASE("the mesh format is that of the file name's extension in either case") {
  CHECK(convert::format_of("a/b.stl")->ending == ".stl");
  CHECK(convert::format_of("B.STL")->ending == ".stl");
  CHECK(convert::format_of("b.3mf")->ending == ".3mf");
  CHECK(convert::format_of("b.stl.png") == nullptr);
  CHECK(convert::format_of("stl") == nullptr);
}

TEST_CASE("a zipped mesh has the same bytes every time it is written") {
  const convert::Surface surface = testing::converted("cube([1,2,3]);");
  CHECK(convert::format_of(".3mf")->write(surface, {}) == convert::format_of(".3mf")->write(surface, {}));
}

TEST_CASE("binary STL omits triangles that collapse in single precision") {
  const convert::Surface cube =
      testing::converted("multmatrix([[1,0,0,5],[0,1,0,5],[0,0,1,5],[0,0,0,1]]){cube([1,2,3]);}");
  // A point on an edge, closer to one of its ends than single precision can resolve.
  const convert::Triangle first = cube.triangles.front();
  const std::uint32_t a = first[0];
  const std::uint32_t b = first[1];
  const std::uint32_t c = first[2];
  const auto other = std::ranges::find_if(cube.triangles, [&](const convert::Triangle& triangle) {
    return std::ranges::count(triangle, a) == 1 && std::ranges::count(triangle, b) == 1 && triangle != first;
  });
  REQUIRE(other != cube.triangles.end());
  const std::uint32_t d =
      *std::ranges::find_if(*other, [&](std::uint32_t corner) { return corner != a && corner != b; });
  const auto q = static_cast<std::uint32_t>(cube.points.size());
  for (std::size_t turn = 0; turn < 3; ++turn) {
    CAPTURE(turn);
    const auto turned = [&](convert::Triangle triangle) {
      std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(turn), triangle.end());
      return triangle;
    };
    convert::Surface split = cube;
    split.points.push_back(cube.points[a] + 1e-12 * (cube.points[b] - cube.points[a]));
    split.triangles.erase(split.triangles.begin() + (other - cube.triangles.begin()));
    split.triangles.erase(split.triangles.begin());
    split.outlines.resize(split.triangles.size());
    for (const convert::Triangle& added : {convert::Triangle{a, q, c}, {q, b, c}, {q, a, d}, {b, q, d}}) {
      split.triangles.push_back(turned(added));
      split.outlines.push_back(0);
    }
    REQUIRE(testing::sides_fault_of(testing::judged(split)) == "");
    const std::string bytes = convert::format_of(".stl")->write(split, {});
    CHECK(bytes.size() == 84 + 50 * 12);
    CHECK(testing::welded_fault_of(read_back(bytes, ".stl")) == "");
  }
}

TEST_CASE("binary STL rejects a model that single precision would distort") {
  const convert::Surface far = testing::converted(
      "cube([2,2,2]);multmatrix([[1,0,0,3000000000],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube([2,2,2]);}");
  CHECK_THROWS_WITH_AS(
      convert::format_of(".stl")->write(far, {}),
      "binary STL has single precision, which would change the volume of this model by more than a "
      "thousandth, because its coordinates reach 3e+09; write .off or .3mf, or a text STL with --ascii",
      InputError);
  CHECK(convert::measure(far).volume == 16);
  CHECK(!convert::format_of(".stl")->write(far, {.is_text = true}).empty());
  CHECK(testing::volume_of(read_back(convert::format_of(".off")->write(far, {}), ".off")) == 16);
}

TEST_CASE("3MF declares millimetres as its unit") {
  const std::string bytes = convert::format_of(".3mf")->write(testing::converted("cube([1,2,3]);"), {});
  const std::string model = solids::unzip(bytes, "cube.3mf", "3D/3dmodel.model");
  CHECK(model.find("<model unit=\"millimeter\"") != std::string::npos);
}

namespace {

/// A tetrahedron with a corner at the origin and edges along the axes.
convert::Surface small_surface() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 0.1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {0, 1, 2, 3}};
}

std::uint32_t word_at(const std::string& bytes, std::size_t at, int count = 4) {
  std::uint32_t word = 0;
  for (int i = 0; i < count; ++i)
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i))))
            << (8 * i);
  return word;
}

float float_at(const std::string& bytes, std::size_t at) { return std::bit_cast<float>(word_at(bytes, at)); }

}  // namespace

TEST_CASE("formats() lists each mesh format with its extension and text variant") {
  std::vector<std::string> endings;
  for (const convert::Format* const format : convert::formats()) {
    endings.emplace_back(format->ending);
    CHECK(format->has_text == (format->ending == ".stl" || format->ending == ".ply"));
    CHECK(format->is_flat == (format->ending == ".svg" || format->ending == ".dxf"));
    CHECK(format->name() == format->ending.substr(1));
    CHECK(format->is_binary == (format->has_text || format->ending == ".3mf"));
    CHECK(convert::format_of(format->ending) == format);
    CHECK(convert::format_of(format->ending.substr(1)) == nullptr);
    CHECK(convert::format_of("a" + std::string(format->ending) + "x") == nullptr);
  }
  CHECK(endings == std::vector<std::string>{".stl", ".off", ".obj", ".ply", ".3mf", ".amf", ".svg", ".dxf"});
  CHECK(convert::format_of("") == nullptr);
}

TEST_CASE("binary STL has the bytes of its specification") {
  const std::string bytes = convert::format_of(".stl")->write(small_surface(), {});
  REQUIRE(bytes.size() == 84 + 4 * 50);
  CHECK(bytes.substr(0, 20) == "binary STL by csgsim");
  CHECK(bytes.substr(20, 60) == std::string(60, ' '));
  CHECK(word_at(bytes, 80) == 4);
  // The second facet lies in the plane of x and z and faces -y.
  const std::array<float, 12> second{0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.1F};
  for (std::size_t i = 0; i < second.size(); ++i) CHECK(float_at(bytes, 84 + 50 + 4 * i) == second[i]);
  CHECK(word_at(bytes, 84 + 50 + 48, 2) == 0);
  // The normal of the last facet is (0.2, 0.1, 2), divided by the root of 4.05.
  CHECK(float_at(bytes, 84 + 150) == doctest::Approx(0.2 / std::sqrt(4.05)));
  CHECK(float_at(bytes, 84 + 154) == doctest::Approx(0.1 / std::sqrt(4.05)));
  CHECK(float_at(bytes, 84 + 158) == doctest::Approx(2 / std::sqrt(4.05)));
}

TEST_CASE("an empty surface is written as a valid file in each format") {
  CHECK(convert::format_of(".stl")->write({}, {}).size() == 84);
  CHECK(convert::format_of(".stl")->write({}, {.is_text = true}) == "solid csgsim\nendsolid csgsim\n");
  CHECK(convert::format_of(".off")->write({}, {}) == "OFF\n0 0 0\n");
  CHECK(convert::format_of(".obj")->write({}, {}) == "# csgsim\n");
  CHECK(convert::format_of(".dxf")->write({}, {}) == "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n");
}

TEST_CASE("OBJ text has the exact numbers and counts points from 1") {
  CHECK(convert::format_of(".obj")->write(small_surface(), {}) ==
        "# csgsim\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
}

TEST_CASE("PLY has the exact numbers as text and the bytes of its header in binary") {
  const auto header = [](const std::string& form) {
    return "ply\nformat " + form +
           " 1.0\ncomment csgsim\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  };
  CHECK(convert::format_of(".ply")->write(small_surface(), {.is_text = true}) ==
        header("ascii") + "0 0 0\n1 0 0\n0 2 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const std::string bytes = convert::format_of(".ply")->write(small_surface(), {});
  const std::string begin = header("binary_little_endian");
  REQUIRE(bytes.size() == begin.size() + 4 * 24 + 4 * 13);
  CHECK(bytes.starts_with(begin));
  // The x of the second point is 1; the first face is 0 2 1.
  CHECK(word_at(bytes, begin.size() + 24) == 0);
  CHECK(word_at(bytes, begin.size() + 28) == 0x3ff00000);
  const std::size_t face = begin.size() + 4 * 24;
  CHECK(word_at(bytes, face, 1) == 3);
  CHECK(word_at(bytes, face + 1) == 0);
  CHECK(word_at(bytes, face + 5) == 2);
  CHECK(word_at(bytes, face + 9) == 1);
}

TEST_CASE("AMF has the exact numbers and one object in millimetres") {
  const std::string text = convert::format_of(".amf")->write(small_surface(), {});
  CHECK(
      text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf unit=\"millimeter\">\n <object id=\"0\">\n"));
  CHECK(text.find("<vertex><coordinates><x>0</x><y>0</y><z>0.1</z></coordinates></vertex>\n") != std::string::npos);
  CHECK(text.find("<triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle>\n") != std::string::npos);
}

TEST_CASE("a flat model has counter-clockwise outlines and clockwise holes in SVG and DXF") {
  const convert::Surface surface = testing::converted(
      "difference() { polygon(points = [[3, 1], [13, 1], [3, 9]], paths = undef, convexity = 1); "
      "multmatrix([[1, 0, 0, 4], [0, 1, 0, 2], [0, 0, 1, 0], [0, 0, 0, 1]]) { square(size = [2, 1], center = false); } "
      "}");
  const convert::Rounds rounds = convert::flat_rounds(surface);
  REQUIRE(rounds.size() == 2);
  CHECK(convert::area_of(rounds) == 40 - 2);
  std::vector<double> areas{convert::area_of({rounds[0]}), convert::area_of({rounds[1]})};
  std::ranges::sort(areas);
  CHECK(areas == std::vector<double>{-2, 40});
  const std::string svg = convert::format_of(".svg")->write(surface, {});
  CHECK(svg.find("width=\"10mm\" height=\"8mm\" viewBox=\"3 -9 10 8\"") != std::string::npos);
  CHECK(std::ranges::count(svg, 'M') == 2);
  CHECK(std::ranges::count(svg, 'L') == 5);
  CHECK(svg.find(" 13,-1 ") != std::string::npos);
  const std::string dxf = convert::format_of(".dxf")->write(surface, {});
  std::size_t lines = 0;
  for (std::size_t at = dxf.find("LINE\n"); at != dxf.npos; at = dxf.find("LINE\n", at + 1)) ++lines;
  CHECK(lines == 7);
}

TEST_CASE("STL text has the exact numbers and a zero normal for an empty triangle") {
  convert::Surface surface = small_surface();
  surface.triangles = {{0, 1, 3}, {0, 1, 1}};
  CHECK(convert::format_of(".stl")->write(surface, {.is_text = true}) ==
        "solid csgsim\n"
        "facet normal 0 -1 0\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 0 0.1\n endloop\nendfacet\n"
        "facet normal 0 0 0\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 0 0\n endloop\nendfacet\n"
        "endsolid csgsim\n");
}

TEST_CASE("OFF text has the exact numbers") {
  CHECK(convert::format_of(".off")->write(small_surface(), {}) ==
        "OFF\n4 4 0\n0 0 0\n1 0 0\n0 2 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST_CASE("a 3MF package has the exact numbers and one object and all required parts") {
  const std::string bytes = convert::format_of(".3mf")->write(small_surface(), {});
  CHECK(solids::unzip(bytes, "a.3mf", "3D/3dmodel.model") ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
        " <resources>\n  <object id=\"1\" type=\"model\">\n   <mesh>\n    <vertices>\n"
        "     <vertex x=\"0\" y=\"0\" z=\"0\" />\n     <vertex x=\"1\" y=\"0\" z=\"0\" />\n"
        "     <vertex x=\"0\" y=\"2\" z=\"0\" />\n     <vertex x=\"0\" y=\"0\" z=\"0.1\" />\n    </vertices>\n"
        "    <triangles>\n     <triangle v1=\"0\" v2=\"2\" v3=\"1\" />\n     <triangle v1=\"0\" v2=\"1\" v3=\"3\" />\n"
        "     <triangle v1=\"0\" v2=\"3\" v3=\"2\" />\n     <triangle v1=\"1\" v2=\"2\" v3=\"3\" />\n    </triangles>\n"
        "   </mesh>\n  </object>\n </resources>\n <build>\n  <item objectid=\"1\" />\n </build>\n</model>\n");
  CHECK(solids::unzip(bytes, "a.3mf", "[Content_Types].xml").find("Extension=\"model\"") != std::string::npos);
  CHECK(solids::unzip(bytes, "a.3mf", "_rels/.rels").find("Target=\"/3D/3dmodel.model\"") != std::string::npos);
  // The first local header: PK 3 4, deflated, time 0 on 1 January 1980 (day in bits 0 to 4, month from bit 5).
  CHECK(word_at(bytes, 0) == 0x04034b50);
  CHECK(word_at(bytes, 8, 2) == 8);
  CHECK(word_at(bytes, 10, 2) == 0);
  CHECK(word_at(bytes, 12, 2) == (1U << 5U | 1U));
}

TEST_CASE("binary STL may change a volume by at most a thousandth along each axis") {
  // Floats from 2^24 are 2 apart, so 0.9 above an even number is rounded down, from a size of 900.9 or 898.9.
  for (int axis = 0; axis < 3; ++axis) {
    for (const double size : {900.9, 898.9}) {
      CAPTURE(axis);
      CAPTURE(size);
      convert::Surface surface = small_surface();
      for (glm::dvec3& point : surface.points) {
        const double height = std::array{1.0, 2.0, 0.1}.at(static_cast<std::size_t>(axis));
        point[axis] = 0x1p24 + point[axis] / height * size;
      }
      const std::string refusal = testing::error_of([&] { convert::format_of(".stl")->write(surface, {}); });
      CHECK(refusal.empty() == (size > 900));
      if (!refusal.empty()) CHECK(refusal.find("because its coordinates reach 1.68e+07;") != std::string::npos);
    }
  }
}