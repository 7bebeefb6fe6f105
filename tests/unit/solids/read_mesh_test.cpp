#include "host/solids/read_mesh.h"

#include "host/solids/check.h"
#include "host/solids/limits.h"
#include "hw/base/input_file.h"
#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using solids::Mesh;
using testing::error_of;

namespace {

std::filesystem::path model_file(const std::string& name) {
  return std::string(CSGSIM_SOURCE_DIR) + "/tests/models/solids/" + name;
}

std::string bytes_of(const std::string& name) { return read_file(model_file(name), {"a file", 1U << 20U, ""}); }

void append_word(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(word >> (8 * i) & 0xffU));
}

/// A mesh of triangles as a binary STL file.
std::string binary_stl(const Mesh& mesh) {
  std::string bytes(80, ' ');
  append_word(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const auto& face : mesh.faces) {
    bytes.append(12, '\0');
    for (const std::uint32_t corner : face) {
      for (int axis = 0; axis < 3; ++axis) {
        append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(mesh.points[corner][axis])));
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

double volume_of(const Mesh& mesh) { return testing::volume_of(mesh.points, mesh.faces); }

std::string off_error(const std::string& text) {
  return error_of([&] { solids::parse_off(text, "m.off"); });
}

std::string stl_error(const std::string& text) {
  return error_of([&] { solids::parse_stl(text, "m.stl"); });
}

}  // namespace

TEST_CASE("every mesh format yields the same solid") {
  // A block of 4 by 3 by 2 minus a corner of 2.5 by 1.75.
  constexpr double volume = 2 * (4 * 3 - 2.5 * 1.75);
  for (const char* name :
       {"corner.off", "corner.obj", "corner.ply", "corner.stl", "corner.amf", "corner_zipped.amf", "corner.3mf"}) {
    CAPTURE(name);
    const auto meshes = solids::parse_meshes(bytes_of(name), model_file(name));
    REQUIRE(meshes.size() == 1);
    const auto checked = solids::check(meshes[0], solids::printed_tolerance);
    CHECK(!checked.defect);
    CHECK(checked.mesh.points.size() == 12);
    CHECK(volume_of(checked.mesh) == doctest::Approx(volume).epsilon(1e-12));
  }
}

TEST_CASE("a binary STL file may start with 'solid' and has single-precision coordinates") {
  const Mesh mesh = solids::parse_meshes(bytes_of("bite.off"), model_file("bite.off"))[0];
  std::string bytes = binary_stl(mesh);
  bytes.replace(0, 5, "solid");
  const Mesh read = solids::parse_stl(bytes, "m.stl");
  REQUIRE(read.faces.size() == mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& got = read.points[read.faces[i][k]];
      const glm::dvec3& want = mesh.points[mesh.faces[i][k]];
      for (int axis = 0; axis < 3; ++axis) REQUIRE(got[axis] == static_cast<double>(static_cast<float>(want[axis])));
    }
  }
}

TEST_CASE("a binary STL file of wrong length or with an infinite coordinate is rejected") {
  const Mesh mesh = solids::parse_meshes(bytes_of("corner.off"), model_file("corner.off"))[0];
  std::string bytes = binary_stl(mesh);
  CHECK(stl_error(bytes + "x") ==
        "m.stl: a binary STL file of 20 triangles has 1084 bytes, and this one has 1085; export it again");
  CHECK(stl_error(bytes.substr(0, 83)) == "m.stl: not an STL file; export it again");
  for (std::size_t i = 0; i < 4; ++i) {
    bytes[84 + 50 * 3 + 12 + i] =
        static_cast<char>(std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity()) >> (8 * i) & 0xffU);
  }
  CHECK(stl_error(bytes) == "m.stl: triangle 4 of 20 has a coordinate that is not finite; correct it");
}

