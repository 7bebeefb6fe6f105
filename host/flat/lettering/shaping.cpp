#include "host/flat/lettering/shaping.h"

#include <hb-ft.h>

#include <memory>
#include <span>

namespace csgsim::flat::lettering {

namespace {

struct DestroyShaping {
  void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
  void operator()(hb_font_t* font) const { hb_font_destroy(font); }
};
using Buffer = std::unique_ptr<hb_buffer_t, DestroyShaping>;
using Font = std::unique_ptr<hb_font_t, DestroyShaping>;

/// The characters of the text in Unicode; U+FFFD for invalid UTF-8.
std::vector<hb_codepoint_t> characters(const std::string& text) {
  const Buffer buffer(hb_buffer_create());
  hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
  unsigned int count = 0;
  const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  std::vector<hb_codepoint_t> result;
  for (const hb_glyph_info_t& info : std::span(infos, count)) result.push_back(info.codepoint);
  return result;
}

bool has_no_script(hb_script_t script) {
  return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN ||
         script == HB_SCRIPT_INVALID;
}

/// The script shared by all characters that have one; invalid if there is none or there are several.
hb_script_t common_script(std::span<const hb_codepoint_t> text) {
  hb_script_t common = HB_SCRIPT_INVALID;
  for (const hb_codepoint_t character : text) {
    const hb_script_t script = hb_unicode_script(hb_unicode_funcs_get_default(), character);
    if (has_no_script(script) || script == common) continue;
    if (common != HB_SCRIPT_INVALID) return HB_SCRIPT_INVALID;
    common = script;
  }
  return common;
}

hb_direction_t resolve_direction(const Text& text, hb_script_t script) {
  const hb_direction_t requested = hb_direction_from_string(text.direction.c_str(), -1);
  if (requested != HB_DIRECTION_INVALID) return requested;
  const hb_direction_t natural = hb_script_get_horizontal_direction(script);
  return natural != HB_DIRECTION_INVALID ? natural : HB_DIRECTION_LTR;
}

void set_properties(hb_buffer_t* buffer, const Text& text, std::span<const hb_codepoint_t> codes) {
  const hb_script_t requested = hb_script_from_string(text.script.c_str(), -1);
  const hb_script_t script = requested != HB_SCRIPT_INVALID ? requested : common_script(codes);
  hb_buffer_set_direction(buffer, resolve_direction(text, script));
  hb_buffer_set_script(buffer, script);
  hb_buffer_set_language(buffer, hb_language_from_string(text.language.c_str(), -1));
}

}  // namespace

Line shape(const Text& text, FT_Face face) {
  std::vector<hb_codepoint_t> codes = characters(text.text);
  const Buffer buffer(hb_buffer_create());
  set_properties(buffer.get(), text, codes);
  if (is_symbol_font(face)) {
    for (hb_codepoint_t& code : codes) code += code < 0x100 ? 0xf000U : 0;
  }
  const int length = static_cast<int>(codes.size());
  hb_buffer_add_codepoints(buffer.get(), codes.data(), length, 0, length);
  const Font font(hb_ft_font_create(face, nullptr));
  hb_shape(font.get(), buffer.get(), nullptr, 0);

  unsigned int count = 0;
  const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const hb_glyph_position_t* const positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
  Line line{HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(buffer.get())), {}};
  for (unsigned int i = 0; i < count; ++i) line.glyphs.push_back({infos[i].codepoint, positions[i]});
  return line;
}

}  // namespace csgsim::flat::lettering
