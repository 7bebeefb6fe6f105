#include "sim/observe/account_json.h"

#include <nlohmann/json.hpp>

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("an account's JSON has counts and shares by name before the clocks of each part") {
  const machines::Account account{.counts = {{"lines", 3}, {"packets", 12}},
                                  .shares = {{"mean_packets", 12, 3}, {"cell_utilisation", 0, 0}},
                                  .parts = {{"host", {{"working", 5}, {"done", 2}}}, {"renderer 0", {{"working", 7}}}}};
  CHECK(observe::account_json(account).dump() ==
        R"({"lines":3,"packets":12,"mean_packets":4.0,"cell_utilisation":0.0,)"
        R"("parts":{"host":{"working":5,"done":2},"renderer 0":{"working":7}}})");
}

TEST_CASE("the JSON of an empty account has an empty list of parts") {
  CHECK(observe::account_json({}).dump() == R"({"parts":{}})");
}

TEST_CASE("reading a count missing from an account is an error") {
  const machines::Account account{.counts = {{"lines", 3}}, .shares = {}, .parts = {}};
  CHECK(account.count("lines") == 3);
  CHECK_THROWS_AS(static_cast<void>(account.count("line")), std::out_of_range);
}
