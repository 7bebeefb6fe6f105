#include "hw/multi_processor/list_renderer.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/kind.h"
#include "sim/engine/met_recorder.h"
#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using multi_processor::Figures;
using multi_processor::NodePixels;

namespace {

constexpr unsigned slice_bits = 32;

std::uint32_t below(std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); }

machines::Machine any_machine() {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  machine.array = {1 + below(4), 1 + below(4), 8 + below(92)};
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.order = static_cast<multi_processor::RenderingOrder>(below(3));
  figures.word_bits = 1 + below(64);
  figures.operations = {below(20), below(20), below(20), below(20), below(20), below(90), below(9), below(3)};
  figures.field_clocks = below(2) == 0 ? multi_processor::unpacked : below(30);
  figures.branches = {static_cast<multi_processor::Branches>(below(2)), below(20), below(20)};
  figures.chain = {static_cast<multi_processor::NodeProgram>(below(2)), below(60), below(40)};
  figures.loop = {below(20), below(40), below(60)};
  return machine;
}

std::vector<isa::Instruction> any_list(const isa::Region& region, std::uint32_t memory_bits) {
  const isa::ArrayShape shape{region.width, region.height, memory_bits};
  std::vector<isa::Instruction> list;
  const std::uint32_t count = below(15);
  while (list.size() < count) {
    const isa::Instruction one = *test::arbitrary_instruction(shape, memory_bits, 0);
    if (!isa::needs_global_or(one.opcode)) list.push_back(one);
    if (below(4) == 0) list.push_back(isa::Instruction{.opcode = isa::Opcode::enable_all});
  }
  return list;
}

/// Compares the node's pixels with the reference's.
void check_pixels(const multi_processor::PixelMemory& memory, const NodePixels& own, const isa::ArrayShape& nodes,
                  const reference::ReferenceArray& reference) {
  for (std::size_t pixel = 0; pixel < own.count(); ++pixel) {
    const auto x = own.first_x + static_cast<std::uint32_t>(pixel % own.columns) * nodes.width;
    const auto y = own.first_y + static_cast<std::uint32_t>(pixel / own.columns) * nodes.height;
    RC_ASSERT(memory.enabled(pixel) == reference.is_enabled(x, y));
    for (std::uint32_t base = 0; base < nodes.memory_bits; base += slice_bits) {
      const isa::Field slice{static_cast<std::uint16_t>(base),
                             static_cast<std::uint16_t>(std::min(slice_bits, nodes.memory_bits - base))};
      RC_ASSERT(memory.read(pixel, slice) == reference.read(slice, x, y));
    }
  }
}

/// Compares each pixel's reported moments with the recorded states and the computed clocks.
void check_moments(const std::vector<std::vector<multi_processor::PixelMoment>>& moments,
                   const std::vector<multi_processor::NodeState>& steps, const std::vector<isa::Instruction>& list,
                   const NodePixels& own, const machines::PixelActivity* pixel_activity,
                   const machines::Machine& machine) {
  const multi_processor::RenderingClocks clocks({.instructions = list, .pixel_activity = pixel_activity}, machine);
  for (std::uint32_t pixel = 0; pixel < moments.size(); ++pixel) {
    RC_ASSERT(moments[pixel].size() == list.size());
    const auto spans = clocks.spans_at(own, pixel % own.columns, pixel / own.columns);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const multi_processor::PixelMoment& moment = moments[pixel][i];
      RC_ASSERT(moment.index == i);
      RC_ASSERT(moment.clocks == spans[i]);
      RC_ASSERT(moment.after.enabled(0) == steps[i].pixels.enabled(pixel));
      const isa::Field first{0, 8};
      RC_ASSERT(moment.after.read(0, first) == steps[i].pixels.read(pixel, first));
    }
  }
}

/// Returns the pixels that the list enables in the reference; empty for nodes that do not branch.
std::vector<machines::PixelActivity> enabled_pixels(const std::vector<isa::Instruction>& list,
                                                    const isa::Region& region, const machines::Machine& machine) {
  isa::Program program;
  program.segments.push_back({region, list});
  engine::PixelActivityRecorder recorder(program, machine);
  reference::ReferenceArray reference(region, machine.array.memory_bits);
  for (std::uint32_t i = 0; i < list.size(); ++i) {
    recorder.before({0, i}, list[i], reference);
    reference.execute(list[i]);
    recorder.after({0, i}, list[i], reference);
  }
  return *recorder.pixel_activity();
}

}  // namespace