TEST_CASE("STL text is read word by word in any case with all of its solids") {
  const std::string facet =
      " FACET normal 0 nan 1\n outer loop vertex 0 0 0 vertex +1e0 0 0\r\n vertex 0 1 0 endloop endfacet\n";
  CHECK(solids::parse_stl("solid a b\n" + facet + "endsolid a b\n\nsolid\n" + facet + facet + "endsolid", "m.stl")
            .faces.size() == 3);
  CHECK(stl_error("solid\n" + facet) == "m.stl:5:1: expected 'facet' or 'endsolid'; export it as STL again");
  CHECK(stl_error("solid\nfacet normal 0 0 1 outer loop\n vertex 0 zero 0") ==
        "m.stl:3:11: a coordinate must be a finite number, not 'zero'; correct it");
  CHECK(stl_error("solid\nfacet normal 0 0 1 outer loop\n vertex 0 inf 0") ==
        "m.stl:3:11: a coordinate must be a finite number, not 'inf'; correct it");
  CHECK(stl_error("solid\nfacet normal 0 0 1 loop") == "m.stl:2:20: expected 'outer'; export it as STL again");
  CHECK(stl_error("solid\nendsolid\nfacet") ==
        "m.stl:3:1: expected 'solid' or the end of the file; export it as STL again");
}

