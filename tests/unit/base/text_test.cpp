#include "hw/base/text.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Inverts escaped() byte by byte, independently of the product's reader.
std::string unescaped(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      bytes += text[i];
      continue;
    }
    switch (text[++i]) {
      case 'n': bytes += '\n'; break;
      case 'r': bytes += '\r'; break;
      case 't': bytes += '\t'; break;
      case 'x':
        bytes += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
        i += 2;
        break;
      default: bytes += text[i];
    }
  }
  return bytes;
}

/// The word as a POSIX shell parses it.
std::string read_by_shell(const std::string& word) {
  FILE* const pipe = ::popen(
      ("bash -c 'read -r -d \"\" word; eval \"set -- $word\"; printf %s \"$1\"' 2>&1 <<'XYZ'\n" + word + "\nXYZ\n")
          .c_str(),
      "r");
  REQUIRE(pipe != nullptr);
  std::string text(1000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), pipe));
  ::pclose(pipe);
  return text;
}

}  // namespace

TEST_CASE("printable() keeps readable text unchanged") {
  for (const char* text : {"", "carburettor.csg", "a b's \"c\" \\ d", "Gehäuse 1,5.csg", "部品.csg", "😀", "=x"})
    CHECK(printable(text) == text);
}

TEST_CASE("printable() escapes control characters including bidi and invalid UTF-8") {
  CHECK(printable("a\nb\tc\rd") == "a\\nb\\tc\\rd");
  CHECK(printable("\x1b[31mred") == "\\x1b[31mred");
  CHECK(printable(std::string("nul\0l", 5)) == "nul\\x00l");
  CHECK(printable("\x7f") == "\\x7f");
  CHECK(printable("\xc2\x9b"
                  "31m") == "\\xc2\\x9b31m");  // CSI in Latin-1
  CHECK(printable("a\xe2\x80\xae"
                  "gsc.b") == "a\\xe2\\x80\\xaegsc.b");   // right-to-left override
  CHECK(printable("\xe2\x80\xa8") == "\\xe2\\x80\\xa8");  // line separator
  CHECK(printable("\xff\xfe") == "\\xff\\xfe");
  CHECK(printable("Geh\xe4use") == "Geh\\xe4use");        // Latin-1
  CHECK(printable("\xc0\xaf") == "\\xc0\\xaf");           // overlong encoding
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");  // surrogate
  CHECK(printable("\xe2\x82") == "\\xe2\\x82");           // truncated
}

TEST_CASE("printable() yields one line for any bytes and is idempotent") {
  CHECK(rc::check([](const std::string& bytes) {
    const std::string text = printable(bytes);
    for (const char byte : text) RC_ASSERT(static_cast<unsigned char>(byte) >= 0x20 && byte != 0x7f);
    RC_ASSERT(printable(text) == text);
  }));
}

TEST_CASE("escaped() is reversible and never looks like a spreadsheet formula") {
  CHECK(rc::check([](const std::string& bytes) {
    const std::string text = escaped(bytes);
    RC_ASSERT(unescaped(text) == bytes);
    RC_ASSERT(printable(text) == text);
    RC_ASSERT(text.empty() || std::string("=+-@").find(text.front()) == std::string::npos);
  }));
  CHECK(escaped("=1+1.csg") == "\\x3d1+1.csg");
  CHECK(escaped("@SUM(A1)") == "\\x40SUM(A1)");
  CHECK(escaped("a\\nb") == "a\\\\nb");
  CHECK(escaped("a\nb") == "a\\nb");
}

TEST_CASE("a shell parses shell_word() back to the original bytes") {
  for (const std::string& bytes :
       std::to_array<std::string>({"a.csg", "two words", "", "it's", "$(touch PWNED)", "`x`;|&", "line\nbreak",
                                   "\x1b[0m", "\xff", "-o", "*?~#!"})) {
    CAPTURE(bytes);
    CHECK(read_by_shell(shell_word(bytes)) == bytes);
  }
}
