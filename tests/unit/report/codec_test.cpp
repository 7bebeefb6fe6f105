#include "sim/report/codec.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

using namespace csgsim;

TEST_CASE("base 64 is encoded as in RFC 4648") {
  for (const auto& [bytes, text] : std::vector<std::pair<std::string, std::string>>{{"", ""},
                                                                                    {"f", "Zg=="},
                                                                                    {"fo", "Zm8="},
                                                                                    {"foo", "Zm9v"},
                                                                                    {"foob", "Zm9vYg=="},
                                                                                    {"fooba", "Zm9vYmE="},
                                                                                    {"foobar", "Zm9vYmFy"}})
    CHECK(report::base64(bytes) == text);
  CHECK(report::base64(std::string("\xff\xfe\x00", 3)) == "//4A");
}

TEST_CASE("numbers in a page are encoded as varints with the lowest 7 bits first") {
  std::string bytes;
  for (const std::uint64_t number : {0U, 127U, 128U, 300U}) report::put_varint(number, bytes);
  CHECK(bytes == std::string("\x00\x7f\x80\x01\xac\x02", 6));
  report::put_varint(~std::uint64_t{0}, bytes);
  std::string_view rest = bytes;
  for (const std::uint64_t number :
       {std::uint64_t{0}, std::uint64_t{127}, std::uint64_t{128}, std::uint64_t{300}, ~std::uint64_t{0}})
    CHECK(report::read_varint(rest) == number);
  CHECK(rest.empty());
}

TEST_CASE("owners in a page are encoded as runs of a count and owner + 1") {
  const std::vector<std::uint32_t> owners{~0U, ~0U, 4, 4, 4, 0};
  CHECK(report::encode_owner_runs(owners) == std::string("\x02\x00\x03\x05\x01\x01", 6));
}

TEST_CASE("encoded changes turn earlier states into later ones and back") {
  std::mt19937 generator(7);
  const auto random = [&] { return static_cast<std::uint32_t>(generator()); };
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint32_t> before(random() % 300);
    for (std::uint32_t& state : before) state = random() % 3;
    std::vector<std::uint32_t> after = before;
    for (std::uint32_t& state : after)
      if (random() % 4 == 0) state = random() % 0x2000000U;
    const std::string changes = report::encode_changes(before, after);
    std::vector<std::uint32_t> states = before;
    report::apply_changes(changes, states);
    CHECK(states == after);
    report::apply_changes(changes, states);
    CHECK(states == before);
    CHECK(changes.empty() == (before == after));
  }
}
