#include "hw/base/interruption.h"

#include <stop_token>
#include <thread>

#include "hw/base/work.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("work that nobody asked to stop goes on") {
  CHECK_NOTHROW(end_if_interrupted());
  std::stop_source source;
  const Interruptible looks_for(source.get_token());
  CHECK_NOTHROW(end_if_interrupted());
  CHECK_NOTHROW(Work(10).charge(1, "nothing"));
}

TEST_CASE("work ends at its next step when it is asked to stop, as does that without a limit") {
  std::stop_source source;
  const Interruptible looks_for(source.get_token());
  source.request_stop();
  CHECK_THROWS_AS(end_if_interrupted(), Interrupted);
  CHECK_THROWS_AS(Work(10).charge(1, "nothing"), Interrupted);
  CHECK_THROWS_AS(Work().charge(1, "nothing"), Interrupted);
}

TEST_CASE("the innermost is looked for, and the outer one after it") {
  std::stop_source outer;
  const Interruptible looks_for(outer.get_token());
  outer.request_stop();
  {
    const std::stop_source inner;
    const Interruptible looks_for_another(inner.get_token());
    CHECK_NOTHROW(end_if_interrupted());
  }
  CHECK_THROWS_AS(end_if_interrupted(), Interrupted);
}

TEST_CASE("other threads are not asked") {
  std::stop_source source;
  const Interruptible looks_for(source.get_token());
  source.request_stop();
  std::jthread([] { CHECK_NOTHROW(end_if_interrupted()); }).join();
}
