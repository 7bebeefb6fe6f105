#include "sim/plots/gnuplot.h"

#include <png.h>

#include "sim/plots/glyphs.h"
#include "sim/plots/layout.h"
#include "sim/plots/svg.h"
#include "tests/support/test.h"
#include "tests/unit/plots/sample_plots.h"

using namespace csgsim;
namespace samples = csgsim::testing::plots_;

namespace {

struct Picture {
  unsigned width = 0;
  unsigned height = 0;
  std::vector<unsigned char> grey;
};

Picture decoded(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
  image.format = PNG_FORMAT_GRAY;
  Picture picture{image.width, image.height, std::vector<unsigned char>(PNG_IMAGE_SIZE(image))};
  REQUIRE(png_image_finish_read(&image, nullptr, picture.grey.data(), 0, nullptr) != 0);
  return picture;
}

/// Returns the bounding box of everything non-white within these columns and rows.
plots::Box ink_box(const Picture& picture, const plots::Box& within) {
  plots::Box ink{1e9, 1e9, 0, 0};
  for (auto y = static_cast<unsigned>(within.top); y < static_cast<unsigned>(within.bottom); ++y) {
    for (auto x = static_cast<unsigned>(within.left); x < static_cast<unsigned>(within.right); ++x) {
      if (picture.grey[y * picture.width + x] > 200) continue;
      ink = {std::min<double>(ink.left, x), std::min<double>(ink.top, y), std::max<double>(ink.right, x + 1.0),
             std::max<double>(ink.bottom, y + 1.0)};
    }
  }
  return ink;
}

plots::Box ink_box(const Picture& picture) {
  return ink_box(picture, {0, 0, static_cast<double>(picture.width), static_cast<double>(picture.height)});
}

plots::Drawing of_texts(std::vector<plots::Text> texts) {
  plots::Drawing drawing{600, 600, {}, {}, {}, {}};
  drawing.texts = std::move(texts);
  drawing.lines.push_back({{{0, 0}, {0, 0}}, "#ffffff"});  // gnuplot requires something to plot
  return drawing;
}

plots::Drawing of_text(const plots::Text& text) { return of_texts({text}); }

const std::filesystem::path png = "plot.png";

/// A folder with a fake `gnuplot`, first on the PATH.
class FakeGnuplot {
 public:
  explicit FakeGnuplot(const std::string& script) : path_(std::getenv("PATH")) {
    std::string name = (std::filesystem::temp_directory_path() / "csgsim-plots-XXXXXX").native();
    folder_ = ::mkdtemp(name.data());
    std::ofstream(folder_ / "gnuplot") << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(folder_ / "gnuplot", std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder_.native() + ":" + path_).c_str(), 1);
  }
  ~FakeGnuplot() {
    ::setenv("PATH", path_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }
  FakeGnuplot(const FakeGnuplot&) = delete;
  FakeGnuplot& operator=(const FakeGnuplot&) = delete;

 private:
  std::string path_;
  std::filesystem::path folder_;
};

std::string error_with(const std::string& gnuplot) {
  const FakeGnuplot fake(gnuplot);
  return testing::error_of([&] { plots::draw_png(png, of_text({"text", {100, 100}})); });
}

}  // namespace

TEST_CASE("gnuplot prints nothing for any plot and draws the same bytes twice") {
  for (const plots::Plot& plot : samples::sample_plots()) {
    CAPTURE(plot.name);
    const plots::Drawing drawing = plots::lay_out(plot);
    const plots::PngResult drawn = plots::draw_png(png, drawing);
    CHECK(drawn.messages == "");
    CHECK(drawn.picture == plots::draw_png(png, drawing).picture);
  }
}

namespace {

/// Texts of wide and narrow letters and beyond ASCII, at each anchor, and each ASCII letter alone.
std::vector<plots::Text> all_letters() {
  std::vector<plots::Text> all;
  for (const char* text :
       {"MMMMMMMMMMMM", "iiiiiiiiiiii", "0123456789,.", "m = 5, m = 6", "pixel-planes-4", "10\u207b\u2079\u00b7\u2026",
        "\u00c5\u00c9gjpqy|{}[]()@#", "wrong pixels", "WWWW%%@@", "\u0416\u0429\u03a9", "\u5b57"}) {
    for (const plots::Anchor anchor : {plots::Anchor::left, plots::Anchor::centre, plots::Anchor::right}) {
      all.push_back({text, {}, anchor});
    }
  }
  for (char c = 33; c < 127; ++c) all.push_back({std::string(20, c), {}, plots::Anchor::left});
  return all;
}

}  // namespace

