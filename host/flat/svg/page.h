// Page size and viewBox of an SVG file.
// Used by svg.cpp.
#pragma once

#include <glm/vec2.hpp>
#include <pugixml.hpp>

namespace csgsim::flat::svg {

/// How an svg element places its drawing on the page, in millimetres.
struct Page {
  glm::dvec2 scale{1};   ///< millimetres per user unit
  glm::dvec2 origin{0};  ///< lower corner of the drawing, in user units
  glm::dvec2 margin{0};  ///< additional offset from the alignment
  double height = 0;     ///< of the page, millimetres
};

/// The page described by width, height, viewBox and preserveAspectRatio. Throws InputError if it is invalid.
Page read_page(pugi::xml_node svg, double dpi);

}  // namespace csgsim::flat::svg
