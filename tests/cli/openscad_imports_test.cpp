#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "places.h"
#include "tests/cli/cli.h"
#include "tests/support/off_file.h"

using namespace csgsim::testing::cli;

namespace {

/// Volume and bounding box of a mesh, for comparison with another mesh of the same solid.
struct Extent {
  double volume = 0;
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  /// Adds a triangle and the volume between it and the origin.
  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    for (const glm::dvec3& corner : {a, b, c}) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
};

/// The extent of an OFF file written by OpenSCAD.
Extent extent_of(const std::string& path) {
  const csgsim::testing::Mesh mesh = csgsim::testing::read_off(path);
  Extent extent;
  for (const std::vector<unsigned>& face : mesh.faces) {
    for (std::size_t at = 1; at + 1 < face.size(); ++at)
      extent.add(mesh.points.at(face[0]), mesh.points.at(face[at]), mesh.points.at(face[at + 1]));
  }
  return extent;
}

/// The points and triangles of OBJ, or of PLY as text, as OFF.
std::string off_of(const std::string& mesh) {
  std::istringstream lines(mesh);
  std::string points;
  std::string faces;
  std::size_t point_count = 0;
  std::size_t face_count = 0;
  bool is_body = !mesh.starts_with("ply\n");
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "f") {
      faces += "3";
      for (int corner = 0; words >> corner;) faces += fmt::format(" {}", corner - 1);
      faces += "\n";
      ++face_count;
    } else if (is_body && first == "3" && std::ranges::count(line, ' ') == 3) {
      faces += line + "\n";
      ++face_count;
    } else if (is_body && !first.starts_with('#')) {
      points += (first == "v" ? line.substr(2) : line) + "\n";
      ++point_count;
    }
    is_body = is_body || line == "end_header";
  }
  return fmt::format("OFF\n{} {} 0\n{}{}", point_count, face_count, points, faces);
}

bool is_installed() { return run_program("openscad", {"--version"}).code == 0; }

/// The extent of OpenSCAD's evaluation of a source text; its polyhedra must be manifolds.
Extent evaluated(const Folder& folder, const std::string& scad) {
  write(folder / "judge.scad", scad);
  const Outcome outcome = require_success(run_program("openscad", {"-o", "judge.off", "judge.scad"}, folder.path()));
  CHECK_MESSAGE(outcome.err.find("WARNING") == std::string::npos, outcome.err);
  CHECK_MESSAGE(outcome.err.find("ERROR") == std::string::npos, outcome.err);
  const std::size_t simple = outcome.err.find("Simple:");
  REQUIRE_MESSAGE(simple != std::string::npos, outcome.err);
  CHECK(outcome.err.find("yes", simple) < outcome.err.find('\n', simple));
  return extent_of(folder / "judge.off");
}

void compare(const Extent& one, const Extent& other) {
  const double size = glm::length(other.high - other.low);
  CHECK(one.volume == doctest::Approx(other.volume).epsilon(2e-5));  // coordinates have six digits
  CHECK(glm::distance(one.low, other.low) < 1e-5 * size);
  CHECK(glm::distance(one.high, other.high) < 1e-5 * size);
}

constexpr std::array names{"seams",       "lattice", "extrude_twist_far", "mesh_booleans", "polyhedron_hollow",
                           "surface_cut", "mirrored"};

}  // namespace

// OpenSCAD cannot import its own meshes of solids that touch themselves either, such as extrude_twist_full at its apex.
// A surrounding cube makes OpenSCAD evaluate the mesh with CGAL's Nef polyhedra, which rejects meshes that are open.
TEST_CASE("OpenSCAD imports our meshes as manifolds of the volume and extent it computes") {
  if (!is_installed()) {
    MESSAGE("skipped: openscad is not installed");
    return;
  }
  for (const char* const name : names) {
    CAPTURE(name);
    const std::string path = std::string(CSGSIM_SOURCE_DIR "/tests/corpus/") + name + ".csg";
    const Folder folder;
    require_success(run_program("openscad", {"-o", folder / "own.off", path}, folder.path()));
    const Extent theirs = extent_of(folder / "own.off");
    for (const char* const ending : {"stl", "off", "3mf", "amf"}) {
      CAPTURE(ending);
      const std::string file = std::string("mesh.") + ending;
      require_success(run("convert " + path + " --imports-from " CSGSIM_SOURCE_DIR "/tests -o " + (folder / file)));
      compare(evaluated(folder, "intersection() { import(\"" + file + "\"); cube(10000, center = true); }"), theirs);
    }
    // OpenSCAD 2021.01 reads neither of these.
    for (const char* const ending : {"obj", "ply"}) {
      CAPTURE(ending);
      const std::string file = folder / (std::string("mesh.") + ending);
      std::vector<std::string> words{"convert", path, "--imports-from", CSGSIM_SOURCE_DIR "/tests", "-o", file};
      if (ending == std::string("ply")) words.emplace_back("--ascii");
      require_success(run_words(words));
      write(folder / "copy.off", off_of(content(file)));
      compare(evaluated(folder, "intersection() { import(\"copy.off\"); cube(10000, center = true); }"), theirs);
    }
  }
}

TEST_CASE("OpenSCAD imports our drawings with the area and extent of OpenSCAD's") {
  if (!is_installed()) {
    MESSAGE("skipped: openscad is not installed");
    return;
  }
  const Folder folder;
  const std::string flat =
      "difference() { square([10, 8]); translate([3, 3]) circle(2, $fn = 12); }\n"
      "translate([20, -5]) rotate(30) offset(r = 1, $fn = 20) square([3, 4]);\n"
      "translate([-10, 2]) { difference() { circle(5); circle(4); } circle(3); }\n"
      "translate([12, 8]) square(2);\n";
  write(folder / "flat.scad", flat);
  const auto extruded = [&](const std::string& shape) {
    return evaluated(folder, "intersection() { linear_extrude(3) { " + shape + " } cube(10000, center = true); }");
  };
  const double volume = extruded(flat).volume;
  for (const std::string ending : {".svg", ".dxf"}) {
    CAPTURE(ending);
    require_success(run_words({"convert", "flat.scad", "-o", "ours" + ending, "--stats", "flat.json"}, folder.path()));
    CHECK(3 * json(folder / "flat.json")["area"].get<double>() == doctest::Approx(volume).epsilon(2e-5));
    require_success(run_program("openscad", {"-o", "theirs" + ending, "flat.scad"}, folder.path()));
    compare(extruded("import(\"ours" + ending + "\");"), extruded("import(\"theirs" + ending + "\");"));
  }
}
