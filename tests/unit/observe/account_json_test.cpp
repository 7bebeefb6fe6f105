#include "sim/observe/account_json.h"

#include <nlohmann/json.hpp>

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("an account is told as counts and shares by name, then the clocks of each part by activity") {
  const machines::Account account{.counts = {{"lines", 3}, {"packets", 12}},
                                  .shares = {{"mean_packets", 12, 3}, {"cell_utilisation", 0, 0}},
                                  .parts = {{"host", {{"working", 5}, {"done", 2}}}, {"renderer 0", {{"working", 7}}}}};
  CHECK(observe::account_json(account).dump() ==
        R"({"lines":3,"packets":12,"mean_packets":4.0,"cell_utilisation":0.0,)"
        R"("parts":{"host":{"working":5,"done":2},"renderer 0":{"working":7}}})");
}

TEST_CASE("an account of nothing has no parts, but says so") {
  CHECK(observe::account_json({}).dump() == R"({"parts":{}})");
}

TEST_CASE("a count that an account does not have is an error, not 0") {
  const machines::Account account{.counts = {{"lines", 3}}, .shares = {}, .parts = {}};
  CHECK(account.count("lines") == 3);
  CHECK_THROWS_AS(static_cast<void>(account.count("line")), std::out_of_range);
}
