#include "hw/isa/quoting.h"

#include <fmt/format.h>

#include <charconv>

#include "hw/isa/grammar_parts.h"

namespace csgsim::isa {

std::string quote_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (code < 0x20U || code == 0x7fU) {
      out += fmt::format("\\x{:02x}", code);
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string unescaped(std::string_view body) {
  std::string out;
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i] == '\\' && body[++i] == 'x') {
      unsigned code = 0;
      std::from_chars(body.data() + i + 1, body.data() + i + 3, code, 16);
      out += static_cast<char>(code);
      i += 2;
    } else {
      out += body[i];
    }
  }
  return out;
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out;
  out.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) out += {digits[byte >> 4U], digits[byte & 0xfU]};
  return out;
}

std::optional<std::vector<std::uint8_t>> parse_hexadecimal(std::string_view digits) {
  if (digits.size() % 2 != 0) return std::nullopt;
  std::vector<std::uint8_t> bytes(digits.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char* const first = digits.data() + 2 * i;
    const auto [end, error] = std::from_chars(first, first + 2, bytes[i], 16);
    if (error != std::errc{} || end != first + 2) return std::nullopt;
  }
  return bytes;
}

std::string word_or_quoted(std::string_view text) {
  tao::pegtl::memory_input<> in(text.data(), text.size(), "");
  return tao::pegtl::parse<tao::pegtl::seq<grammar::word, tao::pegtl::eof>>(in) ? std::string(text) : quote_text(text);
}

}  // namespace csgsim::isa
