#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "hw/isa/text.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/columns.h"

using namespace csgsim;
using bit_serial_memory::micro_program;
using testing::Columns;

namespace {

constexpr isa::ArrayShape shape{9, 7, 40};

std::string name_of(const bit_serial_memory::MicroDesign& design) {
  return fmt::format("{}, {}{}", bit_serial_memory::design_names[static_cast<std::size_t>(design.design)],
                     bit_serial_memory::expression_names[static_cast<std::size_t>(design.expressions)],
                     design.enable_latch ? ", with a latch for writes" : "");
}

reference::ReferenceArray random_pixels(const isa::ArrayShape& array) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  reference::ReferenceArray pixels(array);
  for (std::uint32_t y = 0; y < array.height; ++y) {
    for (std::uint32_t x = 0; x < array.width; ++x) {
      pixels.write_enable(x, y, random() % 3 > 0);
      for (std::uint32_t bit = 0; bit < array.memory_bits; ++bit)
        pixels.write({static_cast<std::uint16_t>(bit), 1}, x, y, random() % 2);
    }
  }
  return pixels;
}

void require_equal(const Columns& columns, const reference::ReferenceArray& pixels, const isa::ArrayShape& array) {
  for (std::uint32_t y = 0; y < array.height; ++y) {
    for (std::uint32_t x = 0; x < array.width; ++x) {
      RC_ASSERT(columns.enabled(x, y) == pixels.is_enabled(x, y));
      for (std::uint32_t bit = 0; bit < array.memory_bits; ++bit)
        RC_ASSERT(columns.memory_bit(bit, x, y) == (pixels.read({static_cast<std::uint16_t>(bit), 1}, x, y) != 0));
    }
  }
}

}  // namespace

TEST_CASE("row commands of any instruction match the reference in every column") {
  for (const bit_serial_memory::MicroDesign& design : testing::all_designs()) {
    CAPTURE(name_of(design));
    CHECK(rc::check("the commands match the reference on " + name_of(design), [&] {
      const isa::Instruction instruction = *test::arbitrary_instruction(shape, shape.memory_bits, 1);
      RC_LOG(std::string(isa::name_of(instruction.opcode)));
      reference::ReferenceArray pixels = random_pixels(shape);
      Columns columns(shape, design);
      columns.set(pixels);
      columns.execute(micro_program(instruction, columns.map(), design), instruction.linear);
      pixels.execute(instruction);
      require_equal(columns, pixels, shape);
    }));
  }
}

TEST_CASE("roots of every width match the reference on every design of a memory") {
  constexpr isa::ArrayShape array{13, 5, 62};
  for (const bit_serial_memory::MicroDesign& design : testing::all_designs()) {
    CAPTURE(name_of(design));
    CHECK(rc::check("the commands match the reference on " + name_of(design), [&] {
      const auto width = static_cast<std::uint16_t>(2 * *rc::gen::inRange(1, 31) + 1);
      const auto base = static_cast<std::uint16_t>(*rc::gen::inRange(0, 63 - width));
      const isa::Instruction root{.opcode = isa::Opcode::root, .fields = {{{base, width}}}};
      reference::ReferenceArray pixels = random_pixels(array);
      Columns columns(array, design);
      columns.set(pixels);
      columns.execute(micro_program(root, columns.map(), design), {});
      pixels.execute(root);
      require_equal(columns, pixels, array);
    }));
  }
}
