#include "hw/base/text.h"

#include <rapidcheck.h>

#include <cmath>
#include <limits>

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

TEST_CASE("rounded() keeps the requested digits and never rounds before the decimal point") {
  CHECK(rounded(0) == "0");
  CHECK(rounded(24.3175, 4) == "24.32");
  CHECK(rounded(1057.6, 4) == "1,058");
  CHECK(rounded(1057.6, 5) == "1057.6");
  CHECK(rounded(0.0057597) == "0.00576");
  CHECK(rounded(999.4) == "999");
  CHECK(rounded(999.6) == "1,000");
  CHECK(rounded(1736.17) == "1,736");
  CHECK(rounded(-1736.17) == "-1,736");
  CHECK(rounded(2.5) == "2.5");
  CHECK(rounded(std::numeric_limits<double>::infinity()) == "inf");
}

TEST_CASE("quantity() selects an SI prefix and uses none for seconds above one") {
  CHECK(quantity(26'599'667'194e-12, "J") == "26.6 mJ");
  CHECK(quantity(1e7, "Hz") == "10 MHz");
  CHECK(quantity(18'874'368, "bit") == "18.9 Mbit");
  CHECK(quantity(72, "bit") == "72 bit");
  CHECK(quantity(6'609'960'960.0, "") == "6.61 G");
  CHECK(quantity(7, "") == "7");
  CHECK(quantity(0, "s") == "0 s");
  CHECK(quantity(4.2e-7, "s") == "420 ns");
  CHECK(quantity(0.0009996, "s") == "1 ms");
  CHECK(quantity(0.00099949, "s") == "999 us");
  CHECK(quantity(173.6, "s") == "174 s");
  CHECK(quantity(1736.17, "s") == "1,736 s");
  CHECK(quantity(3e-15, "J") == "0.003 pJ");
  CHECK(quantity(4e15, "") == "4,000 T");
}

TEST_CASE("quantity() rounds the value to three digits from 1 to 999 before the unit") {
  CHECK(rc::check([] {
    const double value = std::pow(10.0, *rc::gen::inRange(-1100, 1400) / 100.0);
    const std::string text = quantity(value, "J");
    const std::size_t blank = text.find(' ');
    const std::string prefixes = "pnum kMGT";
    const std::string prefix = text.substr(blank + 1, text.size() - blank - 2);
    const auto place = prefix.empty() ? 4 : static_cast<int>(prefixes.find(prefix));
    const double shown = std::stod(text.substr(0, blank)) * std::pow(1000.0, place - 4);
    RC_ASSERT(std::abs(shown / value - 1) <= 0.00501);
    RC_ASSERT(std::stod(text.substr(0, blank)) >= 1);
    RC_ASSERT(std::stod(text.substr(0, blank)) < 1000);
  }));
}
