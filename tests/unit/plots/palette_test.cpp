#include "sim/plots/palette.h"

#include "tests/support/test.h"

using namespace csgsim;
namespace palette = csgsim::plots::palette;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr Matrix all_cones{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Linear RGB as seen without one type of cone: Machado, Oliveira and Fernandes, "A physiologically-based model for
/// simulation of color vision deficiency" (2009), severity 1.
constexpr Matrix no_green_cone{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix no_red_cone{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};

Triple times(const Matrix& matrix, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
  return result;
}

Triple linear(std::string_view colour) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
    result[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  return result;
}

/// CIE L*a*b* of linear sRGB, D65.
Triple lab(const Triple& rgb) {
  constexpr Matrix to_xyz{
      {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
  constexpr Triple white{0.95047, 1, 1.08883};
  Triple clipped = rgb;
  for (double& value : clipped) value = std::min(1.0, std::max(0.0, value));
  Triple f = times(to_xyz, clipped);
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = f[i] / white[i];
    f[i] = part > 216.0 / 24389 ? std::cbrt(part) : (24389.0 / 27 * part + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double difference(const Triple& a, const Triple& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Smallest difference of two colours for this kind of vision: CIE76, where 2.3 is just noticeable.
double least_difference(const std::vector<std::string_view>& colours, const Matrix& sight) {
  double least = 1e9;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, difference(lab(times(sight, linear(colours[i]))), lab(times(sight, linear(colours[j])))));
  }
  return least;
}

double least_lightness_difference(const std::vector<std::string_view>& colours) {
  double least = 1e9;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, std::abs(lab(linear(colours[i]))[0] - lab(linear(colours[j]))[0]));
  }
  return least;
}

std::vector<std::string_view> line_colours() {
  std::vector<std::string_view> colours;
  for (const palette::Look& look : palette::looks) colours.push_back(look.colour);
  return colours;
}

std::vector<std::string_view> dark_page_colours() {
  return {palette::colours_on_dark.begin(), palette::colours_on_dark.end()};
}

std::vector<std::string_view> fills_and_white() {
  std::vector<std::string_view> colours(palette::fills.begin(), palette::fills.end());
  colours.push_back("#ffffff");
  return colours;
}

}  // namespace

TEST_CASE("simulated red-green blindness makes red similar to olive but not blue to yellow") {
  const auto between = [](std::string_view a, std::string_view b, const Matrix& sight) {
    return least_difference({a, b}, sight);
  };
  for (const Matrix& sight : {no_green_cone, no_red_cone}) {
    CHECK(between("#c00000", "#606000", sight) < between("#c00000", "#606000", all_cones) / 2);
    CHECK(between("#0000ff", "#ffff00", sight) > 100);
  }
  CHECK(between("#ffffff", "#808080", no_red_cone) ==
        doctest::Approx(between("#ffffff", "#808080", all_cones)).epsilon(0.01));
}

TEST_CASE("lines differ in grey and in normal and red-green-blind vision") {
  for (const std::vector<std::string_view>& colours : {line_colours(), dark_page_colours()}) {
    for (const Matrix& sight : {all_cones, no_green_cone, no_red_cone}) CHECK(least_difference(colours, sight) > 18);
    CHECK(least_lightness_difference(colours) > 6);
  }
}

TEST_CASE("each line look has a unique dash pattern and a unique mark") {
  std::set<std::string_view> dashes;
  std::set<palette::Mark> marks;
  for (const palette::Look& look : palette::looks) {
    CHECK(dashes.insert(look.dash).second);
    CHECK(marks.insert(look.mark).second);
  }
}

TEST_CASE("line colours contrast with white paper") {
  for (const std::string_view colour : line_colours()) CHECK(palette::contrast(colour, "#ffffff") > 2.25);
  for (const std::string_view colour : dark_page_colours()) CHECK(palette::contrast(colour, "#15181c") > 3);
}

TEST_CASE("parts of bars differ in grey and in normal and red-green-blind vision") {
  for (const Matrix& sight : {all_cones, no_green_cone, no_red_cone})
    CHECK(least_difference(fills_and_white(), sight) > 15);
  CHECK(least_lightness_difference(fills_and_white()) > 7);
}

TEST_CASE("texts on parts of bars have a contrast ratio above 4.5") {
  for (const std::string_view colour : palette::fills)
    CHECK(palette::contrast(colour, palette::readable_text_colour(colour)) > 4.5);
}

TEST_CASE("contrast() computes the contrast ratio of the WCAG guidelines") {
  CHECK(palette::contrast("#000000", "#ffffff") == doctest::Approx(21));
  CHECK(palette::contrast("#777777", "#ffffff") == doctest::Approx(4.48).epsilon(0.005));
}
