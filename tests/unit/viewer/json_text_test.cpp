#include "sim/session/options/json_text.h"

#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

std::string nested_objects(std::size_t depth) {
  std::string text = "1";
  for (std::size_t i = 0; i < depth; ++i) text = "{\"a\":" + text + "}";
  return text;
}

std::string error_of(const std::string& text, const session::JsonLimits& limits) {
  return testing::error_of([&] { static_cast<void>(session::parse_json(text, limits)); });
}

}  // namespace

TEST_CASE("a JSON text nested deeper than its limit is rejected") {
  for (const std::size_t depth : {1U, 2U, 5U}) {
    const session::JsonLimits limits{.depth = static_cast<int>(depth)};
    CHECK(error_of(nested(depth), limits) == "");
    CHECK(error_of(nested_objects(depth), limits) == "");
    CHECK(error_of(nested(depth + 1), limits) == "brackets are nested deeper than " + std::to_string(depth));
    CHECK(error_of(nested_objects(depth + 1), limits) != "");
    CHECK(error_of("[" + nested_objects(depth) + "]", limits) != "");
  }
  // Siblings do not count as nested.
  CHECK(error_of("[[],[],[[]],{}]", {.depth = 3}) == "");
  CHECK(error_of(std::string(1'000'000, '['), {}) != "");
}

TEST_CASE("keys and values and brackets of a JSON text count toward its limit of values") {
  CHECK(error_of(R"([1,2,3])", {.values = 4}) == "");
  CHECK(error_of(R"([1,2,3])", {.values = 3}) == "it has more than 3 values");
  CHECK(error_of(R"({"a":1,"b":{}})", {.values = 5}) == "");
  CHECK(error_of(R"({"a":1,"b":{}})", {.values = 4}) != "");
}

TEST_CASE("a JSON text within its limits is parsed unchanged") {
  CHECK(session::parse_json(R"({"b":[1,2.5,"x",null,true],"a":{}})", {}).dump() ==
        R"({"b":[1,2.5,"x",null,true],"a":{}})");
  CHECK_THROWS_AS(static_cast<void>(session::parse_json("{", {})), nlohmann::ordered_json::exception);
  CHECK_THROWS_AS(static_cast<void>(session::parse_json("{}{}", {})), nlohmann::ordered_json::exception);
}