TEST_CASE("nodes match the reference after every instruction in the computed clocks") {
  CHECK(rc::check([] {
    const machines::Machine machine = any_machine();
    const isa::Region region{below(9), below(9), 1 + below(10), 1 + below(10)};
    const std::vector<isa::Instruction> list = any_list(region, machine.array.memory_bits);
    if (list.empty()) return;
    const std::vector<systemc::Keep> keeps(list.size(), systemc::Keep::all);
    const isa::Field colour{0, static_cast<std::uint16_t>(1 + below(8))};
    const std::vector<machines::PixelActivity> all_met = enabled_pixels(list, region, machine);
    const machines::PixelActivity* const pixel_activity = all_met.empty() ? nullptr : all_met.data();
    for (std::uint32_t node = 0; node < machine.array.width * machine.array.height; ++node) {
      const NodePixels own = multi_processor::pixels_of_node(region, machine.array, node / machine.array.width,
                                                             node % machine.array.width);
      multi_processor::ListRenderer renderer(machines::kind_figures<Figures>(machine), machine.array, list, {}, keeps,
                                             own, {});
      std::vector<std::vector<multi_processor::PixelMoment>> moments(own.count());
      for (std::size_t pixel = 0; pixel < own.count(); ++pixel) renderer.watch(pixel, moments[pixel]);
      renderer.render();
      check_moments(moments, renderer.steps(), list, own, pixel_activity, machine);
      reference::ReferenceArray reference(region, machine.array.memory_bits);
      for (std::size_t i = 0; i < list.size(); ++i) {
        reference.execute(list[i]);
        check_pixels(renderer.steps()[i].pixels, own, machine.array, reference);
        if (own.count() > 0) RC_ASSERT(renderer.steps()[i].clocks == multi_processor::pixel_clocks(list[i], machine));
      }
      RC_ASSERT(renderer.store_colours(colour).size() == own.count());
      const auto clocks = [&](const machines::PixelActivity* pixels) {
        return multi_processor::RenderingClocks({.instructions = list, .pixel_activity = pixels}, machine)
            .all(own, colour);
      };
      RC_ASSERT(renderer.clocks() == clocks(pixel_activity));
      RC_ASSERT(renderer.clocks() <= clocks(nullptr));
      RC_ASSERT(static_cast<double>(clocks(nullptr)) <=
                multi_processor::max_rendering_clocks(list, region, {}, machine));
    }
  }));
}

TEST_CASE("nodes add with carries and cut sums into stripes like the reference") {
  CHECK(rc::check([] {
    using isa::Opcode;
    machines::Machine machine = any_machine();
    machine.array.memory_bits = 24;
    const isa::Region region{0, 0, 9, 7};
    const isa::Instruction all{.opcode = Opcode::enable_all};
    const auto step = [] { return std::int64_t{below(20)}; };
    const isa::Linear first{.a = step(), .b = step(), .c = step(), .width = 10};
    const isa::Linear second{.a = step(), .b = step(), .c = step(), .width = 10};
    const std::vector<isa::Instruction> list{
        all,
        {.opcode = Opcode::load_linear, .fields = {isa::Field{0, 9}}, .linear = first},
        all,
        {.opcode = Opcode::load_linear, .fields = {isa::Field{9, 9}}, .linear = second},
        all,
        {.opcode = Opcode::stripe, .linear = {.a = 1 + step(), .b = step(), .width = 4}},
        {.opcode = Opcode::add, .fields = {isa::Field{0, 9}, isa::Field{9, 9}}},
        {.opcode = Opcode::add, .fields = {isa::Field{0, 7}, isa::Field{10, 3}}}};
    const std::vector<systemc::Keep> keeps(list.size(), systemc::Keep::all);
    const NodePixels own = multi_processor::pixels_of_node(region, machine.array, 0, 0);
    multi_processor::ListRenderer renderer(machines::kind_figures<Figures>(machine), machine.array, list, {}, keeps,
                                           own, {});
    renderer.render();
    reference::ReferenceArray reference(region, machine.array.memory_bits);
    for (std::size_t i = 0; i < list.size(); ++i) {
      reference.execute(list[i]);
      check_pixels(renderer.steps()[i].pixels, own, machine.array, reference);
    }
  }));
}

