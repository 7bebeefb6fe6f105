#include "tests/unit/sweep/given.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "places.h"

namespace csgsim::testing {

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error(path + " cannot be read");
  return text;
}

/// Returns the text after `name = ` up to the enclosing bracket or comma; empty if absent.
std::string value(const std::string& text, const std::string& name) {
  const std::size_t found = text.find(name + " = ");
  if (found == std::string::npos) return {};
  const std::size_t begin = found + name.size() + 3;
  int depth = 0;
  std::size_t end = begin;
  for (; end < text.size(); ++end) {
    if (depth == 0 && (text[end] == ',' || text[end] == ')')) break;
    depth += text[end] == '[' ? 1 : text[end] == ']' ? -1 : 0;
  }
  return text.substr(begin, end - begin);
}

/// Returns the numbers of nested brackets, grouped by the inner brackets.
std::vector<std::vector<double>> rows(std::string text) {
  std::vector<std::vector<double>> result;
  if (text.empty() || text == "undef") return result;
  text = text.substr(1, text.size() - 2);
  for (std::size_t begin = text.find('['); begin != std::string::npos; begin = text.find('[', begin + 1)) {
    std::istringstream row(text.substr(begin + 1, text.find(']', begin) - begin - 1));
    std::vector<double>& numbers = result.emplace_back();
    char comma = 0;
    for (double number = 0; row >> number; row >> comma) numbers.push_back(number);
  }
  return result;
}

double number(const std::string& text, const std::string& name, double otherwise) {
  const std::string found = value(text, name);
  return found.empty() ? otherwise : std::stod(found);
}

flat::Area read_area(const std::string& text) {
  const std::vector<std::vector<double>> points = rows(value(text, "points"));
  std::vector<std::vector<double>> paths = rows(value(text, "paths"));
  if (paths.empty()) {
    paths.emplace_back();
    for (std::size_t i = 0; i < points.size(); ++i) paths.back().push_back(static_cast<double>(i));
  }
  flat::Area area;
  for (const std::vector<double>& path : paths) {
    flat::Outline& outline = area.outlines.emplace_back();
    for (const double index : path) {
      const std::vector<double>& point = points.at(static_cast<std::size_t>(index));
      outline.emplace_back(point.at(0), point.at(1));
    }
  }
  return area;
}

}  // namespace

Given read_given(const std::string& name) {
  const std::string path = std::string(CSGSIM_SOURCE_DIR) + "/tests/unit/sweep/data/" + name;
  const std::string text = text_of(path + ".csg");
  const model::FacetControl facets{number(text, "$fn", 0), number(text, "$fa", 12), number(text, "$fs", 2)};
  Given given{read_area(text), {}, {}};
  if (text.find("rotate_extrude") != std::string::npos) {
    given.sweep = solids::RotateExtrude{number(text, "angle", 360), facets};
  } else {
    const std::vector<double> scale = rows("[" + value(text, "scale") + "]").at(0);
    given.sweep =
        solids::LinearExtrude{number(text, "height", 0),  value(text, "center") == "true",
                              number(text, "twist", 0),   static_cast<std::uint32_t>(number(text, "slices", 0)),
                              {scale.at(0), scale.at(1)}, facets};
  }
  if (name != "l_none") given.surface = read_off(path + ".off");
  return given;
}

std::vector<model::Polyhedron> swept(const Given& given) {
  if (const auto* linear = std::get_if<solids::LinearExtrude>(&given.sweep)) {
    return solids::linear_extrude(given.area, *linear);
  }
  return solids::rotate_extrude(given.area, std::get<solids::RotateExtrude>(given.sweep));
}

}  // namespace csgsim::testing
