#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using csgsim::model::Cube;
using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

glm::dvec3 size_of(std::string_view number) {
  const std::string text = "cube([" + std::string(number) + ", 1, 1]);";
  return std::get<Cube>(read(text).primitives.at(0).shape).size;
}

}  // namespace

TEST_CASE("white space and comments may be anywhere in a .csg file") {
  CHECK(outline(read("/**/ difference /* a */ ( ) // b } {\r\n{\tcube/**/(size/*=*/= /* ; */[ 1 , 2,3 /*]*/ ],center=\n"
                     "true // )\n);sphere(r=1);}//")) == "difference(cube, sphere)");
  CHECK(outline(read("/***/cube(1);/* * / **/")) == "cube");
}

TEST_CASE("a byte-order mark is skipped and not counted as a column") {
  CHECK(outline(read("\xEF\xBB\xBF"
                     "cube(1);")) == "cube");
  CHECK(error_of("\xEF\xBB\xBF"
                 "cub(1);") == "m.csg:1:1: unknown node cub(); did you mean cube()?");
}

TEST_CASE("a .csg file may have empty statements and trailing commas") {
  CHECK(outline(read(";;cube(size = [1, 1, 1,], center = false,);;")) == "cube");
}

TEST_CASE("numbers of every style are read to the nearest double") {
  CHECK(size_of("7").x == 7.0);
  CHECK(size_of("+7.").x == 7.0);
  CHECK(size_of(".5").x == 0.5);
  CHECK(size_of("1e3").x == 1000.0);
  CHECK(size_of("1.5E-3").x == 0.0015);
  CHECK(size_of("2e+06").x == 2e6);
  CHECK(size_of("0.10000000000000001").x == 0.1);
  CHECK(size_of("1.7976931348623157e308").x == 1.7976931348623157e308);
  CHECK(size_of("4.9406564584124654e-324").x == 4.9406564584124654e-324);
  CHECK(size_of("0000000000000000000000000000000000001").x == 1.0);
  CHECK(size_of("1" + std::string(400, '0') + "e-400").x == 1.0);
  CHECK(size_of("0." + std::string(400, '0') + "1e401").x == 1.0);
}

TEST_CASE("a number too small for a double is zero and empties the solid") {
  CHECK(outline(read("cube([1e-400, 1, 1]);")) == "nothing");
  CHECK(outline(read("cube([1e-99999999999999999999, 1, 1]);")) == "nothing");
  CHECK(outline(read("cube([0e99999999999999999999, 1, 1]);")) == "nothing");
}

TEST_CASE("a number too large for a double is rejected") {
  CHECK(error_of("cube([1,\n 1e999, 1]);") ==
        "m.csg:2:2: number out of range: 1e999 exceeds the range of doubles; correct it");
  CHECK(error_of("cube(-1e309);") == "m.csg:1:6: number out of range: -1e309 exceeds the range of doubles; correct it");
  CHECK(error_of("cube(1e99999999999999999999);") ==
        "m.csg:1:6: number out of range: 1e99999999999999999999 exceeds the range of doubles; correct it");
  CHECK(error_of("cube(" + std::string(400, '9') + ");") ==
        "m.csg:1:6: number out of range: " + std::string(40, '9') + "... exceeds the range of doubles; correct it");
}

TEST_CASE("columns in error messages count characters and not bytes") {
  CHECK(error_of("/* \xC3\xA9\xE2\x82\xAC */ cub(1);") == "m.csg:1:10: unknown node cub(); did you mean cube()?");
}

TEST_CASE("a line ends with a line feed with or without a carriage return") {
  CHECK(error_of("cube(1);\r\n\r\n\tcub(1);") == "m.csg:3:2: unknown node cub(); did you mean cube()?");
}

TEST_CASE("syntax errors of a .csg file state the expected token and its place") {
  CHECK(error_of("cube(1)") == "m.csg:1:8: expected `;` or `{` after cube(...), found the end of the file");
  CHECK(error_of("cube(1)\n}") == "m.csg:2:1: expected `;` or `{` after cube(...), found `}`");
  CHECK(error_of("group() cube(1);") == "m.csg:1:9: expected `;` or `{` after group(...), found `c`");
  CHECK(error_of("cube;") == "m.csg:1:5: expected `(` after cube, found `;`");
  CHECK(error_of("group() {\n  cube(1);\n") ==
        "m.csg:3:1: expected `}` to close group() of line 1, column 1, found the end of the file");
  CHECK(error_of("cube(1); }") == "m.csg:1:10: unmatched `}`; remove it");
  CHECK(error_of("cube(1;") == "m.csg:1:7: expected `,` or `)` in cube(...), found `;`");
  CHECK(error_of("cube(,)") == "m.csg:1:6: expected `name = value`, a value or `)` in cube(...), found `,`");
  CHECK(error_of("cube((1))") == "m.csg:1:6: expected `name = value`, a value or `)` in cube(...), found `(`");
  CHECK(error_of("cube(size = )") ==
        "m.csg:1:13: expected a number, true, false, undef, a \"string\" or a [vector] after `=`, found `)`");
  CHECK(error_of("cube([1, , 1]);") == "m.csg:1:10: expected a value or `]` in a vector of cube(...), found `,`");
  CHECK(error_of("cube([1 1]);") == "m.csg:1:9: expected `,` or `]` in a vector of cube(...), found `1`");
  CHECK(error_of("cube([1:2]);") == "m.csg:1:8: expected `,` or `]` in a vector of cube(...), found `:`");
  CHECK(error_of("cube(1/0);") == "m.csg:1:7: expected `,` or `)` in cube(...), found `/`");
  CHECK(error_of("cube(1e);") == "m.csg:1:6: expected `name = value`, a value or `)` in cube(...), found `1`");
  CHECK(error_of("cube(infinite);") == "m.csg:1:6: expected `name = value`, a value or `)` in cube(...), found `i`");
  CHECK(error_of("# ;") == "m.csg:1:3: expected a node such as cube(...) after its modifier, found `;`");
  CHECK(error_of("{cube(1);}") == "m.csg:1:1: expected a node such as cube(...), or `}`, found `{`");
  CHECK(error_of("cube(1); /* x") == "m.csg:1:10: this comment never ends; close it with */");
  CHECK(error_of("color(\"red\\\"") == "m.csg:1:7: this string never ends; close it with \" before `)` or `, name =`");
}