TEST_CASE("a sum takes a node clocks for the target's words and for reading the source's") {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.order = multi_processor::RenderingOrder::segment;
  figures.word_bits = 8;
  figures.operations = {.read = 1, .write = 100, .add = 10'000, .compare = 0, .logic = 1'000'000, .multiply = 0};
  const auto clocks = [&](std::uint16_t source) {
    return multi_processor::pixel_clocks(
        {.opcode = isa::Opcode::add, .fields = {isa::Field{0, 20}, isa::Field{20, source}}}, machine);
  };
  // Three groups: reading E, the target (1 + 3 words) and the source; an operation on E; three additions and writes.
  CHECK(clocks(20) == 1'030'300 + 4 + 3);
  CHECK(clocks(9) == 1'030'300 + 4 + 2);
  CHECK(clocks(1) == 1'030'300 + 4 + 1);
}

TEST_CASE("a stripe takes a node as long as an edge") {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  machines::kind_figures<Figures>(machine).word_bits = 8;
  const auto clocks = [&](isa::Opcode opcode) {
    return multi_processor::pixel_clocks({.opcode = opcode, .linear = {.a = 1, .width = 20}}, machine);
  };
  CHECK(clocks(isa::Opcode::stripe) == clocks(isa::Opcode::edge_negative));
}

TEST_CASE("a node's shift takes clocks for places but not for whole words") {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.word_bits = 16;
  const auto clocks = [&](std::uint8_t shift) {
    const isa::Linear linear{.a = 1, .width = 40, .shift = shift};
    figures.operations = {.logic = 1'000'000, .shift = 1000, .shift_bit = 1};
    const std::uint64_t shifted =
        multi_processor::pixel_clocks({.opcode = isa::Opcode::edge_negative, .linear = linear}, machine);
    figures.operations = {.logic = 0, .shift = 0, .shift_bit = 0};
    return shifted - multi_processor::pixel_clocks({.opcode = isa::Opcode::edge_negative, .linear = linear}, machine) -
           1'000'000;
  };
  CHECK(clocks(0) == 0);
  // Three words; the part entering the lower two from above is shifted the other way and joined.
  CHECK(clocks(5) == 3 * 1005 + 2 * 1'001'011);
  CHECK(clocks(16) == 0);
  CHECK(clocks(18) == 2 * 1002 + 1'001'014);
  CHECK(clocks(39) == 1007);
}

TEST_CASE("decoding an instruction's numbers takes a node the hand-counted clocks") {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.word_bits = 16;
  figures.operations = {
      .read = 0, .write = 0, .add = 0, .compare = 0, .logic = 11, .multiply = 0, .shift = 67, .shift_bit = 71};
  const auto shift = [](std::uint64_t places) { return 67 + 71 * places; };
  const std::vector<isa::Instruction> list{
      {.opcode = isa::Opcode::load_linear, .fields = {isa::Field{0, 8}}, .linear = {1, 2, 3, 20, 4}}};
  const auto clocks = [&] {
    return multi_processor::RenderingClocks({.instructions = list}, machine).all({0, 0, 1, 1}, {0, 8});
  };
  const std::uint64_t before = clocks();
  figures.field_clocks = 73;
  // A number that crosses a word boundary takes a second shift and a join; each takes a mask. Offsets in words:
  const std::uint64_t number = shift(6) + (shift(10) + 11);     // 6, of 12 bits
  const std::uint64_t width = shift(2);                         // 18, of 6
  const std::uint64_t sum_width = shift(8);                     // 24, of 6
  const std::uint64_t sum_shift = shift(14) + (shift(2) + 11);  // 30, of 6
  const std::uint64_t a = 2 * shift(4) + (shift(12) + 11);      // 36, of 20
  const std::uint64_t b = 2 * shift(8) + (shift(8) + 11);       // 56, of 20
  const std::uint64_t c = 2 * shift(12) + (shift(4) + 11);      // 76, of 20
  CHECK(clocks() - before == 8 * (73 + 11) + number + width + sum_width + sum_shift + a + b + c);
}

TEST_CASE("a node that branches over work without effect takes the hand-counted clocks") {
  using isa::Opcode;
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  machine.array = {1, 1, 16};
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.word_bits = 16;
  figures.operations = {.read = 2, .write = 3, .add = 5, .compare = 7, .logic = 11, .multiply = 0};
  figures.branches = {.over = multi_processor::Branches::pixels, .taken = 100, .passed = 1000};
  // Four pixels: those with x > 0 are enabled, then F = 5 - 2x is compared with 2 and kept at x = 1 only.
  const isa::Region region{0, 0, 4, 1};
  const isa::Instruction all{.opcode = Opcode::enable_all};
  const isa::Instruction edge{.opcode = Opcode::edge_not_negative, .linear = {1, 0, -1, 20}};
  const isa::Instruction set{.opcode = Opcode::set_constant, .fields = {isa::Field{0, 4}}, .constant = 2};
  const isa::Instruction keep{.opcode = Opcode::keep_max, .fields = {isa::Field{0, 4}}, .linear = {-2, 0, 5, 20}};
  const std::uint64_t look = 2 + 11;
  const auto clocks = [&](std::vector<isa::Instruction> before, const isa::Instruction& last) {
    before.push_back(last);
    const std::vector<machines::PixelActivity> pixel_activity = enabled_pixels(before, region, machine);
    const isa::Segment segment{region, before};
    return multi_processor::subsegment_pixel_clocks(segment, before.size() - 1, machine, pixel_activity.data());
  };
  // Instructions that enable pixels again execute at each pixel.
  CHECK(clocks({}, all) == machines::PixelClocks{4 * (look + 3), 0});
  CHECK(clocks({all}, edge) ==
        machines::PixelClocks{4 * (look + 1000 + 7 + 3 + 2 * 5), 4 * (look + 1000 + 7 + 3 + 10)});
  CHECK(clocks({all, edge}, set) == machines::PixelClocks{(look + 100) + 3 * (look + 1000 + 3), 3 * (look + 1000 + 3)});
  const std::uint64_t unchosen = look + 1000 + 2 + 2 * 7 + 100 + 2 * 5;
  const std::uint64_t chosen = look + 1000 + 2 + 2 * 7 + 1000 + 3 + 2 * 7 + 3 + 2 * 5;
  CHECK(clocks({all, edge, set}, keep) ==
        machines::PixelClocks{(look + 100 + 2 * 5) + 2 * unchosen + chosen, 2 * unchosen + chosen});
  CHECK(multi_processor::pixel_clocks(keep, machine) == chosen);
  // F is recomputed at each enabled pixel only.
  figures.order = multi_processor::RenderingOrder::pixel;
  figures.operations.multiply = 13;
  const std::uint64_t begin = 2 * (2 * 13 + 2 * 5);
  CHECK(clocks({all, edge, set}, keep).all == (look + 100) + 2 * (unchosen + begin - 10) + (chosen + begin - 10));
  figures.branches.over = multi_processor::Branches::none;
  CHECK(clocks({all, edge, set}, keep).all == 4 * (chosen - 2000 + begin - 10));
}

TEST_CASE("a native node decodes a list once and then calls its instructions (by hand)") {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.word_bits = 16;
  figures.operations = {.read = 2, .write = 3, .add = 0, .compare = 0, .logic = 0, .multiply = 0};
  figures.loop = {.pixel = 0, .row = 0, .instruction = 100};
  figures.chain = {.program = multi_processor::NodeProgram::interpreted, .link = 1000, .call = 10'000};
  // 6 + 12 + 6 + 6 + 6 + 60 bits are 6 words; in separate words its numbers take 4 words and three pairs.
  const std::vector<isa::Instruction> list{
      {.opcode = isa::Opcode::load_linear, .fields = {isa::Field{0, 8}}, .linear = {1, 2, 3, 20, 4}}};
  const auto clocks = [&](multi_processor::RenderingOrder order) {
    const auto of = [&](multi_processor::NodeProgram program) {
      figures.order = order;
      figures.chain.program = program;
      return multi_processor::RenderingClocks({.instructions = list}, machine).all({0, 0, 3, 5}, {0, 8});
    };
    const std::uint64_t interpreted = of(multi_processor::NodeProgram::interpreted);
    return static_cast<std::int64_t>(of(multi_processor::NodeProgram::native) - interpreted);
  };
  const std::int64_t fetch = 100 + 6 * 2;
  const std::int64_t chain = fetch + 1000 + 10 * 3;
  const std::int64_t call = 10'000 + 10 * 2;
  CHECK(clocks(multi_processor::RenderingOrder::segment) == chain + call - fetch);
  CHECK(clocks(multi_processor::RenderingOrder::scan_line) == chain + 5 * (call - fetch));
  CHECK(clocks(multi_processor::RenderingOrder::pixel) == chain + 15 * (call - fetch));
}