TEST_CASE("an OFF file may have comments and colours and counts in its first line") {
  const Mesh mesh = solids::parse_off(
      "COFF 4 4 # a tetrahedron\n0 0 0 255 0 0\n1 0 0 1 1 1\n# here\n0 1 0 0 0 0\n\n0 0 1\n"
      "3 2 1 0 0.5 0.5 0.5\n3 0 1 3\n3 1 2 3\n3 2 0 3",
      "m.off");
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.points[3] == glm::dvec3(0, 0, 1));
  CHECK(mesh.faces == std::vector<std::vector<std::uint32_t>>{{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

TEST_CASE("an error in an OFF file is reported with its line and column") {
  CHECK(off_error("") == "m.off:1:1: an OFF file must start with OFF; export it as OFF again");
  CHECK(off_error("OFF\n-1 0 0") ==
        "m.off:2:1: the number of points must be a whole number from 0 to 1, not '-1'; correct it");
  // The counts are compared with the length of the file before memory is reserved.
  CHECK(off_error("OFF\n3 4000000000 0\n").find("the number of faces must be a whole number from 0 to ") !=
        std::string::npos);
  CHECK(off_error("OFF\n1 1 0\n0 0 0\n2 0 0\n") == "m.off:4:1: a face needs at least 3 corners; complete or remove it");
  CHECK(off_error("OFF\n1 1 0\n0 0 0\n3 0 0 1\n") ==
        "m.off:4:7: the number of a point must be a whole number from 0 to 0, not '1'; correct it");
  CHECK(off_error("OFF\n0 1 0\n3 0 0 1\n") == "m.off:3:1: a face has corners, but there are no points; add them");
  CHECK(off_error("OFF\n1 1 0\n0 0 ") ==
        "m.off:3:5: a coordinate must be a finite number, not the end of the file; correct it");
}

TEST_CASE("OBJ indices count from either end and appearance statements are ignored") {
  const Mesh mesh = solids::parse_obj(
      "# a tetrahedron\nmtllib a.mtl\no one\nv 0 0 0 1\nv 1 0 0\nvn 0 0 1\nvt 0 0\nv 0 1 0\nusemtl red\ns off\n"
      "f 3/1/1 2//1 1\nv 0 0 1 0.5 0.5 0.5\nf -4 2 \\\n4\nf 2/1 3/1 4/1\r\nf 3 1 -1 # the last",
      "m.obj");
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.points[3] == glm::dvec3(0, 0, 1));
  CHECK(mesh.faces == std::vector<std::vector<std::uint32_t>>{{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

namespace {

constexpr auto tetrahedron_points = std::to_array<glm::dvec3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
const std::vector<std::vector<std::uint32_t>> tetrahedron_faces{{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// Appends the bytes of a number, the last one first if `is_big`.
template <class Number>
void append_bytes(std::string& bytes, Number number, bool is_big) {
  std::array<char, sizeof number> raw = std::bit_cast<std::array<char, sizeof number>>(number);
  if (is_big) std::ranges::reverse(raw);
  bytes.append(raw.begin(), raw.end());
}

/// A binary PLY file of a tetrahedron with further properties and a further element before its faces.
std::string binary_ply(bool is_big) {
  std::string bytes = fmt::format(
      "ply\r\nformat binary_{}_endian 1.0\r\nelement vertex 4\r\nproperty double x\r\nproperty float y\r\n"
      "property short quality\r\nproperty float32 z\r\nelement edge 1\r\nproperty int vertex1\r\n"
      "property list uchar uchar more\r\nelement face 4\r\nproperty list char uint16 vertex_index\r\n"
      "property uint8 red\r\nend_header\r\n",
      is_big ? "big" : "little");
  for (const glm::dvec3& point : tetrahedron_points) {
    append_bytes(bytes, point.x, is_big);
    append_bytes(bytes, static_cast<float>(point.y), is_big);
    append_bytes(bytes, std::int16_t{-1}, is_big);
    append_bytes(bytes, static_cast<float>(point.z), is_big);
  }
  append_bytes(bytes, std::int32_t{7}, is_big);
  bytes += {2, 8, 9};
  for (const auto& face : tetrahedron_faces) {
    bytes += '\3';
    for (const std::uint32_t corner : face) append_bytes(bytes, static_cast<std::uint16_t>(corner), is_big);
    bytes += '\xff';
  }
  return bytes;
}

constexpr std::string_view ply_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string ply_error(const std::string& text) {
  return error_of([&] { solids::parse_ply(text, "m.ply"); });
}

}  // namespace

TEST_CASE("PLY is read as text and as binary in either byte order") {
  for (const bool is_big : {false, true}) {
    CAPTURE(is_big);
    const Mesh mesh = solids::parse_ply(binary_ply(is_big), "m.ply");
    CHECK(std::ranges::equal(mesh.points, tetrahedron_points));
    CHECK(mesh.faces == tetrahedron_faces);
  }
  const Mesh mesh = solids::parse_ply(std::string(ply_header) + "0 0 0\n+1e0 0 0\n0 1 0\n3 2 1 0", "m.ply");
  CHECK(mesh.points[1] == glm::dvec3(1, 0, 0));
  CHECK(mesh.faces == std::vector<std::vector<std::uint32_t>>{{2, 1, 0}});
}

TEST_CASE("an error in the header of a PLY file is reported with its line and column") {
  CHECK(ply_error("") == "m.ply: the header of a PLY file must end with 'end_header'; export it again");
  CHECK(ply_error("plx\nend_header\n") == "m.ply:1:1: a PLY file must start with 'ply'; export it as PLY again");
  CHECK(ply_error("ply\nend_header\n") == "m.ply:2:1: the header names no format; export it as PLY again");
  CHECK(ply_error("ply\nformat utf 1.0\nend_header\n") ==
        "m.ply:2:8: the format must be ascii, binary_little_endian or binary_big_endian; export it as PLY again");
  CHECK(ply_error("ply\nproperty float x\nend_header\n") ==
        "m.ply:2:1: a property before the first element; export it as PLY again");
  CHECK(ply_error("ply\nelement vertex -1\nend_header\n").starts_with("m.ply:2:16: the number of elements must be"));
  CHECK(ply_error("ply\nelement vertex 1\nproperty real x\nend_header\n") ==
        "m.ply:3:10: unknown type 'real'; export it as PLY again");
  CHECK(ply_error("ply\nelement face 1\nproperty list float int vertex_indices\nend_header\n") ==
        "m.ply:3:15: the count of a list must be a whole number; export it as PLY again");
  CHECK(ply_error("ply\nformat ascii 1.0\nelement vertex 1\nend_header\n").find("'vertex' has no property") !=
        std::string::npos);
  CHECK(ply_error("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n")
            .find("no element 'vertex' with x, y and z; export") != std::string::npos);
  CHECK(ply_error("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                  "end_header\n")
            .find("it may be a cloud of points: export a mesh of faces") != std::string::npos);
}

TEST_CASE("an error in PLY elements is reported with its line and column or its byte") {
  const std::string points = std::string(ply_header) + "0 0 0\n1 0 0\n0 1 0\n";
  CHECK(ply_error(std::string(ply_header) + "0 zero 0\n") ==
        "m.ply:10:3: a value must be a finite number, not 'zero'; correct it");
  CHECK(ply_error(points + "3 0 1 3") ==
        "m.ply:13:7: a corner must be one of the 3 points before it, counted from 0; correct it");
  CHECK(ply_error(points + "3 0 1 0.5").find("a corner must be one of the 3 points") != std::string::npos);
  CHECK(ply_error(points + "2 0 1") == "m.ply:13:1: a face needs at least 3 corners; complete or remove it");
  CHECK(ply_error(points + "3.5 0 1") ==
        "m.ply:13:1: the count of a list must be a whole number, 0 or more; correct it");
  CHECK(ply_error(points + "3 0 1") ==
        "m.ply:13:6: a value must be a finite number, not the end of the file; correct it");
  std::string bytes = binary_ply(false);
  bytes.pop_back();
  CHECK(ply_error(bytes) ==
        fmt::format("m.ply: at byte {}: the file ends before its last element; export it again", bytes.size()));
  const std::size_t first = bytes.find("end_header\r\n") + 12;
  bytes.replace(first, 8, std::string(8, '\xff'));
  CHECK(ply_error(bytes) == fmt::format("m.ply: at byte {}: a value is not finite; correct it", first + 8));
}

TEST_CASE("an error in an OBJ file is reported with its line and column") {
  const auto error = [](const std::string& text) { return error_of([&] { solids::parse_obj(text, "m.obj"); }); };
  CHECK(error("v 0 0\n") == "m.obj:1:5: a point needs three coordinates; complete it");
  CHECK(error("v 0 zero 0\n") == "m.obj:1:5: a coordinate must be a finite number, not 'zero'; correct it");
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(error(points + "f 1 2\n") == "m.obj:4:5: a face needs at least 3 corners; complete or remove it");
  for (const char* corner : {"0", "4", "-4", "/1", "1.5", "99999999999999999999"}) {
    CAPTURE(corner);
    CHECK(
        error(points + "f 1 2 " + corner + "\n") ==
        "m.obj:4:7: a corner must be one of the 3 points before it, counted from 1, or backwards from -1; correct it");
  }
  CHECK(error(points + "curv 0 1 1 2\n") ==
        "m.obj:4:1: unsupported statement: only points, faces and their appearance are read; export a mesh of "
        "flat faces");
  CHECK(error("").empty());
}

TEST_CASE("an error in an AMF file is reported with its line and column") {
  const auto error = [](const std::string& text) { return error_of([&] { solids::parse_amf(text, "m.amf"); }); };
  CHECK(error("<stl/>") == "m.amf:1:1: no <amf> element; correct it");
  CHECK(error("<amf>\n<object>").starts_with("m.amf:2:"));
  CHECK(error("<amf><object><mesh><vertices>\n <vertex><coordinates><x>1</x><y>q</y><z>0</z></coordinates></vertex>"
              "</vertices></mesh></object></amf>") ==
        "m.amf:2:3: a coordinate must be a finite number, not 'q'; correct it");
  CHECK(error("<amf><object><mesh><volume>\n  <triangle><v1>0</v1></triangle></volume></mesh></object></amf>") ==
        "m.amf:2:4: a corner must be the index of one of 0 points, from 0, not '0'; correct it");
}

TEST_CASE("a damaged 3MF package is rejected") {
  const auto error = [](const std::string& text) { return error_of([&] { solids::parse_3mf(text, "m.3mf"); }); };
  CHECK(error("<model/>") == "m.3mf: not a 3MF package; export it again");
  CHECK(error("PK\x03\x04 and no more") == "m.3mf: the zip archive is damaged; export it again");
  CHECK(error(bytes_of("corner_zipped.amf")) == "m.3mf: the archive has no _rels/.rels; export it again");
  std::string bytes = bytes_of("corner.3mf");
  CHECK(error(bytes).empty());
  // Any byte may be wrong: the package is either read completely or rejected.
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x55);
    refused += error(changed).empty() ? 0 : 1;
  }
  CHECK(refused > 100);
}

TEST_CASE("a mesh file of unsupported extension is rejected and the supported are listed") {
  CHECK(error_of([] { solids::parse_meshes("", "m.vrml"); }) ==
        "m.vrml: meshes are read from .stl, .off, .obj, .ply, .amf and .3mf files; convert it");
}