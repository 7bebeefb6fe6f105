#include "host/flat/dxf.h"

#include "tests/support/test.h"
#include "tests/unit/flat/support.h"

using namespace csgsim;
using flat::check_matches_openscad;

namespace {

flat::Area drawing(const std::string& name, const flat::DxfOptions& options = {}) {
  return flat::read_dxf(flat::drawing(name + ".dxf"), options);
}

std::string entities(const std::string& groups) { return "0\nSECTION\n2\nENTITIES\n" + groups + "0\nENDSEC\n0\nEOF\n"; }

std::string message(const std::string& text, const flat::DxfOptions& options = {}) {
  return testing::error_of([&] { flat::read_dxf(text, options); });
}

}  // namespace

TEST_CASE("DXF entities match OpenSCAD") {
  check_matches_openscad(drawing("entities"), "dxf_entities");
  check_matches_openscad(drawing("entities", {.facets = {.fn = 24}}), "dxf_fine");
  check_matches_openscad(drawing("exported"), "dxf_exported");
}

TEST_CASE("DXF lines are chained as in OpenSCAD where several meet") {
  check_matches_openscad(drawing("meeting"), "dxf_meeting");
}

TEST_CASE("DXF blocks are inserted as in OpenSCAD") {
  check_matches_openscad(drawing("blocks"), "dxf_blocks");
  check_matches_openscad(drawing("blocks", {.layer = "b", .scale = 0.5}), "dxf_layer_b");
}

TEST_CASE("DXF drawings are moved and scaled as in OpenSCAD") {
  check_matches_openscad(drawing("blocks", {.origin = {5, -3}, .scale = 2.5}), "dxf_moved");
  check_matches_openscad(drawing("entities", {.origin = {3, 4}, .scale = 1.5, .facets = {.fn = 30}}),
                         "dxf_scaled_ellipses");
}

TEST_CASE("a selected DXF layer is drawn alone") {
  check_matches_openscad(drawing("layers"), "dxf_layers");
  check_matches_openscad(drawing("layers", {.layer = "plate"}), "dxf_plate");
  check_matches_openscad(drawing("layers", {.layer = "holes"}), "dxf_holes");
  CHECK(drawing("layers", {.layer = "none"}).empty());
}

TEST_CASE("invalid DXF is rejected with its line number") {
  CHECK(message("") == "line 1: not a DXF file: no section found; save it as ASCII DXF");
  CHECK(message("AutoCAD Binary DXF\r\n\x1a") ==
        "line 1: \"AutoCAD Binary DXF\" is not a group code of ASCII DXF; every other line must be one");
  CHECK(message("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n") ==
        "the DXF file is truncated: its last group is not 0, EOF; save it again");
  CHECK(message(entities("0\nLINE\n10\nx\n")) == "line 8: \"x\" is not a number, but group 10 must be one");
  CHECK(message(entities("0\nARC\n40\nnan\n")) == "line 8: \"nan\" is not a number, but group 40 must be one");
  CHECK(message(entities("0\nLWPOLYLINE\n70\n1.5\n")) ==
        "line 8: \"1.5\" is not a whole number, but group 70 must be one");
  CHECK(message(entities("0\nLINE\n10\n0\n20\n0\n")) ==
        "line 6: a LINE lacks a point (groups 10, 20 or 11, 21); add it");
  CHECK(message(entities("0\nCIRCLE\n40\n1\n")) == "line 6: a CIRCLE lacks a point (groups 10, 20 or 11, 21); add it");
  CHECK(message(entities("0\nLINE\n10\n1e13\n20\n0\n11\n1\n21\n1\n")) ==
        "line 6: a coordinate of the drawing exceeds 1e12; scale the drawing down");
  CHECK(message(entities("0\nARC\n10\n0\n20\n0\n40\n1\n50\n0\n51\n1e9\n")) ==
        "line 6: an arc exceeds two turns, or starts beyond a million degrees; correct its angles");
  CHECK_THROWS_AS(flat::read_dxf(entities(""), {.scale = 0}), InputError);
}

TEST_CASE("large angles of DXF arcs take no extra time") {
  const std::string arc = "0\nARC\n10\n0\n20\n0\n40\n1\n51\n90\n50\n";
  CHECK(flat::area_of(flat::read_dxf(entities(arc + "360000\n"), {})) ==
        doctest::Approx(flat::area_of(flat::read_dxf(entities(arc + "0\n"), {}))));
  CHECK(message(entities(arc + "1e300\n")) ==
        "line 6: an arc exceeds two turns, or starts beyond a million degrees; correct its angles");
}

TEST_CASE("exponentially nested DXF blocks are rejected") {
  std::string blocks = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n";
  for (int i = 0; i < 30; ++i) blocks += "0\nINSERT\n2\nb\n10\n0\n20\n0\n";
  CHECK(message(blocks + "0\nENDBLK\n0\nENDSEC\n0\nEOF\n")
            .ends_with("the blocks have more than 1000000 segments; simplify them"));
}

TEST_CASE("a mutated DXF file is read or rejected with a printable message") {
  flat::check_mutations(".dxf", [](const std::string& bytes) { flat::read_dxf(bytes, {}); });
}