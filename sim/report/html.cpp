#include "sim/report/html.h"

#include <nlohmann/json.hpp>

namespace csgsim::report {

std::string json_in_html(const nlohmann::ordered_json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    // In strings alone, where JSON knows it by its number too.
    c == '<' ? text += "\\u003c" : text += c;
  }
  return text;
}

std::string html_id(std::string_view text) {
  std::string id;
  for (const char c : text) {
    const bool is_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_word) {
      id.push_back(static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c));
    } else if (!id.empty() && id.back() != '-') {
      id.push_back('-');
    }
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id;
}

}  // namespace csgsim::report
