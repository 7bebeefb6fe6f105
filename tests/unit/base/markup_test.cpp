#include "hw/base/markup.h"

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("markup_text() escapes markup and unprintable characters") {
  CHECK(markup_text("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
  CHECK(markup_text("two\nlines") == "two\\nlines");
  CHECK(markup_text("\xff") == "\\xff");
}

TEST_CASE("markup_text() replaces code points that XML forbids and keeps all others") {
  CHECK(markup_text("a\ufffe\uffff") == "a\ufffd\ufffd");
  CHECK(markup_text("\ufffd\uffe5\u5b57\U0010ffff") == "\ufffd\uffe5\u5b57\U0010ffff");
}