TEST_CASE("a text's ink is within the box reserved for it") {
  const std::vector<plots::Text> letters = all_letters();
  // Texts side by side in bands: ink outside its band shows in the next.
  constexpr double band = 40;
  constexpr std::size_t bands = 15;
  for (const bool upright : {false, true}) {
    for (std::size_t first = 0; first < letters.size(); first += bands) {
      std::vector<plots::Text> texts;
      for (std::size_t i = first; i < std::min(first + bands, letters.size()); ++i) {
        const double middle = band * (static_cast<double>(i - first) + 0.5);
        texts.push_back(letters[i]);
        texts.back().at = upright ? plots::Pixel{middle, 300} : plots::Pixel{300, middle};
        texts.back().is_upright = upright;
      }
      const Picture picture = decoded(plots::draw_png(png, of_texts(texts)).picture);
      for (const plots::Text& text : texts) {
        CAPTURE(text.text);
        const plots::Box ink =
            ink_box(picture, upright ? plots::Box{text.at.x - band / 2, 0, text.at.x + band / 2, 600}
                                     : plots::Box{0, text.at.y - band / 2, 600, text.at.y + band / 2});
        plots::Box box = plots::bounding_box(text);
        // An edge may fall within a pixel.
        box = {box.left - 1, box.top - 1, box.right + 1, box.bottom + 1};
        CHECK(plots::is_within(ink, box));
        if (text.text != "\u5b57") CHECK(ink.right - ink.left + ink.bottom - ink.top > 10);
      }
    }
  }
}

TEST_CASE("gnuplot draws a mark and a line at the drawing's coordinates") {
  plots::Drawing drawing{400, 300, {}, {}, {}, {}};
  drawing.marks.push_back({{100, 200}, plots::palette::Mark::square, "#000000", 9});
  plots::Box ink = ink_box(decoded(plots::draw_png(png, drawing).picture));
  CHECK(plots::is_within(ink, plots::square_around({100, 200}, 6.5)));
  CHECK(plots::is_within(plots::square_around({100, 200}, 3), ink));
  drawing.marks.clear();
  drawing.lines.push_back({{{50, 60}, {350, 60}}, "#000000"});
  ink = ink_box(decoded(plots::draw_png(png, drawing).picture));
  CHECK(plots::is_within(ink, {48, 58, 352, 62}));
  CHECK(ink.right - ink.left > 298);
}

TEST_CASE("gnuplot's picture has the size of its drawing") {
  plots::Drawing drawing{321, 234, {}, {}, {}, {}};
  drawing.marks.push_back({{100, 200}, plots::palette::Mark::disc, "#000000"});
  const Picture picture = decoded(plots::draw_png(png, drawing).picture);
  CHECK(picture.width == 321);
  CHECK(picture.height == 234);
}

TEST_CASE("a text for gnuplot is one quoted string without characters special to gnuplot") {
  const std::string text = plots::gnuplot_text("a\"'`b\\\n$(x)%d\xff");
  CHECK(text.front() == '"');
  CHECK(text.find_first_of("\"'`$\n%") == 0);
  CHECK(text.find_first_of("\"'`$\n%", 1) == text.size() - 1);
}

TEST_CASE("an error of gnuplot is reported in one line without the script") {
  const std::string error = error_with(
      "echo >&2; echo 'set terminal pngcairo size 600,600' >&2; echo '   ^' >&2;"
      "echo 'line 2: unknown or ambiguous terminal name; type just set terminal for a list' >&2; echo >&2; exit 1");
  CHECK(error.find("plot.png: gnuplot drew no picture; gnuplot reports: unknown or ambiguous terminal name") == 0);
  CHECK(error.find("set terminal pngcairo") == std::string::npos);
  CHECK(error.find('\n') == std::string::npos);
  CHECK(error.find("--no-plots") != std::string::npos);
}

TEST_CASE("a gnuplot that fails silently or stops early or is killed is reported") {
  CHECK(error_with("exit 3").find("exited with status 3") != std::string::npos);
  CHECK(error_with("printf '\\211PNG half'").find("the picture is incomplete") != std::string::npos);
  CHECK(error_with("kill -9 $$").find("it was killed by a signal: Killed") != std::string::npos);
}

TEST_CASE("a character without a font is a question mark in a PNG and itself in an SVG") {
  constexpr const char* unassigned = "\u0378";
  CHECK(plots::replace_missing_glyphs(std::string("a") + unassigned + "b\u0416\u2026\u00b7\u207b") ==
        "a?b\u0416\u2026\u00b7\u207b");
  CHECK(plots::replace_missing_glyphs("10 < 20 \\ \n") == "10 < 20 \\ \\n");
  const plots::Drawing drawing = of_text({std::string("x") + unassigned, {300, 300}});
  CHECK(plots::draw_png(png, drawing).picture == plots::draw_png(png, of_text({"x?", {300, 300}})).picture);
  CHECK(plots::svg_file(drawing).find(std::string("x") + unassigned) != std::string::npos);
}