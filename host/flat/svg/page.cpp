#include "host/flat/svg/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/flat/svg/numbers.h"
#include "hw/base/error.h"

namespace csgsim::flat::svg {

namespace {

constexpr double inch = 25.4;

struct ViewBox {
  glm::dvec2 low{0};
  glm::dvec2 size{0};
};

std::optional<ViewBox> read_view_box(std::string_view text) {
  std::array<double, 4> found{};
  Numbers rest(text);
  for (double& value : found) {
    rest.skip_separators();
    const std::optional<double> number = rest.number();
    if (!number) return std::nullopt;
    value = *number;
  }
  rest.skip_separators();
  if (!rest.at_end() || found[2] < 0 || found[3] < 0) return std::nullopt;
  if (found[2] == 0 || found[3] == 0)
    throw InputError("the viewBox of the svg has no size; set its width and height above 0");
  return ViewBox{{found[0], found[1]}, {found[2], found[3]}};
}

/// A length in millimetres; if it is missing, the box's length at `dpi` units per inch.
double millimetres(std::string_view text, double box, double dpi) {
  Numbers rest(text);
  rest.skip_separators();
  const std::optional<double> number = rest.number();
  rest.skip_separators();
  const std::string_view unit = rest.take('%') ? "%" : rest.word();
  rest.skip_separators();
  if (!number || !rest.at_end()) return inch * box / dpi;
  if (unit.empty()) return inch * *number / dpi;
  if (unit == "px") return inch * *number / 96;
  if (unit == "pt") return inch * *number / 72;
  if (unit == "pc") return inch * *number / 6;
  if (unit == "in") return inch * *number;
  if (unit == "cm") return 10 * *number;
  if (unit == "mm") return *number;
  if (unit == "em" || unit == "ex" || unit == "%") return box;
  return inch * box / dpi;
}

/// The value of preserveAspectRatio.
struct Alignment {
  bool stretch = false;   ///< scale both axes independently
  bool slice = false;     ///< fill the page
  glm::dvec2 place{0.5};  ///< per axis, the fraction of the remaining space that is before the drawing
};

Alignment read_alignment(std::string_view text) {
  constexpr std::array<std::string_view, 3> names{"Min", "Mid", "Max"};
  std::vector<std::string_view> words;
  Numbers rest(text);
  rest.skip_separators();
  while (!rest.at_end()) {
    words.push_back(rest.word());
    rest.skip_separators();
    if (words.back().empty()) return {};
  }
  if (!words.empty() && words.front() == "defer") words.erase(words.begin());
  if (words.empty() || words.size() > 2) return {};
  if (words.size() == 2 && words[1] != "meet" && words[1] != "slice") return {};
  Alignment result;
  result.slice = words.size() == 2 && words[1] == "slice";
  if (words[0] == "none") {
    result.stretch = true;
    return result;
  }
  const std::string_view align = words[0];
  if (align.size() != 8 || align[0] != 'x' || align[4] != 'Y') return {};
  for (int axis = 0; axis < 2; ++axis) {
    const auto name = std::ranges::find(std::span(names), align.substr(axis == 0 ? 1 : 5, 3));
    if (name == std::span(names).end()) return {};
    result.place[axis] = static_cast<double>(name - std::span(names).begin()) / 2;
  }
  return result;
}

}  // namespace

Page read_page(pugi::xml_node svg, double dpi) {
  const std::optional<ViewBox> box = read_view_box(svg.attribute("viewBox").value());
  const glm::dvec2 size = box ? box->size : glm::dvec2(0);
  const glm::dvec2 paper(millimetres(svg.attribute("width").value(), size.x, dpi),
                         millimetres(svg.attribute("height").value(), size.y, dpi));
  Page page;
  page.height = paper.y;
  if (!box) return page;
  page.origin = box->low;
  page.scale = paper / size;
  const Alignment alignment = read_alignment(svg.attribute("preserveAspectRatio").value());
  if (alignment.stretch) return page;
  page.scale =
      glm::dvec2(alignment.slice ? std::max(page.scale.x, page.scale.y) : std::min(page.scale.x, page.scale.y));
  page.margin = alignment.place * (paper - page.scale * size);
  return page;
}

}  // namespace csgsim::flat::svg
