#include "host/emit/layout.h"

#include <rapidcheck.h>

#include "hw/isa/field_role.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::string refusal(const emit::Needs& needs, std::uint32_t memory_bits) {
  return testing::error_of([&] { emit::plan_layout(needs, memory_bits); });
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("fields of a layout are contiguous and have the requested total width") {
  CHECK(rc::check([] {
    const unsigned z_bits = *rc::gen::inRange(4U, 31U);
    const emit::Needs needs{z_bits,
                            *rc::gen::inRange(3U, 25U),
                            *rc::gen::arbitrary<bool>(),
                            {*rc::gen::inRange(0U, 9U), *rc::gen::inRange(0U, 2U), *rc::gen::inRange(0U, 5U),
                             2 * z_bits * *rc::gen::inRange(0U, 7U)}};
    const unsigned total = emit::total_bits(needs);
    unsigned next = 0;
    for (const isa::NamedField& named : emit::named_fields(emit::plan_layout(needs, total))) {
      RC_ASSERT(named.field.base == next);
      next += named.field.width;
    }
    RC_ASSERT(next == total);
    RC_ASSERT(!refusal(needs, total - 1).empty());
  }));
}

TEST_CASE("the error for too little memory states the missing bits and options that help") {
  const std::string second = refusal({20, 24, true, {2, 1, 0}}, 72);
  CHECK(contains(second, "needs 92 memory bits a pixel (2 x 20 depth, 2 x 24 colour, 1 mask, 1 product, 2 stack)"));
  CHECK(contains(second, "--colouring rebroadcast"));
  CHECK(contains(second, "--z-bits 10"));
  CHECK(contains(second, "--colour-bits 14"));
  CHECK(contains(second, "--memory-bits 92"));
  CHECK_FALSE(contains(second, "--strategy"));

  const std::string deep = refusal({20, 24, false, {9, 0, 0}}, 72);
  CHECK(contains(deep, "--strategy list or auto"));
  CHECK(contains(deep, "--z-bits 19"));
  CHECK_FALSE(contains(deep, "--colouring"));

  const std::string tiny = refusal({20, 24, false, {}}, 10);
  CHECK_FALSE(contains(tiny, "--z-bits"));
  CHECK_FALSE(contains(tiny, "--colour-bits"));
  CHECK(contains(tiny, "--memory-bits 65"));
}

TEST_CASE("each option suggested by the error for too little memory is sufficient") {
  const std::uint32_t memory = 72;
  const std::string advice = refusal({25, 24, false, {1, 0, 0}}, memory);
  REQUIRE(contains(advice, "--z-bits 23"));
  CHECK(refusal({23, 24, false, {1, 0, 0}}, memory).empty());
  REQUIRE(contains(advice, "--colour-bits 20"));
  CHECK(refusal({25, 20, false, {1, 0, 0}}, memory).empty());
}

TEST_CASE("the error for too little memory counts a second buffer and says how to fit") {
  const emit::Needs fits{20, 15, false, {1, 0, 0}, {57, 15}};
  CHECK(emit::total_bits(fits) == 72);
  CHECK(emit::named_fields(emit::plan_layout(fits, 72)).back() ==
        isa::NamedField{"shown", {57, 15}, isa::FieldRole::shown});
  const std::string wide = refusal({20, 24, false, {1, 0, 0}, {48, 24}}, 72);
  CHECK(contains(wide, "needs 90 memory bits a pixel (2 x 20 depth, 24 colour, 1 mask, 1 stack, 24 displayed colour)"));
  CHECK(contains(wide, "--colour-bits 15"));
  CHECK(contains(wide, "take a machine whose scan_out.buffers is 1"));
  CHECK(contains(wide, "--memory-bits 90"));
}