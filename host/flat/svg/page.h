#pragma once

#include <glm/vec2.hpp>
#include <pugixml.hpp>

namespace csgsim::flat::svg {

/// How an svg element lays its drawing on the page, in millimetres.
struct Page {
  glm::dvec2 scale{1};   ///< of the drawing's units
  glm::dvec2 origin{0};  ///< the drawing's low corner, in its units
  glm::dvec2 margin{0};  ///< what alignment moves it by
  double height = 0;
};

/// The page that width, height, viewBox and preserveAspectRatio describe. Throws InputError.
Page read_page(pugi::xml_node svg, double dpi);

}  // namespace csgsim::flat::svg
