#include "sim/observe/progress.h"

#include <unistd.h>

#include <chrono>
#include <thread>

#include "hw/isa/opcodes.h"
#include "hw/pixel_planes/kind.h"
#include "tests/support/captured.h"
#include "tests/support/test.h"
#include "tests/unit/observe/fake_pixels.h"

using namespace csgsim;
using namespace isa;

namespace {

const Instruction plain{Opcode::enable_all, {}, {}, 0, {}};
const Instruction skips_100{Opcode::skip_if_none, {}, {}, 100, {}};

/// 356 instructions of one clock each; the first skips 100.
isa::Program program() {
  isa::Program program;
  program.shape = {1, 1, 8};
  program.segments = {{{0, 0, 1, 1}, std::vector<Instruction>(356, plain)}};
  program.segments[0].instructions[0] = skips_100;
  return program;
}

machines::Machine machine() {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = {1, 1, 8};  // no tree levels, so that a query takes one clock
  return machine;
}

using Clock = std::chrono::steady_clock;

/// Executes `count` instructions; the first finds `enabled` pixels.
void carry_out(observe::ProgressObserver& observer, std::uint32_t count, const Instruction& first,
               std::uint64_t enabled) {
  const testing::FakePixels pixels({0, 0, 1, 1});
  for (std::uint32_t i = 0; i < count; ++i)
    observer.after_instruction({0, i, i == 0 ? first : plain, 1, enabled}, pixels);
}

}  // namespace

TEST_CASE("a run of less than a second prints no progress") {
  const testing::Captured standard_error(STDERR_FILENO);
  const Clock::time_point begin = Clock::now();
  {
    const isa::Program all = program();
    const machines::Machine on = machine();
    observe::ProgressObserver observer(all, on);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    carry_out(observer, 128, plain, 1);
  }
  // A busy computer may have taken a second.
  if (Clock::now() - begin < std::chrono::seconds(1)) CHECK(standard_error.text().empty());
}

TEST_CASE("a run of more than a second prints progress and erases it at its end") {
  const testing::Captured standard_error(STDERR_FILENO);
  const isa::Program all = program();
  const machines::Machine on = machine();
  std::optional<observe::ProgressObserver> observer;
  observer.emplace(all, on);
  std::this_thread::sleep_for(std::chrono::milliseconds(1050));
  const Clock::time_point begin = Clock::now();
  carry_out(*observer, 89, skips_100, 1);
  std::string printed = standard_error.text();
  CHECK(printed.starts_with("\r\x1b[K 18.0 %  64 of 356 clocks  "));
  CHECK(printed.find(" clocks/s  ") != std::string::npos);
  CHECK(printed.ends_with(" s left"));
  carry_out(*observer, 64, plain, 1);
  if (Clock::now() - begin < std::chrono::milliseconds(250)) CHECK(standard_error.text() == printed);
  printed = standard_error.text();
  observer.reset();
  CHECK(standard_error.text() == printed + "\r\x1b[K");
}

TEST_CASE("skipped instructions reduce the remaining clocks of the progress display") {
  const testing::Captured standard_error(STDERR_FILENO);
  const isa::Program all = program();
  const machines::Machine on = machine();
  observe::ProgressObserver observer(all, on);
  std::this_thread::sleep_for(std::chrono::milliseconds(1050));
  carry_out(observer, 64, skips_100, 0);
  CHECK(standard_error.text().starts_with("\r\x1b[K 25.0 %  64 of 256 clocks  "));
}
