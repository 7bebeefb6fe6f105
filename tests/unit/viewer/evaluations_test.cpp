#include "sim/viewer/evaluations.h"

#include <chrono>
#include <thread>

#include "hw/base/interruption.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace std::chrono_literals;
using viewer::EndReason;
using viewer::Stage;

namespace {

bool is_interrupted() {
  try {
    throw_if_interrupted();
  } catch (const Interrupted&) {
    return true;
  }
  return false;
}

}  // namespace

TEST_CASE("an evaluation is cancelled only by its own name and not if it has none") {
  viewer::Evaluations all(1h);
  viewer::Evaluation one(all, "one");
  all.cancel("two");
  all.cancel("");
  CHECK_FALSE(is_interrupted());
  CHECK(one.end_reason() == EndReason::not_yet);
  all.cancel("one");
  CHECK(is_interrupted());
  CHECK(one.end_reason() == EndReason::cancelled);
  std::thread([&] {
    const viewer::Evaluation unnamed(all, "");
    all.cancel("");
    CHECK_FALSE(is_interrupted());
    CHECK(unnamed.end_reason() == EndReason::not_yet);
  }).join();
}

TEST_CASE("only evaluations have a time limit and each one restarts it") {
  viewer::Evaluations all(20ms);
  viewer::Evaluation one(all, "one");
  const auto is_overdue_after = [&](Stage doing, std::chrono::milliseconds time) {
    one.begin(doing);
    std::this_thread::sleep_for(time);
    all.end_overdue();
    return one.end_reason() == EndReason::overdue;
  };
  CHECK_FALSE(is_overdue_after(Stage::waiting, 40ms));
  CHECK_FALSE(is_overdue_after(Stage::evaluating, 0ms));
  CHECK_FALSE(is_overdue_after(Stage::drawing, 40ms));
  CHECK_FALSE(is_overdue_after(Stage::evaluating, 0ms));
  CHECK_FALSE(is_interrupted());
  CHECK(is_overdue_after(Stage::evaluating, 40ms));
  CHECK(is_interrupted());
  // The first reason is kept.
  all.cancel("one");
  CHECK(one.end_reason() == EndReason::overdue);
}

TEST_CASE("closing the evaluations interrupts current and later ones") {
  viewer::Evaluations all(1h);
  {
    const viewer::Evaluation before(all, "");
    all.close();
    CHECK(is_interrupted());
    CHECK(before.end_reason() == EndReason::closed);
  }
  CHECK_FALSE(is_interrupted());
  const viewer::Evaluation behind(all, "");
  CHECK(is_interrupted());
}

TEST_CASE("the progress of an evaluation has the activity and its duration and the limit") {
  viewer::Evaluations all(4s);
  CHECK(all.progress("one") == viewer::Json::object());
  viewer::Evaluation one(all, "one");
  CHECK(all.progress("") == viewer::Json::object());
  CHECK(all.progress("one")["doing"] == "waiting");
  CHECK_FALSE(all.progress("one").contains("most"));
  one.begin(Stage::evaluating);
  CHECK(all.progress("one")["doing"] == "evaluating the model");
  CHECK(all.progress("one")["most"] == 4);
  CHECK(all.progress("one")["seconds"] < 4);
  one.begin(Stage::drawing);
  CHECK(all.progress("one")["doing"] == "drawing");
  CHECK_FALSE(all.progress("one").contains("most"));
}
