#include <rapidcheck.h>

#include "hw/bit_serial_memory/column_logic.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/columns.h"

// No instruction multiplies. This multiplication is composed of the operations of instructions to compare it with
// published counts: MIMDRAM's and SIMDRAM's program for n bits (CMU-SAFARI/MIMDRAM, microworkloads/11_multu-plus.c)
// yields 2n bits with 11 n^2 - 5 n - 1 commands; PIMeval's table lists n bits with n^2 + n reads, (n^2 + n) / 2 writes
// and 2 n^2 + n logic commands.

using namespace csgsim;
using bit_serial_memory::BinaryOp;
using bit_serial_memory::Bit;
using bit_serial_memory::Chain;
using bit_serial_memory::ColumnLogic;
using bit_serial_memory::Design;
using bit_serial_memory::Mask;
using bit_serial_memory::Row;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowMap;
using bit_serial_memory::RowOp;

namespace {

constexpr isa::ArrayShape shape{9, 7, 80};
constexpr unsigned most_bits = 16;
constexpr Row first_factor = 0;
constexpr Row second_factor = first_factor + most_bits;
constexpr Row product = second_factor + most_bits;

/// Long multiplication: adds the second factor at each place where the first has a 1.
class Multiplication {
 public:
  Multiplication(Design design, unsigned bits, unsigned product_bits, ColumnLogic& logic)
      : masked_(design == Design::latches), bits_(bits), product_bits_(product_bits), logic_(logic) {}

  void put() {
    put_first_place();
    for (unsigned place = 1; place < bits_; ++place) add_place(place);
  }

 private:
  [[nodiscard]] static Bit bit_of(Row field, unsigned bit) { return Bit::of_row(field + bit); }
  [[nodiscard]] static Row product_row(unsigned bit) { return static_cast<Row>(product + bit); }
  [[nodiscard]] Row partial() const { return logic_.map().scratch(0); }

  void put_first_place() {
    logic_.hold(first_factor);
    for (unsigned bit = 0; bit < bits_; ++bit)
      logic_.combine(BinaryOp::conjunction, product_row(bit), Bit::of_row(first_factor), bit_of(second_factor, bit));
    if (product_bits_ > bits_) logic_.assign(product_row(bits_), Bit::constant(false));
  }

  void add_place(unsigned place) {
    const Bit factor = bit_of(first_factor, place);
    if (masked_) logic_.set_enable(factor);
    logic_.begin_chain(Chain::sum, false);
    for (unsigned bit = 0; bit < bits_ && place + bit < product_bits_; ++bit) {
      const Row sum = product_row(place + bit);
      if (masked_) {
        logic_.store_sum(sum, bit_of(second_factor, bit), Bit::of_row(sum), Mask::enable);
      } else {
        logic_.combine(BinaryOp::conjunction, partial(), factor, bit_of(second_factor, bit));
        logic_.sum(sum, Bit::of_row(partial()), Bit::of_row(sum));
      }
    }
    if (place + bits_ < product_bits_) put_carry(product_row(place + bits_));
  }

  void put_carry(Row row) {
    if (!masked_) return logic_.assign_chain(row, false);
    logic_.narrow_by_chain(false);
    logic_.store_enable(row);
  }

  const bool masked_;
  const unsigned bits_;
  const unsigned product_bits_;
  ColumnLogic& logic_;
};

RowCommands commands_of(Design design, unsigned bits, unsigned product_bits) {
  const RowMap map(shape.memory_bits, shape.width, shape.height);
  RowCommands commands;
  const std::unique_ptr<ColumnLogic> logic = make_column_logic(design, map, false, commands);
  Multiplication(design, bits, product_bits, *logic).put();
  return commands;
}

void check_product(Design design, unsigned bits, unsigned product_bits) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  reference::ReferenceArray pixels(shape);
  for (std::uint32_t y = 0; y < shape.height; ++y) {
    for (std::uint32_t x = 0; x < shape.width; ++x) {
      for (std::uint16_t bit = 0; bit < shape.memory_bits; ++bit) pixels.write({bit, 1}, x, y, random() % 2);
    }
  }
  testing::Columns columns(shape, {design, bit_serial_memory::Expressions::rows, false, false});
  columns.set(pixels);
  columns.execute(commands_of(design, bits, product_bits), {});
  const auto width = static_cast<std::uint16_t>(bits);
  for (std::uint32_t y = 0; y < shape.height; ++y) {
    for (std::uint32_t x = 0; x < shape.width; ++x) {
      const std::uint64_t right = pixels.read({first_factor, width}, x, y) * pixels.read({second_factor, width}, x, y);
      for (unsigned bit = 0; bit < product_bits; ++bit)
        RC_ASSERT(columns.memory_bit(product + bit, x, y) == ((right >> bit & 1U) != 0));
    }
  }
}

constexpr std::array designs{Design::and_or_not, Design::majority, Design::latches};

}  // namespace

TEST_CASE("a multiplication built from operations gives the product in every column") {
  for (const Design design : designs) {
    CAPTURE(bit_serial_memory::design_names[static_cast<std::size_t>(design)]);
    CHECK(rc::check([&] {
      const auto bits = *rc::gen::inRange(1U, most_bits + 1);
      check_product(design, bits, bits * *rc::gen::inRange(1U, 3U));
    }));
  }
}

TEST_CASE("a majority product takes n(n - 1) commands more than SIMDRAM's") {
  for (unsigned n = 1; n <= most_bits; ++n) {
    const std::size_t theirs = 11 * n * n - 5 * n - 1;
    CHECK(commands_of(Design::majority, n, 2 * n).size() == theirs + n * (n - 1));
  }
}

TEST_CASE("an AND-OR-NOT product of 2n bits takes 30n(n - 1) + 6n - 1 commands") {
  for (unsigned n = 1; n <= most_bits; ++n)
    CHECK(commands_of(Design::and_or_not, n, 2 * n).size() == 30 * n * (n - 1) + 6 * n - 1);
}

TEST_CASE("a sense-amplifier product takes PIMeval's rows and n - 1 more logic commands") {
  for (unsigned n = 1; n <= most_bits; ++n) {
    const RowCommands commands = commands_of(Design::latches, n, n);
    CHECK(testing::count_of(RowOp::read, commands) == n * n + n);
    CHECK(testing::count_of(RowOp::write, commands) == (n * n + n) / 2);
    CHECK(testing::count_of(RowOp::logic, commands) == 2 * n * n + n + (n - 1));
  }
}
