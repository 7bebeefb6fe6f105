#include "host/emit/broadcast.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "sim/reference/reference_array.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace isa;

namespace {

constexpr isa::ArrayShape shape{4, 4, 4};
constexpr Field mask{0, 1};
constexpr Field bit{1, 1};
constexpr Field both{0, 2};
constexpr view::PixelRect all{0, 0, 3, 3};

isa::Segment empty_segment() {
  isa::Segment segment;
  segment.region = {0, 0, shape.width, shape.height};
  return segment;
}

/// Opcodes that `emit` leaves in a segment.
template <class Emit>
std::vector<Opcode> emitted(const Emit& emit) {
  isa::Segment segment = empty_segment();
  emit::Broadcast out(segment, {});
  emit(out);
  std::vector<Opcode> opcodes;
  for (const Instruction& instruction : segment.instructions) opcodes.push_back(instruction.opcode);
  return opcodes;
}

/// Uniform in [0, end) for any size of a test case.
template <class Number = int>
Number random_below(Number end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Number>(0, end));
}

/// One of few instructions on few bits, so that the same bit is used repeatedly.
Instruction random_instruction() {
  const auto any_bit = [] { return Field{random_below<std::uint16_t>(2), 1}; };
  switch (random_below(16)) {
    case 0: return {Opcode::enable_all, {}, {}, 0, {}};
    case 1: return {Opcode::enable_invert, {}, {}, 0, {}};
    case 2: return {Opcode::enable_and, {any_bit()}, {}, 0, {}};
    case 3: return {Opcode::enable_xor, {any_bit()}, {}, 0, {}};
    case 4: return {Opcode::set_constant, {any_bit()}, {}, random_below<std::uint64_t>(2), {}};
    case 5: return {Opcode::set_constant, {Field{1, 3}}, {}, random_below<std::uint64_t>(8), {}};
    case 6: return {Opcode::xor_constant, {Field{0, 2}}, {}, random_below<std::uint64_t>(4), {}};
    case 7: return {Opcode::copy, {Field{0, 2}, Field{2, 2}}, {}, 0, {}};
    case 8: return {Opcode::field_lt, {Field{0, 2}, Field{2, 2}}, {}, 0, {}};
    case 9: return {Opcode::global_or, {}, {}, 0, {}};
    case 10:
    case 11: return {Opcode::enable_store, {any_bit()}, {}, 0, {}};
    case 12: return {Opcode::add, {Field{0, 2}, Field{3, 1}}, {}, 0, {}};
    default: return {Opcode::enable_load, {any_bit()}, {}, 0, {}};
  }
}

/// Enable and memory of every pixel.
std::vector<std::uint32_t> state_of(const reference::ReferenceArray& array) {
  std::vector<std::uint32_t> state;
  for (std::uint32_t y = 0; y < shape.height; ++y) {
    for (std::uint32_t x = 0; x < shape.width; ++x) {
      state.push_back(array.is_enabled(x, y) ? 1 : 0);
      state.push_back(array.read({0, 4}, x, y));
    }
  }
  return state;
}

/// Every pixel starts with different memory, and half of the pixels are enabled.
reference::ReferenceArray initial_array() {
  reference::ReferenceArray array(shape);
  for (std::uint32_t i = 0; i < shape.width * shape.height; ++i) array.write({0, 4}, i % 4, i / 4, i);
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  array.execute({Opcode::edge_not_negative, {}, {1, 0, -2, 4, 0}, 0, {}});
  return array;
}

}  // namespace

TEST_CASE("instructions that load or store a bit that equals E are omitted") {
  CHECK(emitted([](emit::Broadcast& out) {
          out.plain(Opcode::enable_store, mask);
          out.plain(Opcode::enable_load, mask);
          out.plain(Opcode::enable_store, mask);
        }) == std::vector{Opcode::enable_store});
  CHECK(emitted([](emit::Broadcast& out) {
          out.plain(Opcode::enable_load, mask);
          out.plain(Opcode::set_constant, bit, {}, 1);
          out.plain(Opcode::enable_store, mask);
        }) == std::vector{Opcode::enable_load, Opcode::set_constant});
}

TEST_CASE("a bit is loaded if E or the bit has changed since they were equal") {
  CHECK(emitted([](emit::Broadcast& out) {
          out.plain(Opcode::enable_store, mask);
          out.edge(Opcode::edge_negative, {1, 0, -2}, all);
          out.plain(Opcode::enable_load, mask);
        }) == std::vector{Opcode::enable_store, Opcode::edge_negative, Opcode::enable_load});
  CHECK(emitted([](emit::Broadcast& out) {
          out.plain(Opcode::enable_store, mask);
          out.plain(Opcode::set_constant, both, {}, 2);
          out.plain(Opcode::enable_load, mask);
        }) == std::vector{Opcode::enable_store, Opcode::set_constant, Opcode::enable_load});
}

TEST_CASE("after a query no bit is assumed equal to E because a skip may end there") {
  CHECK(emitted([](emit::Broadcast& out) {
          out.plain(Opcode::enable_load, bit);
          out.plain(Opcode::enable_store, mask);
          out.insert(1, {Opcode::skip_if_none, {}, {}, 1, {}});
          out.plain(Opcode::enable_load, mask);
        }) == std::vector{Opcode::enable_load, Opcode::skip_if_none, Opcode::enable_store, Opcode::enable_load});
}

TEST_CASE("the optimized broadcast instructions have the effect of the requested ones") {
  CHECK(rc::check([] {
    reference::ReferenceArray requested = initial_array();
    isa::Segment segment = empty_segment();
    emit::Broadcast out(segment, {});
    const int count = 1 + random_below(60);
    for (int i = 0; i < count; ++i) {
      const Instruction instruction = random_instruction();
      requested.execute(instruction);
      out.plain(instruction.opcode, instruction.fields[0], instruction.fields[1], instruction.constant);
    }
    reference::ReferenceArray broadcast = initial_array();
    for (const Instruction& instruction : segment.instructions) broadcast.execute(instruction);
    RC_ASSERT(state_of(broadcast) == state_of(requested));
  }));
}
