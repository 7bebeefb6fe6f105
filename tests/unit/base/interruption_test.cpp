#include "hw/base/interruption.h"

#include <stop_token>
#include <thread>

#include "hw/base/work.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("work continues until a stop is requested") {
  CHECK_NOTHROW(throw_if_interrupted());
  std::stop_source source;
  const Interruptible interruptible(source.get_token());
  CHECK_NOTHROW(throw_if_interrupted());
  CHECK_NOTHROW(Work(10).charge(1, "nothing"));
}

TEST_CASE("a stop request interrupts limited and unlimited work at the next step") {
  std::stop_source source;
  const Interruptible interruptible(source.get_token());
  source.request_stop();
  CHECK_THROWS_AS(throw_if_interrupted(), Interrupted);
  CHECK_THROWS_AS(Work(10).charge(1, "nothing"), Interrupted);
  CHECK_THROWS_AS(Work().charge(1, "nothing"), Interrupted);
}

TEST_CASE("the innermost stop token applies until it is destroyed") {
  std::stop_source outer;
  const Interruptible interruptible(outer.get_token());
  outer.request_stop();
  {
    const std::stop_source inner;
    const Interruptible inner_interruptible(inner.get_token());
    CHECK_NOTHROW(throw_if_interrupted());
  }
  CHECK_THROWS_AS(throw_if_interrupted(), Interrupted);
}

TEST_CASE("a stop request does not affect other threads") {
  std::stop_source source;
  const Interruptible interruptible(source.get_token());
  source.request_stop();
  std::jthread([] { CHECK_NOTHROW(throw_if_interrupted()); }).join();
}
