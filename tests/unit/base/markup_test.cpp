#include "hw/base/markup.h"

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("text in HTML and XML has no markup, and what people must not read is escaped") {
  CHECK(markup_text("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
  CHECK(markup_text("two\nlines") == "two\\nlines");
  CHECK(markup_text("\xff") == "\\xff");
}

TEST_CASE("code points that XML does not take become one that it takes, and others stay") {
  CHECK(markup_text("a\ufffe\uffff") == "a\ufffd\ufffd");
  CHECK(markup_text("\ufffd\uffe5\u5b57\U0010ffff") == "\ufffd\uffe5\u5b57\U0010ffff");
}
