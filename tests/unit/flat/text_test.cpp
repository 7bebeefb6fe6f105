#include "host/flat/text.h"

#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/flat/support.h"

using namespace csgsim;
using namespace flat;

TEST_CASE("text matches OpenSCAD") {
  check_matches_openscad(flat::text({.text = "Hello, World! 0123"}), "text");
  check_matches_openscad(
      flat::text({.text = "%&@8$", .size = 20, .font = "Liberation Sans:style=Bold", .facets = {.fn = 100}}),
      "text_fine");
  check_matches_openscad(flat::text({.text = "minus", .size = -5}), "text_negative");
}

TEST_CASE("alignment and spacing of text match OpenSCAD") {
  check_matches_openscad(flat::text({.text = "Quickly",
                                     .size = 7,
                                     .font = "Liberation Serif:style=Italic",
                                     .halign = "center",
                                     .valign = "center",
                                     .facets = {.fn = 16}}),
                         "text_centred");
  check_matches_openscad(
      flat::text({.text = "AVATar office", .font = "DejaVu Sans", .halign = "right", .valign = "top", .spacing = 1.3}),
      "text_right_top");
  check_matches_openscad(
      flat::text(
          {.text = "gjpqy_", .size = 4, .font = " DejaVu Sans Mono:style=Bold ", .valign = "bottom", .spacing = 0.7}),
      "text_bottom");
}

TEST_CASE("the direction of text follows its script or the option") {
  check_matches_openscad(flat::text({.text = "שלום עולם", .font = "DejaVu Sans"}), "text_hebrew");
  check_matches_openscad(
      flat::text({.text = "مرحبا", .size = 12, .font = "DejaVu Sans", .halign = "center", .facets = {.fn = 32}}),
      "text_arabic");
  check_matches_openscad(flat::text({.text = "مرحبا", .font = "DejaVu Sans", .direction = "ltr"}), "text_arabic_ltr");
  check_matches_openscad(flat::text({.text = "Down", .halign = "center", .valign = "top", .direction = "ttb"}),
                         "text_down");
  check_matches_openscad(
      flat::text({.text = "Upwards", .halign = "right", .valign = "center", .spacing = 1.2, .direction = "btt"}),
      "text_up");
  check_matches_openscad(
      flat::text({.text = "Ωmega Жук é", .font = "Liberation Mono", .language = "el", .script = "Grek"}),
      "text_scripts");
  check_matches_openscad(flat::text({.text = "aбγ — “x”"}), "text_mixed");
}

TEST_CASE("a missing font is replaced as in OpenSCAD") {
  check_matches_openscad(flat::text({.text = "Arial?", .font = "Arial:style=Bold Italic"}), "text_substitute");
}

TEST_CASE("replacement_font() distinguishes missing fonts in any notation") {
  for (const char* name : {"", "  ", "DejaVu Sans", "dejavusans:style=Bold", "Nowhere,Liberation Serif", ":style=Bold",
                           "sans", "Monospace:bold"}) {
    CAPTURE(name);
    CHECK(!flat::replacement_font(name));
  }
  CHECK(flat::replacement_font("Arial:style=Bold Italic") == "Liberation Sans");
  CHECK(flat::replacement_font("Nowhere") == "DejaVu Sans");
  CHECK(flat::replacement_font("Nowhere,Elsewhere:style=Bold") == "DejaVu Sans");
}

TEST_CASE("tiny letters are quantized as in OpenSCAD") {
  check_matches_openscad(flat::text({.text = "tiny", .size = 0.01, .facets = {.fn = 0, .fa = 1, .fs = 0.001}}),
                         "text_tiny");
}

TEST_CASE("text without glyph outlines is empty") {
  CHECK(flat::text({.text = ""}).empty());
  CHECK(flat::text({.text = "  "}).empty());
  CHECK(flat::text({.text = "x", .size = 0}).empty());
}

TEST_CASE("invalid UTF-8 bytes are visible in text") {
  CHECK(flat::area_of(flat::text({.text = "a\xff\xc3z"})) > flat::area_of(flat::text({.text = "az"})));
}

TEST_CASE("a bitmap font is rejected with its name if it has one") {
  const std::string folder = CSGSIM_SOURCE_DIR "/tests/support/fonts/";
  CHECK_THROWS_WITH_AS(flat::text({.text = "x", .font = ":file=" + folder + "small.bdf"}),
                       "font Small cannot be scaled; use another font", InputError);
  CHECK_THROWS_WITH_AS(flat::text({.text = "x", .font = ":file=" + folder + "nameless.bdf"}),
                       "font without a name cannot be scaled; use another font", InputError);
}

TEST_CASE("text with an unknown alignment or beyond size limits is rejected") {
  CHECK_THROWS_WITH_AS(flat::text({.text = "x", .halign = "middle"}),
                       "halign of text() is \"middle\"; use \"left\", \"center\" or \"right\"", InputError);
  CHECK_THROWS_WITH_AS(flat::text({.text = "x", .valign = "\n"}),
                       "valign of text() is \"\\n\"; use \"top\", \"center\", \"baseline\" or \"bottom\"", InputError);
  CHECK_THROWS_AS(flat::text({.text = "x", .size = INFINITY}), InputError);
  CHECK_THROWS_AS(flat::text({.text = "xx", .size = 1e12, .spacing = 1e300}), InputError);
  CHECK_THROWS_AS(flat::text({.text = std::string(10'001, 'x')}), InputError);
  CHECK_THROWS_AS(flat::text({.text = std::string(500, '&'), .facets = {.fn = 90'000}}), InputError);
}
