#include "host/flat/lettering/module.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "host/flat/lettering/fonts.h"
#include "host/flat/lettering/outlines.h"
#include "host/flat/lettering/shaping.h"

#include FT_OUTLINE_H

namespace csgsim::flat::lettering {

namespace {

// OpenSCAD's constants. All glyphs are drawn at one size, in 1/64 points at 100 dots per inch. Division by
// outline_scale gives the outlines of text of size 1; positions have a divisor that is 1.024 times as large.
constexpr double outline_scale = 1e5;
constexpr double place_scale = 1.024e5;
constexpr FT_UInt dots_an_inch = 100;

/// The extent of a line of text of size 1.
struct Extent {
  double width = 0;
  double ascent = 0;   ///< above the base line; the whole length of vertical text
  double descent = 0;  ///< below the base line
};

/// A glyph's outlines relative to its origin, and that origin, for text of size 1.
struct Placed {
  Area area;
  glm::dvec2 origin{0};
};

struct Drawn {
  std::vector<Placed> glyphs;
  Extent extent;
};

void load(FT_Face face, const Glyph& glyph) {
  if (FT_Load_Glyph(face, glyph.index, FT_LOAD_DEFAULT) != 0 || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
    throw std::runtime_error("font " + font_name(face) + " has no outline for glyph " + std::to_string(glyph.index));
  }
}

void extend(Extent& extent, FT_Outline& outline, const Glyph& glyph, bool horizontal, double spacing) {
  constexpr FT_Pos pixel = 64;
  FT_BBox box{};
  FT_Outline_Get_CBox(&outline, &box);
  const auto down = [](FT_Pos place) { return static_cast<double>(place & -pixel) / place_scale; };
  const auto up = [](FT_Pos place) { return static_cast<double>((place + pixel - 1) & -pixel) / place_scale; };
  if (horizontal) {
    extent.width += glyph.position.x_advance / place_scale * spacing;
    extent.ascent = std::max(extent.ascent, up(box.yMax));
    extent.descent = std::max(extent.descent, -down(box.yMin));
  } else {
    extent.width = std::max(extent.width, up(box.xMax) - down(box.xMin));
    extent.ascent += glyph.position.y_advance / place_scale * spacing;
  }
}

Drawn draw_line(const Text& text, FT_Face face, std::uint32_t sides_per_curve, std::size_t max_corners) {
  const Line line = shape(text, face);
  Drawn drawn;
  glm::dvec2 at(0);
  std::size_t corners = 0;
  for (const Glyph& glyph : line.glyphs) {
    load(face, glyph);
    FT_Outline& outline = face->glyph->outline;
    corners += static_cast<std::size_t>(outline.n_points) * sides_per_curve;
    if (corners > max_corners) {
      throw std::runtime_error("the text has more than " + std::to_string(max_corners) +
                               " corners; use fewer facets ($fn), or split it");
    }
    extend(drawn.extent, outline, glyph, line.horizontal, text.spacing);
    const glm::dvec2 offset = glm::dvec2(glyph.position.x_offset, glyph.position.y_offset) / place_scale;
    drawn.glyphs.push_back({outlines(outline, sides_per_curve), at + offset});
    at += glm::dvec2(glyph.position.x_advance, glyph.position.y_advance) / place_scale * text.spacing;
  }
  return drawn;
}

glm::dvec2 alignment(const Text& text, const Extent& extent) {
  glm::dvec2 shift(0);
  if (text.halign == "right") shift.x = -extent.width;
  if (text.halign == "center") shift.x = -extent.width / 2;
  if (text.valign == "top") shift.y = -extent.ascent;
  if (text.valign == "center") shift.y = (extent.descent - extent.ascent) / 2;
  if (text.valign == "bottom") shift.y = extent.descent;
  return shift;
}

std::vector<Area> draw_letters(const Text& text, std::uint32_t sides_per_curve, std::size_t max_corners) {
  const FT_Face face = find_font(text.font);
  if (FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(outline_scale), dots_an_inch, dots_an_inch) != 0) {
    throw std::runtime_error("font " + font_name(face) + " cannot be scaled; use another font");
  }
  Drawn drawn = draw_line(text, face, sides_per_curve, max_corners);
  const glm::dvec2 shift = alignment(text, drawn.extent);
  std::vector<Area> letters;
  for (Placed& placed : drawn.glyphs) {
    for (Outline& outline : placed.area.outlines) {
      for (glm::dvec2& corner : outline) corner = text.size * (corner / outline_scale + placed.origin + shift);
    }
    letters.push_back(std::move(placed.area));
  }
  return letters;
}

/// Fonts stay open between calls, and two threads must not use them at once.
std::mutex& fonts_in_use() {
  static std::mutex mutex;
  return mutex;
}

Lettering draw(const Text& text, std::uint32_t sides_per_curve, std::size_t max_corners) {
  const std::lock_guard lock(fonts_in_use());
  try {
    return {draw_letters(text, sides_per_curve, max_corners), {}};
  } catch (const std::exception& error) {
    return {{}, error.what()};
  }
}

std::string replacement(const std::string& font) {
  const std::lock_guard lock(fonts_in_use());
  try {
    return find_replacement(font);
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace

}  // namespace csgsim::flat::lettering

// The name must match module_symbol.
extern "C" [[gnu::visibility("default")]] const csgsim::flat::lettering::Module csgsim_text_2;
const csgsim::flat::lettering::Module csgsim_text_2{csgsim::flat::lettering::draw,
                                                    csgsim::flat::lettering::replacement};
