#include "sim/functional/root_kernels.h"

#include "tests/support/quadric_judge.h"
#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;

TEST_CASE("roots of every width are taken at exactly the enabled pixels") {
  CHECK(rc::check([] {
    const unsigned w = between(1U, 31U);
    const functional::TileShape shape = any_shape();
    std::vector<std::unique_ptr<functional::TileBits>> planes;
    std::vector<functional::TileBits*> field;
    std::vector<Bits> bits;
    for (unsigned bit = 0; bit < 2 * w + 1; ++bit) {
      field.push_back(planes.emplace_back(std::make_unique<functional::TileBits>()).get());
      bits.push_back(set_random(*field.back(), shape));
    }
    functional::TileBits enable;
    const Bits enabled = set_random(enable, shape);
    engine::Work work;
    functional::execute_root({enable, shape, functional::Decide::by_block, work}, field);
    std::vector<Bits> after;
    for (const functional::TileBits* plane : field) after.push_back(bits_of(*plane, shape));
    const auto value = [&](const std::vector<Bits>& of, std::uint32_t x, std::uint32_t y) {
      std::uint64_t number = 0;
      for (std::size_t bit = 0; bit < of.size(); ++bit) number |= std::uint64_t{of[bit].at(x, y) != 0} << bit;
      return number;
    };
    enabled.each([&](std::uint32_t x, std::uint32_t y) {
      const std::uint64_t before = value(bits, x, y);
      RC_ASSERT(value(after, x, y) == (enabled.at(x, y) != 0 ? test::root_field(before, w) : before));
    });
    RC_ASSERT(bits_of(enable, shape) == enabled);
  }));
}

TEST_CASE("roots are exact for extreme values and near squares") {
  for (unsigned w = 1; w <= 30; ++w) {
    CAPTURE(w);
    const std::vector<std::uint64_t> values = test::extreme_squares(w);
    REQUIRE(values.size() <= functional::block_pixels);
    const functional::TileShape shape(8, 8);
    std::vector<std::unique_ptr<functional::TileBits>> planes;
    std::vector<functional::TileBits*> field;
    for (unsigned bit = 0; bit < 2 * w + 1; ++bit) {
      field.push_back(planes.emplace_back(std::make_unique<functional::TileBits>()).get());
      std::uint64_t word = 0;
      for (std::size_t i = 0; i < values.size(); ++i) word |= (values[i] >> bit & 1U) << i;
      field.back()->set_word(0, word, shape);
    }
    functional::TileBits enable;
    enable.fill(shape);
    engine::Work work;
    functional::execute_root({enable, shape, functional::Decide::by_block, work}, field);
    for (std::size_t i = 0; i < values.size(); ++i) {
      CAPTURE(values[i]);
      std::uint64_t number = 0;
      for (std::size_t bit = 0; bit < field.size(); ++bit) number |= (field[bit]->word(0, shape) >> i & 1U) << bit;
      CHECK(number == test::root_field(values[i], w));
    }
  }
}
