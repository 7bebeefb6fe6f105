#include "host/flat/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "host/flat/clipping.h"
#include "host/flat/lettering/module.h"
#include "host/model/fragments.h"
#include "hw/base/error.h"
#include "hw/base/module.h"

namespace csgsim::flat {

namespace {

/// Maximum length of a text in bytes.
constexpr std::size_t max_length = 10'000;

/// Maximum number of corners of all letters.
constexpr std::size_t max_corners = 1'000'000;

#ifdef CSGSIM_WITHOUT_TEXT
constexpr const char* disabling_option = "CSGSIM_TEXT";
#else
constexpr const char* disabling_option = nullptr;
#endif

const lettering::Module& opened_module() {
  static const void* const symbol = load_module_symbol({.file = lettering::module_file,
                                                        .symbol = lettering::module_symbol,
                                                        .does = "sets the letters of text()",
                                                        .disabling_option = disabling_option});
  return *static_cast<const lettering::Module*>(symbol);
}

void check_alignment(const char* name, const std::string& value, std::span<const std::string_view> known) {
  if (std::ranges::find(known, value) != known.end()) return;
  std::string message = std::string(name) + " of text() is \"" + value + "\"; use ";
  for (std::size_t i = 0; i < known.size(); ++i) {
    message += (i == 0 ? "\"" : i + 1 == known.size() ? " or \"" : ", \"") + std::string(known[i]) + "\"";
  }
  throw InputError(message);
}

void check(const Text& text) {
  constexpr std::array<std::string_view, 3> across{"left", "center", "right"};
  constexpr std::array<std::string_view, 4> along{"top", "center", "baseline", "bottom"};
  check_alignment("halign", text.halign, across);
  check_alignment("valign", text.valign, along);
  if (!std::isfinite(text.size) || !std::isfinite(text.spacing)) {
    throw InputError("size and spacing of text() must be finite numbers");
  }
  if (text.text.size() > max_length) {
    throw InputError("text() is longer than " + std::to_string(max_length) + " bytes; split it");
  }
}

/// Number of sides of a letter's curve.
std::uint32_t sides_per_curve(const Text& text) {
  return std::max(model::fragments(text.size, text.facets) / 8 + 1, 2U);
}

}  // namespace

Area text(const Text& text) {
  check(text);
  const lettering::Lettering lettering = opened_module().draw(text, sides_per_curve(text), max_corners);
  if (!lettering.error.empty()) throw InputError(lettering.error);
  // The union of the letters is independent of the direction of their outlines.
  return combined(lettering.letters, ClipperLib::ctUnion);
}

std::optional<std::string> replacement_font(const std::string& font) {
  std::string family = opened_module().replacement(font);
  if (family.empty()) return std::nullopt;
  return family;
}

}  // namespace csgsim::flat
