#include "host/read/read.h"
#include "places.h"
#include "sim/software/convert/surface.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"

using namespace csgsim;

// openscad_volumes.txt lists the volumes of OpenSCAD 2021.01's STL files, which have coordinates of six digits.
TEST_CASE("the models of the corpus convert to closed meshes with OpenSCAD's volumes") {
  const std::string tests = CSGSIM_SOURCE_DIR "/tests";
  std::ifstream volumes(tests + "/unit/convert/openscad_volumes.txt");
  std::string name;
  double volume = 0;
  int models = 0;
  while (volumes >> name >> volume) {
    CAPTURE(name);
    const model::Tree tree = read::read_csg_file(tests + "/" + name + ".csg", {.imports_from = tests});
    const testing::JudgedMesh mesh = testing::judged(testing::converted(tree));
    CHECK(testing::fault_of(mesh) == "");
    CHECK(testing::volume_of(mesh) == doctest::Approx(volume).epsilon(1e-5));
    ++models;
  }
  CHECK(models == 113);
}
