#include "sim/observe/long_work.h"

#include <ctime>

#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "places.h"
#include "sim/engine/engine.h"
#include "sim/observe/progress.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// CPU seconds of this process, independent of other load.
double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

using MakeEngine = std::unique_ptr<engine::Engine> (*)(const machines::Machine&);

/// Estimated total after a quarter of a real run, as a fraction of its actual duration. The run is scaled to four
/// seconds, and the first of these is waited for, however fast this computer is.
double estimate_ratio(const std::string& trace, const std::string& machine_name, MakeEngine make) {
  const isa::Program program = isa::load_program(std::string(CSGSIM_SOURCE_DIR) + "/traces/" + trace + ".csgt");
  machines::Machine machine = kinds::load(machine_name);
  machines::adopt_shape(machine, program);
  const double begin = processor_time();
  make(machine)->run(program, {});
  const double haste = 4 / (processor_time() - begin);
  const auto engine = make(machine);
  observe::LongWork work(
      "the run", "wait", [haste] { return haste * processor_time(); }, 0);
  observe::ProgressObserver observer(program, machine);
  observer.warn(work, false);
  std::vector<engine::Observer*> observers{&observer};
  engine->run(program, observers);
  const double took = work.elapsed();
  REQUIRE(work.announced_seconds().has_value());
  REQUIRE(took > 1.5);
  return *work.announced_seconds() / took;
}

}  // namespace

TEST_CASE("the estimated time of a reference-level run is within a factor of two") {
  const double ratio = estimate_ratio("thesis_fig_2_3", "pixel-planes-4", engine::make_reference_engine);
  MESSAGE("estimate / actual:  ", ratio);
  CHECK(ratio > 0.5);
  CHECK(ratio < 2);
}

TEST_CASE("the estimated time of a cycle-level run is within a factor of two") {
  const double ratio = estimate_ratio("terrain_vehicle", "pixel-planes-4", engine::make_cycle_engine);
  MESSAGE("estimate / actual:  ", ratio);
  CHECK(ratio > 0.5);
  CHECK(ratio < 2);
}

TEST_CASE("a warning of long work is printed once and only for long work") {
  double now = 0;
  observe::LongWork work(
      "this study", "take less", [&now] { return now; }, 60);
  now = 5;
  work.record_fraction(0.1);
  CHECK_FALSE(work.announced_seconds().has_value());
  now = 40;
  work.record_fraction(0.4);
  CHECK(work.announced_seconds() == 100.0);
  now = 90;
  work.record_fraction(0.5);
  CHECK(work.announced_seconds() == 100.0);
}
