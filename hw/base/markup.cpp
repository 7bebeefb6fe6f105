#include "hw/base/markup.h"

#include "hw/base/text.h"

namespace csgsim {

namespace {

/// U+FFFE and U+FFFF are forbidden in XML although they are not control characters.
bool is_refused_by_xml(std::string_view character) {
  return character == "\xef\xbf\xbe" || character == "\xef\xbf\xbf";
}

}  // namespace

std::string markup_text(std::string_view bytes) {
  const std::string shown = printable(bytes);
  std::string text;
  for (std::size_t at = 0; at < shown.size(); ++at) {
    if (is_refused_by_xml(std::string_view(shown).substr(at, 3))) {
      text += "\ufffd";
      at += 2;
      continue;
    }
    switch (shown[at]) {
      case '&': text += "&amp;"; break;
      case '<': text += "&lt;"; break;
      case '>': text += "&gt;"; break;
      case '"': text += "&quot;"; break;
      case '\'': text += "&#39;"; break;
      default: text.push_back(shown[at]);
    }
  }
  return text;
}

}  // namespace csgsim
