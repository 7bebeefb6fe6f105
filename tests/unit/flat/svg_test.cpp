#include "host/flat/svg.h"

#include "tests/support/test.h"
#include "tests/unit/flat/support.h"

using namespace csgsim;
using flat::check_matches_openscad;

namespace {

flat::Area drawing(const std::string& name, const flat::SvgOptions& options = {}) {
  return flat::read_svg(flat::drawing(name + ".svg"), options);
}

flat::Area path(const std::string& data) { return flat::read_svg("<svg><path d=\"" + data + "\"/></svg>", {}); }

std::string message(const std::string& text) {
  return testing::error_of([&] { flat::read_svg(text, {}); });
}

}  // namespace

TEST_CASE("SVG elements match OpenSCAD") {
  for (const char* name : {"shapes", "paths", "transforms"}) {
    check_matches_openscad(drawing(name), std::string("svg_") + name);
  }
  flat::check_area_matches_openscad(drawing("strokes"), "svg_strokes");
}

TEST_CASE("SVG page sizes and alignments match OpenSCAD") {
  for (const char* name : {"pixels", "stretched", "sliced", "met", "unsized", "percent"}) {
    check_matches_openscad(drawing(name), std::string("svg_") + name);
  }
  check_matches_openscad(drawing("stretched", {.center = true}), "svg_centred");
  check_matches_openscad(drawing("met", {.dpi = 96}), "svg_dpi");
}

TEST_CASE("the parts of an SVG file that OpenSCAD ignores are ignored") {
  check_matches_openscad(drawing("others"), "svg_others");
}

TEST_CASE("numbers of SVG paths need no spaces where SVG allows it") {
  const flat::Area apart = path("M 10 10 L 20.5 0.5 L 30 -5 z");
  CHECK(flat::area_of(apart) > 0);
  CHECK(path("M10,10L20.5.5 30-5z").outlines == apart.outlines);
  CHECK(path("m10 10l10.5-9.5,9.5-5.5z").outlines == apart.outlines);
  CHECK(path("M1e1+10L2.05E+1 .5L30-500e-2z").outlines == apart.outlines);
  CHECK(path("M0 0a5 5 0 01.5 5z").outlines == path("M0 0 a5,5 0 0,1 0.5,5 z").outlines);
}

TEST_CASE("an SVG arc without radius is a line and an arc to its own start is empty") {
  CHECK(path("M0 0A0 5 0 0 1 10 0L10 10z").outlines == path("M0 0L10 0L10 10z").outlines);
  CHECK(path("M0 0L10 0A5 5 0 1 1 10 0L10 10z").outlines == path("M0 0L10 0L10 10z").outlines);
}

TEST_CASE("invalid SVG is rejected with its line number") {
  CHECK(message("") == "line 1: invalid XML: No document element found");
  CHECK(message("<html/>") == "line 1: not an SVG file: the outermost element is not svg; save it as SVG");
  CHECK(message("<svg>\n<g>\n</svg>") == "line 3: invalid XML: Start-end tags mismatch");
  CHECK(message("<svg>\n<path d='M0 0 L1,x'/></svg>") == "line 2: invalid path data at \"x\"; correct it");
  CHECK(message("<svg><path d='0 0'/></svg>") == "line 1: invalid path data at \"0 0\"; correct it");
  CHECK(message("<svg><path d='M0 0a1 1 0 2 0 1 1'/></svg>") == "line 1: invalid path data at \"2 0 1 1\"; correct it");
  CHECK(message("<svg><g><path transform='turn(3)'/></g></svg>") ==
        "line 1: transform=\"turn(3)\" is not a list of matrix(), translate(), scale(), rotate(), skewX(), skewY(); "
        "correct it");
  CHECK(message("<svg viewBox='0 0 0 1'/>") ==
        "line 1: the viewBox of the svg has no size; set its width and height above 0");
  CHECK(message("<svg><polygon points='1 2 x'/></svg>") ==
        "line 1: points of a polygon are not pairs of numbers; correct them");
  CHECK(message("<svg><rect width='1e300' height='1e300'/></svg>") ==
        "a coordinate of a 2-D shape is not a number or exceeds 1e12; scale the shape down");
  CHECK(message("<svg><line x2='1' stroke-width='1e14' stroke-linecap='round'/></svg>") ==
        "line 1: a stroke of the drawing is too wide; make it narrower");
  CHECK(message("<svg><line x2='1' stroke-width='1e10' stroke-linecap='round'/></svg>") ==
        "line 1: a line of the drawing has too many corners or too wide a stroke; simplify it, or make the stroke "
        "narrower");
  CHECK_THROWS_AS(flat::read_svg("<svg/>", {.dpi = 0}), InputError);
}

TEST_CASE("deep nesting in SVG is rejected and entities are not expanded") {
  std::string deep = "<svg>";
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  CHECK(message(deep).starts_with("line 1: invalid XML"));
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  CHECK(message(deep + "</svg>") == "line 1: elements are nested more than 1000 deep; ungroup some");
  const std::string bomb = "<!DOCTYPE svg [<!ENTITY a 'M0 0'><!ENTITY b '&a;&a;&a;&a;'>]><svg><path d='&b;'/></svg>";
  CHECK(message(bomb) == "line 1: invalid path data at \"&b;\"; correct it");
}

TEST_CASE("a mutated SVG file is read or rejected with a printable message") {
  flat::check_mutations(".svg", [](const std::string& bytes) { flat::read_svg(bytes, {}); });
}