#include "host/solids/surface.h"

#include "host/solids/check.h"
#include "host/solids/limits.h"
#include "host/solids/pieces.h"
#include "hw/base/input_file.h"
#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using solids::Mesh;
using testing::error_of;

namespace {

std::string folder() { return std::string(CSGSIM_SOURCE_DIR) + "/tests/models/solids/"; }

double volume_of(const Mesh& mesh) { return testing::volume_of(mesh.points, mesh.faces); }

Mesh numbers(const std::string& text) { return solids::parse_surface(text, "m.dat", false); }

std::string numbers_error(const std::string& text) {
  return error_of([&] { numbers(text); });
}

std::string png_error(const std::string& bytes) {
  return error_of([&] { solids::parse_surface_png(bytes, "m.png", false, false); });
}

}  // namespace

TEST_CASE("surface() of numbers and of all pixel formats equals OpenSCAD's") {
  for (const char* name : {"numbers.dat", "grey.png", "inverted.png", "white.png", "deep.png", "bits.png", "colour.png",
                           "palette.png", "clear.png", "grey_clear.png"}) {
    CAPTURE(name);
    const std::string file = "heights_" + std::string(name);
    const Mesh expected = testing::load_off(file.substr(0, file.rfind('.')));
    const std::string path = folder() + file;
    const std::string bytes = read_file(path, solids::surface_file);
    const auto made = solids::check(solids::parse_surface_file(bytes, path, true, file == "heights_inverted.png"),
                                    solids::printed_tolerance);
    CHECK(!made.defect);
    CHECK(volume_of(made.mesh) == doctest::Approx(volume_of(expected)).epsilon(1e-5));
    // OpenSCAD omits points of the floor that are on its edges.
    CHECK(made.mesh.points.size() >= expected.points.size());
    for (const glm::dvec3& point : expected.points) {
      CHECK(std::any_of(made.mesh.points.begin(), made.mesh.points.end(),
                        [&](const glm::dvec3& other) { return glm::length(point - other) < 1e-3; }));
    }
    const auto pieces = solids::convex_pieces(made.mesh);
    CHECK(testing::check_pieces(made.mesh, pieces, 0) > 10);
  }
}

TEST_CASE("surface() of one row or one column or no heights is empty") {
  CHECK(numbers("").faces.empty());
  CHECK(numbers("1 2 3").faces.empty());
  CHECK(numbers("1\n2\n3\n").faces.empty());
  CHECK(numbers("1 2\n3 4\n").faces.size() == 4 + 4 + 1);
}

TEST_CASE("surface() rejects text that is not a number with its place") {
  CHECK(numbers_error("1 2\n3 4x 5") == "m.dat:2:3: a height must be a finite number, not '4x'; correct it");
  CHECK(numbers_error("1,2\n") == "m.dat:1:1: a height must be a finite number, not '1,2'; correct it");
  CHECK(numbers_error("1 2\n3 inf") == "m.dat:2:3: a height must be a finite number, not 'inf'; correct it");
}

TEST_CASE("surface() rejects more than a million heights") {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "1 ";
  for (int i = 0; i < 2000; ++i) text += "\n1";
  CHECK(numbers_error(text) == "m.dat: more than 1000000 heights; make the grid coarser");
}

TEST_CASE("surface() rejects damaged pictures") {
  const std::string bytes = read_file(folder() + "heights_colour.png", {"a file", 1U << 20U, ""});
  CHECK(png_error(bytes).empty());
  CHECK(png_error("").starts_with("m.png: not a PNG file, or damaged ("));
  CHECK(png_error(bytes.substr(0, 60)) == "m.png: not a PNG file, or damaged (the file ends too early); save it again");
  std::string changed = bytes;
  changed[50] = static_cast<char>(changed[50] ^ 0x10);
  CHECK(!png_error(changed).empty());
}

TEST_CASE("surface() rejects a picture of more than a million pixels") {
  // 65536 by 65536, with a valid checksum.
  const std::string header("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\x01\0\0\0\x01\0\0\x08\0\0\0\0", 8 + 8 + 13);
  std::uint32_t crc = 0xffffffffU;
  for (std::size_t i = 12; i < header.size(); ++i) {
    crc ^= static_cast<unsigned char>(header[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  std::string bytes = header;
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(~crc >> shift & 0xffU));
  bytes += std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);
  CHECK(png_error(bytes) == "m.png: the picture has more than 1000000 pixels; scale it down");
}