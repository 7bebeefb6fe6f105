#include "tests/support/properties.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Returns the numbers that a property draws now.
std::vector<int> drawn(const std::string& description = "") {
  std::vector<int> numbers;
  REQUIRE(rc::check(
      description, [&] { numbers.push_back(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'000'000))); }));
  return numbers;
}

/// Sets RC_PARAMS and restores it in the destructor.
class Parameters {
 public:
  explicit Parameters(const char* now) : before_(std::getenv("RC_PARAMS")) { ::setenv("RC_PARAMS", now, 1); }
  ~Parameters() { ::setenv("RC_PARAMS", before_.c_str(), 1); }
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;

 private:
  std::string before_;
};

}  // namespace

TEST_CASE("properties draw the same numbers in each process and differ from each other") {
  testing::begin_case("one");
  const std::vector<int> first = drawn();
  const std::vector<int> second = drawn();
  const std::vector<int> described = drawn("what holds");
  testing::begin_case("two");
  const std::vector<int> other = drawn();
  CHECK(std::set<std::vector<int>>{first, second, described, other}.size() == 4);
  testing::begin_case("one");
  CHECK(drawn() == first);
  CHECK(drawn() == second);
  CHECK(drawn("what holds") == described);
}

TEST_CASE("the suite's seed is fixed and a seed in RC_PARAMS is kept") {
  CHECK(testing::parameter("seed") != "");
  {
    const Parameters none("");
    testing::add_parameters();
    CHECK(std::string(std::getenv("RC_PARAMS")) == "seed=1");
    CHECK(testing::draws_usual_cases());
  }
  {
    const Parameters few("max_success=8");
    testing::add_parameters("max_success=300 noshrink=1");
    CHECK(std::string(std::getenv("RC_PARAMS")) == "max_success=8 seed=1 noshrink=1");
    CHECK(testing::draws_from_fixed_seed());
    CHECK_FALSE(testing::draws_usual_cases());
    CHECK(testing::cases(30, 7) == 7);
  }
  const Parameters nightly("seed=850856301254277102");
  testing::add_parameters("max_success=300");
  CHECK(std::string(std::getenv("RC_PARAMS")) == "seed=850856301254277102 max_success=300");
  CHECK_FALSE(testing::draws_from_fixed_seed());
}

TEST_CASE("a property's seed depends on suite seed and case and description and number") {
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t seed : {1U, 2U}) {
    for (const char* const name : {"a", "b"}) {
      testing::begin_case(name);
      for (const char* const description : {"", "c", "d"}) seeds.insert(testing::next_seed(seed, description));
    }
  }
  CHECK(seeds.size() == 12);
}
