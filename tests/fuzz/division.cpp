// Display models in the form in which they are transferred. The first byte is the number of padding bits in the last
// one.

#include <algorithm>
#include <vector>

#include "hw/division/divide.h"
#include "hw/division/encoding.h"
#include "hw/isa/program.h"
#include "tests/fuzz/property.h"

namespace division = csgsim::division;
namespace fuzz = csgsim::fuzz;
namespace isa = csgsim::isa;

namespace {

division::Bits bits_of(const std::uint8_t* data, std::size_t size) {
  division::BitWriter out;
  if (size == 0) return out.take();
  const unsigned filled = data[0] % 8U;
  for (std::size_t i = 1; i < size; ++i) {
    const unsigned width = i + 1 < size ? 8U : 8U - filled;
    out.put(data[i] & (0xffU >> (8U - width)), width);
  }
  return out.take();
}

/// Checks that one level and two emit the same valid instructions for a square, for any model.
void check_divided(const division::DisplayModel& model) {
  const division::Divider divider(model);
  division::PlainDatapath path(model);
  const isa::Region square{0, 0, std::min(model.width, 8U), std::min(model.height, 8U)};
  const isa::Region group{0, 0, std::min(model.width, 32U), std::min(model.height, 32U)};
  const division::SquareDivision one = divider.divide(square, path);
  for (const isa::Instruction& instruction : one.instructions) isa::validate(instruction, isa::max_memory_bits);
  const division::DividedGroup two = division::divide_group(divider, group, {square}, 1'000'000, path);
  fuzz::require(two.squares[0].instructions == one.instructions, "two levels emit the instructions of one level");
}

}  // namespace

/// Any bits are the canonical stream of a valid model, or give one line of error; the divided model is valid.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const division::Bits bits = bits_of(data, size);
    const division::DisplayModel model = division::decode(bits);
    fuzz::require(division::encode(model) == bits, "a model has a single encoding");
    check_divided(model);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
  return 0;
}
