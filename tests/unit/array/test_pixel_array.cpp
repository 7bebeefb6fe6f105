#include "hw/array/pixel_array.h"
#include "tests/support/test.h"

using csgsim::array::AluFunction;
using csgsim::array::ArrayStep;
using csgsim::array::OperandSource;
using csgsim::array::PixelArray;
using csgsim::array::PixelProbe;
using csgsim::array::StreamBit;

TEST_CASE("probe() returns the registers of a pixel and all bits of a wide ALU latch") {
  constexpr unsigned alu_bits = 4;
  PixelArray array({70, 3, 16}, alu_bits);
  array.reset(70, 3);
  StreamBit tree;
  array.step({.function = AluFunction::enable_all}, tree);
  // Latches 1101 in the pixels whose leaf is 1.
  tree = {.token = {.bit = 7},
          .a = 1,
          .b = 1,
          .c = 60};  // x + y + 60 is 128 at the probed pixel, and less to its left and above
  array.step({.function = AluFunction::enable_load, .source = OperandSource::tree}, tree);
  array.step({.function = AluFunction::store_constant, .write = 5, .bits = alu_bits, .constant = 0b1101}, tree);
  array.step({.function = AluFunction::latch_x, .source = OperandSource::memory, .x = 5, .bits = alu_bits}, tree);
  const PixelProbe probe = array.probe(66, 2, tree);
  CHECK(probe.latch == 0b1101);
  CHECK(probe.enable);
  CHECK(probe.tree);
  const PixelProbe beside = array.probe(65, 2, tree);
  CHECK(beside.latch == 0);
  CHECK_FALSE(beside.enable);
  CHECK_FALSE(beside.tree);
}
