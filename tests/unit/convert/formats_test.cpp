#include "sim/software/convert/formats.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "host/read/read.h"
#include "host/solids/read_mesh.h"
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
