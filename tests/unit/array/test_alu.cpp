#include <hwy/targets.h>

#include "hw/array/kernels.h"
#include "hw/array/pixel_array.h"
#include "hw/array/plane.h"
#include "tests/support/plain_array.h"
#include "tests/support/test.h"

namespace {

using csgsim::array::AluFunction;
using csgsim::array::AluInfo;
using csgsim::array::ArrayStep;
using csgsim::array::OperandSource;
using csgsim::array::PixelArray;
using csgsim::array::PixelProbe;
using csgsim::array::StreamBit;
using csgsim::array::Words;
using csgsim::test::PixelState;
namespace kernels = csgsim::array::kernels;

enum Address : std::uint16_t { x_bit, y_bit, written, always_0, scratch, memory_bits };

/// First bit of each register in a pixel's column number; the row decides whether the pixel is present.
enum Column : std::int16_t {
  column_x,
  column_y,
  column_enable,
  column_carry,
  column_latch,
  column_memory,
  column_flag,
  registers
};

constexpr std::uint32_t states = 1U << registers;

StreamBit column_bit(std::int16_t bit) { return {.token = {bit}, .a = 1}; }

/// One pixel for every combination of operands and registers; pixels of the second row are not present.
PixelArray all_states() {
  PixelArray array({states, 2, memory_bits}, 1);
  array.reset(states, 1);
  const StreamBit one{.token = {.bit = 0}, .c = 1};
  array.step({.function = AluFunction::enable_load}, one);
  array.step({.function = AluFunction::store_x, .write = x_bit}, column_bit(column_x));
  array.step({.function = AluFunction::store_x, .write = y_bit}, column_bit(column_y));
  array.step({.function = AluFunction::store_x, .write = written}, column_bit(column_memory));
  array.step({.function = AluFunction::store_not_x, .write = scratch}, column_bit(column_flag));
  array.step({.function = AluFunction::compare_from_0, .source = OperandSource::memory, .x = scratch, .y = always_0},
             {});
  array.step({.function = AluFunction::root_first, .write = scratch}, {});
  array.step({.function = AluFunction::compare_from_0, .y = always_0}, column_bit(column_carry));
  array.step({.function = AluFunction::latch_x}, column_bit(column_latch));
  array.step({.function = AluFunction::enable_load}, column_bit(column_enable));
  return array;
}

PixelState state_of(std::uint32_t x, std::uint32_t y) {
  const auto bit = [x](unsigned of) { return (x >> of & 1U) != 0; };
  return {.x = bit(column_x),
          .y = bit(column_y),
          .present = y == 0,
          .enable = bit(column_enable),
          .carry = bit(column_carry),
          .latch = bit(column_latch),
          .flag = bit(column_flag),
          .memory = bit(column_memory)};
}

/// State after a step that leaves the operands unchanged.
PixelState state_in(const PixelArray& array, std::uint32_t x, std::uint32_t y, PixelState before) {
  const PixelProbe probe = array.probe(x, y, {});
  before.enable = probe.enable;
  before.carry = probe.carry;
  before.latch = probe.latch != 0;
  before.flag = probe.flag;
  before.memory = array.memory_bit(written, x, y);
  return before;
}

bool all_match(const PixelArray& array, AluFunction function, bool constant) {
  bool right = true;
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < states; ++x) {
      const PixelState before = state_of(x, y);
      right = right && state_in(array, x, y, before) == csgsim::test::next_state(function, constant, before);
    }
  }
  return right;
}

/// Checks each function on pixels in all states.
void check_functions() {
  for (std::size_t row = 0; row < std::size(csgsim::array::alu_table); ++row) {
    const auto function = static_cast<AluFunction>(row);
    CAPTURE(std::string(csgsim::array::info(function).name));
    for (const bool probe_first : {false, true}) {
      for (const bool constant : {false, true}) {
        for (const OperandSource source : {OperandSource::memory, OperandSource::tree}) {
          PixelArray array = all_states();
          if (probe_first) REQUIRE(array.probe(0, 0, {}).carry == state_of(0, 0).carry);
          const ArrayStep step{.function = function,
                               .source = source,
                               .x = x_bit,
                               .y = y_bit,
                               .write = written,
                               .constant = constant ? 1U : 0U};
          array.step(step, column_bit(column_x));
          CHECK(all_match(array, csgsim::array::function_of_bit(step, 0), constant));
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("every ALU function matches its truth table on every vector target") {
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    const std::int64_t target = left & -left;
    CAPTURE(std::string(hwy::TargetName(target)));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    check_functions();
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
}

TEST_CASE("array kernels count ones and find the blocks that contain any") {
  Words plane(24);
  std::vector<std::uint8_t> flags(3, 1);
  CHECK(kernels::count_ones(plane.data(), plane.size()) == 0);
  CHECK_FALSE(kernels::any_ones(plane.data(), plane.size()));
  kernels::find_ones(plane.data(), flags);
  CHECK(flags == std::vector<std::uint8_t>{0, 0, 0});
  for (std::size_t word = 0; word < plane.size(); ++word) {
    plane[word] = std::uint64_t{1} << (word * 2);
    CHECK(kernels::any_ones(plane.data(), plane.size()));
    CHECK(kernels::count_ones(plane.data(), plane.size()) == 1);
    kernels::find_ones(plane.data(), flags);
    for (std::size_t block = 0; block < flags.size(); ++block) CHECK((flags[block] != 0) == (block == word / 8));
    plane[word] = 0;
  }
  plane.assign(24, ~std::uint64_t{0});
  CHECK(kernels::count_ones(plane.data(), plane.size()) == 24 * 64);
}