TEST_CASE("an error names an unprintable byte by its number") {
  CHECK(error_of(std::string_view("\0\0", 2)) ==
        "m.csg:1:1: expected a node such as cube(...), or `}`, found byte 0x00");
  CHECK(error_of("cube(1);\x7f") == "m.csg:1:9: expected a node such as cube(...), or `}`, found byte 0x7f");
  CHECK(error_of("\xff\xfe") == "m.csg:1:1: expected a node such as cube(...), or `}`, found byte 0xff");
}

TEST_CASE("an error for OpenSCAD source refers the user to OpenSCAD") {
  const char* advice = ": this is OpenSCAD source, not .csg; export it first: openscad -o model.csg model.scad";
  CHECK(error_of("a = 3; cube(a);") == std::string("m.csg:1:1") + advice);
  CHECK(error_of("\nmodule m() { cube(1); }") == std::string("m.csg:2:1") + advice);
  CHECK(error_of("use <a.scad>") == std::string("m.csg:1:1") + advice);
  CHECK(error_of("translate([1, 2, 3]) { cube(1); }") ==
        "m.csg:1:1: translate() is OpenSCAD source, not .csg; export it first: openscad -o model.csg model.scad");
}

TEST_CASE("vectors nested beyond a limit are rejected") {
  CHECK(error_of("cube([[[[[[[[1]]]]]]]]);") == "m.csg:1:6: size of cube() must be a vector of 3 numbers");
  CHECK(error_of("cube([[[[[[[[[1]]]]]]]]]);") ==
        "m.csg:1:14: vectors are nested more than 8 deep; no node needs this");
}

TEST_CASE("an escaped quote or backslash does not end a string") {
  CHECK(error_of(R"(color("re\"d\\", 1) { cube(1); } group("x");)") ==
        "m.csg:1:7: color() does not accept names; write [red, green, blue], each from 0 to 1");
  CHECK(outline(read(R"(%text(text = "a\"b)};", size = 10); cube(1);)")) == "cube");
}

namespace {

/// Returns the string that import() receives: the file does not exist, and the warning names it.
std::string file_name(std::string_view written) {
  const auto [tree, warnings] =
      read_with_warnings("import(file = \"no-such/" + std::string(written) + "\", layer = \"\", $fn = 0);");
  const std::string warning = warnings.empty() ? "" : warnings.front();
  const std::string_view begin = "m.csg:1:1: warning: no-such/";
  const std::size_t end = warning.find(" does not exist");
  if (!warning.starts_with(begin) || end == std::string::npos) return "not read: " + warning;
  return warning.substr(begin.size(), end - begin.size());
}

}  // namespace

TEST_CASE("strings keep quotes and backslashes as OpenSCAD writes them") {
  for (const char* name :
       {"a.stl", "say \"hi\", b.stl", "end\".stl", "f(\"x\").stl", "a\\b.stl", "a\\\\b.stl", "a\", \"b.stl"}) {
    CAPTURE(name);
    std::string shown = name;
    for (std::size_t at = shown.find('\\'); at != std::string::npos; at = shown.find('\\', at + 2))
      shown.insert(at, 1, '\\');
    const std::string got = file_name(name);
    CHECK((got == name || got == shown));
  }
  CHECK(file_name("a\\\"b.stl") == "a\"b.stl");
  CHECK(outline(read("group() { %text(text = \"\"\", size = 10); cube(1); }")) == "cube");
  CHECK(outline(read("%text(text = \"a\\\", size = 10) ; cube(1);")) == "cube");
}

TEST_CASE("an ambiguous string that looks like arguments is rejected") {
  CHECK(error_of("text(text = \"x\", size = 3, font = \"y\", size = 10, font = \"\");") ==
        "m.csg:1:40: size is given twice in text(...); remove one");
}