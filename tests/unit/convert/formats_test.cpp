#include "sim/software/convert/formats.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/read/read.h"
#include "host/solids/read_mesh.h"
#include "host/solids/unzip.h"
#include "hw/base/error.h"
#include "places.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/surface.h"
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

TEST_CASE("each format is read back as a closed mesh of the same volume") {
  for (const char* const name : {"carburettor", "old_example003", "thesis_fig_2_3"}) {
    CAPTURE(name);
    const convert::Surface surface = surface_of_file(name);
    const double volume = testing::volume_of(testing::judged(surface));
    for (const convert::Format* const format : convert::formats()) {
      for (const bool is_text : {false, true}) {
        if (is_text && !format->has_text) continue;
        CAPTURE(format->ending);
        CAPTURE(is_text);
        const testing::JudgedMesh mesh =
            read_back(format->write(surface, {.is_text = is_text}), std::string(format->ending));
        CHECK(testing::welded_fault_of(mesh) == "");
        // Single precision has 24 bits, and texts of STL are read in it too, as OpenSCAD does.
        const bool is_single = format == &convert::stl_format;
        CHECK(testing::volume_of(mesh) == doctest::Approx(volume).epsilon(is_single ? 1e-6 : 1e-14));
      }
    }
  }
}

TEST_CASE("OFF has polygons that share points, without a point on an edge") {
  const convert::Surface surface = surface_of_file("carburettor");
  const testing::JudgedMesh mesh = read_back(convert::off_format.write(surface, {}), ".off");
  CHECK(testing::fault_of(mesh) == "");
  CHECK(mesh.points.size() == surface.points.size());
  CHECK(mesh.faces.size() < surface.triangles.size());
  const testing::JudgedMesh cube =
      read_back(convert::off_format.write(testing::converted("cube([1,2,3]);"), {}), ".off");
  CHECK(cube.faces.size() == 6);
}

TEST_CASE("a format is known by the end of a name, in small letters or capitals") {
  CHECK(convert::format_of("a/b.stl") == &convert::stl_format);
  CHECK(convert::format_of("B.STL") == &convert::stl_format);
  CHECK(convert::format_of("b.3mf") == &convert::three_mf_format);
  CHECK(convert::format_of("b.stl.png") == nullptr);
  CHECK(convert::format_of("stl") == nullptr);
}

TEST_CASE("a zipped mesh has the same bytes whenever it is written") {
  const convert::Surface surface = testing::converted("cube([1,2,3]);");
  CHECK(convert::three_mf_format.write(surface, {}) == convert::three_mf_format.write(surface, {}));
}

TEST_CASE("binary STL leaves out triangles whose corners are one in single precision, whichever two") {
  const convert::Surface cube =
      testing::converted("multmatrix([[1,0,0,5],[0,1,0,5],[0,0,1,5],[0,0,0,1]]){cube([1,2,3]);}");
  // A point on an edge, nearer to one of its ends than single precision tells.
  const convert::Triangle first = cube.triangles.front();
  const auto [a, b, c] = first;
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
    const std::string bytes = convert::stl_format.write(split, {});
    CHECK(bytes.size() == 84 + 50 * 12);
    CHECK(testing::welded_fault_of(read_back(bytes, ".stl")) == "");
  }
}

TEST_CASE("binary STL refuses a model that single precision would change") {
  const convert::Surface far = testing::converted(
      "cube([2,2,2]);multmatrix([[1,0,0,3000000000],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube([2,2,2]);}");
  CHECK_THROWS_WITH_AS(convert::stl_format.write(far, {}),
                       "binary STL has single precision, which would change the volume of this model by more than a "
                       "thousandth, since its coordinates reach 3e+09; write .off or .3mf, or an STL text with --ascii",
                       InputError);
  CHECK(convert::measure(far).volume == 16);
  CHECK(!convert::stl_format.write(far, {.is_text = true}).empty());
  CHECK(testing::volume_of(read_back(convert::off_format.write(far, {}), ".off")) == 16);
}

TEST_CASE("3MF states millimetres") {
  const std::string bytes = convert::three_mf_format.write(testing::converted("cube([1,2,3]);"), {});
  const std::string model = solids::unzip(bytes, "cube.3mf", "3D/3dmodel.model");
  CHECK(model.find("<model unit=\"millimeter\"") != std::string::npos);
}
