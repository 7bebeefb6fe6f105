#include "host/flat/svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/flat/clipping.h"
#include "host/flat/svg/page.h"
#include "host/flat/svg/shapes.h"
#include "host/flat/svg/transform.h"
#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

/// Maximum number of corners of a drawing.
constexpr std::size_t max_drawing_corners = 1'000'000;

/// Maximum nesting depth of elements.
constexpr std::size_t max_depth = 1'000;

struct Box {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

/// Collects the shapes of all elements in order.
class SvgReader {
 public:
  SvgReader(std::string_view bytes, const SvgOptions& options) : bytes_(bytes), options_(options) {}

  Area read();

 private:
  void walk(pugi::xml_node root);
  void enter(pugi::xml_node element);
  void add(std::vector<Outline> outlines);
  [[nodiscard]] Area laid_out() const;
  [[nodiscard]] std::string place(std::ptrdiff_t offset) const;

  std::string_view bytes_;
  SvgOptions options_;
  std::vector<glm::dmat3> matrices_;  ///< the matrices of the current element and of those that enclose it
  std::vector<std::vector<Outline>> shapes_;
  std::size_t corners_ = 0;
  svg::Page page_;
  Box box_;  ///< bounds of all shapes, scaled by the page
};

std::string SvgReader::place(std::ptrdiff_t offset) const {
  const std::string_view before = bytes_.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  return "line " + std::to_string(1 + std::ranges::count(before, '\n')) + ": ";
}

void SvgReader::add(std::vector<Outline> outlines) {
  for (Outline& outline : outlines) {
    corners_ += outline.size();
    for (glm::dvec2& corner : outline) {
      corner = glm::dvec2(matrices_.back() * glm::dvec3(corner, 1));
      box_.low = glm::min(box_.low, page_.scale * corner);
      box_.high = glm::max(box_.high, page_.scale * corner);
    }
  }
  if (corners_ > max_drawing_corners) {
    throw InputError("the drawing has more than " + std::to_string(max_drawing_corners) + " corners; simplify it");
  }
  shapes_.push_back(std::move(outlines));
}

void SvgReader::enter(pugi::xml_node element) {
  const std::string_view name = element.name();
  const bool outermost = matrices_.size() == 1;
  matrices_.push_back(matrices_.back());
  if (name == "svg") page_ = svg::read_page(element, options_.dpi);
  std::optional<std::vector<Outline>> shape = svg::read_shape(element, max_drawing_corners - corners_);
  // Elements other than groups and shapes inherit the matrix unchanged.
  if ((shape || name == "g") && !outermost) {
    matrices_.back() = matrices_.back() * svg::read_transform(element.attribute("transform").value());
  }
  if (shape) add(std::move(*shape));
}

void SvgReader::walk(pugi::xml_node root) {
  matrices_.assign(1, glm::dmat3(1));
  pugi::xml_node node = root;
  while (!node.empty()) {
    if (matrices_.size() > max_depth) {
      throw InputError(place(node.offset_debug()) + "elements are nested more than " + std::to_string(max_depth) +
                       " deep; ungroup some");
    }
    try {
      enter(node);
    } catch (const InputError& error) {
      throw InputError(place(node.offset_debug()) + error.what());
    }
    const bool skipped = std::string_view(node.name()) == "defs";
    if (!skipped && !node.first_child().empty()) {
      node = node.first_child();
      continue;
    }
    matrices_.pop_back();
    while (node != root && node.next_sibling().empty()) {
      node = node.parent();
      matrices_.pop_back();
    }
    if (node == root) return;
    node = node.next_sibling();
  }
}

/// Places the shapes on the page, whose y axis points up. OpenSCAD subtracts the y of the box's lower corner where it
/// should be added; this function does the same.
Area SvgReader::laid_out() const {
  const glm::dvec2 centre = (box_.low + box_.high) / 2.0;
  const double x = options_.center ? -centre.x : page_.margin.x;
  const double y = options_.center ? centre.y : page_.height - page_.margin.y;
  std::vector<Area> areas;
  for (const std::vector<Outline>& shape : shapes_) {
    Area area;
    for (const Outline& outline : shape) {
      Outline& on_page = area.outlines.emplace_back();
      for (const glm::dvec2& corner : outline) {
        on_page.emplace_back(page_.scale.x * (corner.x - page_.origin.x) + x,
                             -page_.scale.y * (corner.y + page_.origin.y) + y);
      }
    }
    areas.push_back(even_odd_area(to_paths(area), options_.work));
  }
  return combined(areas, ClipperLib::ctUnion, options_.work);
}

Area SvgReader::read() {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(bytes_.data(), bytes_.size());
  if (!parsed) throw InputError(place(parsed.offset) + "invalid XML: " + parsed.description());
  const pugi::xml_node root = document.document_element();
  if (std::string_view(root.name()) != "svg")
    throw InputError(place(0) + "not an SVG file: the outermost element is not svg; save it as SVG");
  walk(root);
  return laid_out();
}

}  // namespace

Area read_svg(std::string_view bytes, const SvgOptions& options) {
  if (!(options.dpi >= 0.001) || !std::isfinite(options.dpi)) {
    throw InputError("dpi of import() must be at least 0.001");
  }
  return SvgReader(bytes, options).read();
}

}  // namespace csgsim::flat
