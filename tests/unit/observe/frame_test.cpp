#include "sim/observe/frame.h"

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/observe/fake_pixels.h"

using namespace csgsim;
using namespace isa;
using testing::FakePixels;

namespace {

constexpr Field depth{0, 4};
constexpr Field candidate{4, 4};
constexpr Field colour{8, 3};
constexpr Field candidate_colour{11, 3};
constexpr std::uint32_t width = 70;
constexpr std::uint32_t height = 3;
constexpr std::uint32_t background = 5;

const Instruction merge_of_2{Opcode::copy, {depth, candidate}, {}, 0, {isa::Purpose::merge, 2, isa::no_node}};
const Instruction merge_of_solid{Opcode::copy, {depth, candidate}, {}, 0, {isa::Purpose::merge, 0, 0}};

Instruction colours(Field field, std::uint32_t primitive, std::uint32_t of_solid) {
  return {Opcode::set_constant, {field}, {}, 1, {isa::Purpose::shade, primitive, of_solid}};
}

/// A picture in two parts; the first is wider than a 64-bit word.
isa::Program program(bool second_colour = false) {
  isa::Program program;
  program.shape = {width, height, 14};
  program.colour = colour;
  program.facts->fields = {{"Z2", depth, isa::FieldRole::depth},
                           {"Z1", candidate, isa::FieldRole::candidate_depth},
                           {"colour", colour, isa::FieldRole::colour}};
  if (second_colour) program.facts->fields.push_back({"colour1", candidate_colour, isa::FieldRole::candidate_colour});
  program.background = background;
  program.facts->primitives = {"a", "b", "c"};
  program.segments = {{{0, 0, 67, 3}, {merge_of_2}}, {{67, 1, 3, 2}, {merge_of_2}}};
  return program;
}

void carry_out(observe::FrameObserver& observer, const Instruction& instruction, const FakePixels& pixels) {
  observer.after_instruction({0, 0, instruction, 1, 1}, pixels);
}

std::uint32_t at(const std::vector<std::uint32_t>& picture, std::uint32_t x, std::uint32_t y) {
  return picture[y * width + x];
}

/// Counts the pixels of the picture that differ from `nothing`.
std::size_t others_than(const std::vector<std::uint32_t>& picture, std::uint32_t nothing) {
  std::size_t count = 0;
  for (const std::uint32_t value : picture) count += value == nothing ? 0 : 1;
  return count;
}

}  // namespace

TEST_CASE("a picture starts as background without depth or owners") {
  const observe::FrameObserver observer(program());
  const observe::Frame& frame = observer.frame();
  CHECK(frame.width == width);
  CHECK(frame.height == height);
  CHECK(frame.colour == std::vector<std::uint32_t>(width * height, background));
  CHECK(frame.depth == std::vector<std::uint32_t>(width * height, 15));
  CHECK(frame.owner == std::vector<std::uint32_t>(width * height, observe::no_owner));
}

TEST_CASE("depth and colour of a segment are copied to its place in the picture") {
  observe::FrameObserver observer(program());
  FakePixels pixels({67, 1, 3, 2});
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < 3; ++x) {
      pixels.write(depth, x, y, 3 * y + x);
      pixels.write(colour, x, y, 7 - 3 * y - x);
    }
  }
  observer.after_segment(1, pixels);
  const observe::Frame& frame = observer.frame();
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < 3; ++x) {
      CHECK(at(frame.depth, 67 + x, 1 + y) == 3 * y + x);
      CHECK(at(frame.colour, 67 + x, 1 + y) == 7 - 3 * y - x);
    }
  }
  CHECK(others_than(frame.depth, 15) == 6);
  CHECK(others_than(frame.colour, background) == 5);  // one of the six colours is the background's
}

TEST_CASE("a segment without instructions shows the background whatever its pixels hold") {
  isa::Program empty = program();
  empty.segments[1].instructions.clear();
  observe::FrameObserver observer(empty);
  observer.after_segment(1, FakePixels({67, 1, 3, 2}));
  CHECK(others_than(observer.frame().depth, 15) == 0);
  CHECK(others_than(observer.frame().colour, background) == 0);
}

TEST_CASE("a pixel with merged depth is owned by the primitive of that depth") {
  observe::FrameObserver observer(program());
  FakePixels pixels({0, 0, 67, 3});
  pixels.enable_only({{0, 0}, {63, 1}, {64, 1}, {66, 2}});
  carry_out(observer, merge_of_2, pixels);
  const std::vector<std::uint32_t>& owner = observer.frame().owner;
  CHECK(at(owner, 0, 0) == 2);
  CHECK(at(owner, 63, 1) == 2);
  CHECK(at(owner, 64, 1) == 2);
  CHECK(at(owner, 66, 2) == 2);
  CHECK(others_than(owner, observe::no_owner) == 4);
}

TEST_CASE("owners of a segment are copied to its place in the picture") {
  observe::FrameObserver observer(program());
  FakePixels pixels({67, 1, 3, 2});
  pixels.enable(2, 1);
  carry_out(observer, merge_of_2, pixels);
  CHECK(at(observer.frame().owner, 69, 2) == 2);
  CHECK(others_than(observer.frame().owner, observe::no_owner) == 1);
}

TEST_CASE("other copies and colours of one primitive change no owner and are not read") {
  const observe::FrameObserver observer(program());
  CHECK(observer.reads_after(merge_of_2));
  CHECK(observer.reads_after(colours(colour, 1, 0)));
  CHECK_FALSE(observer.reads_after({Opcode::copy, {candidate, depth}, {}, 0, {}}));
  CHECK_FALSE(observer.reads_after(colours(colour, 1, isa::no_node)));
  CHECK_FALSE(observer.reads_after(colours(candidate, 1, 0)));
  CHECK_FALSE(observer.reads_after(colours(candidate_colour, 1, 0)));  // this Program has no such field
  CHECK_FALSE(observer.reads_after({Opcode::field_lt, {depth, candidate}, {}, 0, {}}));
  observe::FrameObserver other(program());
  FakePixels pixels({0, 0, 67, 3});
  pixels.enable(1, 1);
  carry_out(other, colours(colour, 1, isa::no_node), pixels);
  CHECK(others_than(other.frame().owner, observe::no_owner) == 0);
}

TEST_CASE("in a merged solid the owner is the primitive whose colour is written") {
  observe::FrameObserver observer(program());
  FakePixels pixels({0, 0, 67, 3});
  pixels.enable_only({{3, 0}, {4, 0}});
  carry_out(observer, merge_of_solid, pixels);
  pixels.enable_only({{4, 0}});
  carry_out(observer, colours(colour, 1, 0), pixels);
  CHECK(at(observer.frame().owner, 3, 0) == 0);
  CHECK(at(observer.frame().owner, 4, 0) == 1);
}

TEST_CASE("in a merged solid colour written channel by channel sets the owner") {
  observe::FrameObserver observer(program());
  FakePixels pixels({0, 0, 67, 3});
  pixels.enable_only({{3, 0}, {4, 0}});
  carry_out(observer, merge_of_solid, pixels);
  pixels.enable_only({{4, 0}});
  const Instruction channel{Opcode::copy, {Field{9, 1}, Field{4, 1}}, {}, 0, {isa::Purpose::shade, 1, 0}};
  CHECK(observer.reads_after(channel));
  carry_out(observer, channel, pixels);
  CHECK(at(observer.frame().owner, 3, 0) == 0);
  CHECK(at(observer.frame().owner, 4, 0) == 1);
  // A merge takes the owner from the field next to Z1.
  CHECK_FALSE(observer.reads_after({Opcode::copy, {colour, candidate_colour}, {}, 0, merge_of_solid.origin}));
}

TEST_CASE("transparent surfaces are recorded at the first comparison and count as nearest") {
  constexpr Field nearest{14, 4};
  constexpr std::uint8_t glass = 1;
  isa::Program with_panes = program();
  with_panes.shape.memory_bits = 18;
  with_panes.facts->compile.effects = {"flat", "glass", "mirrors"};
  with_panes.facts->fields.push_back({"glass.nearest_depth", nearest, isa::FieldRole::effect});
  const Instruction pane{Opcode::copy, {nearest, candidate}, {}, 0, {isa::Purpose::merge, 1, isa::no_node, glass}};
  const Instruction in_mirror{Opcode::copy, {nearest, candidate}, {}, 0, {isa::Purpose::merge, 0, isa::no_node, 2}};
  const isa::Origin composing{isa::Purpose::effect, isa::no_primitive, isa::no_node, glass};
  const Instruction compare{Opcode::field_lt, {nearest, depth}, {}, 0, composing};
  observe::FrameObserver observer(with_panes);
  FakePixels pixels({0, 0, 67, 3});
  pixels.write(depth, 4, 1, 9);
  pixels.enable(4, 1);
  carry_out(observer, merge_of_2, pixels);
  pixels.enable(6, 1);
  carry_out(observer, in_mirror, pixels);
  carry_out(observer, pane, pixels);
  for (const std::uint32_t layer : {3U, 7U}) {
    pixels.write(nearest, 4, 1, layer);
    pixels.write(nearest, 6, 1, layer + 1);
    carry_out(observer, compare, pixels);
  }
  pixels.write(depth, 6, 1, 15);
  observer.after_segment(0, pixels);
  const observe::Frame& frame = observer.frame();
  CHECK(at(frame.owner, 4, 1) == 1);
  CHECK(at(frame.depth, 4, 1) == 3);
  CHECK(at(frame.owner, 6, 1) == 1);
  CHECK(at(frame.depth, 6, 1) == 4);
  const observe::Frame opaque = observe::with_opaque_surfaces(frame);
  CHECK(at(opaque.owner, 4, 1) == 2);
  CHECK(at(opaque.depth, 4, 1) == 9);
  CHECK(at(opaque.owner, 6, 1) == observe::no_owner);
  CHECK(at(opaque.depth, 6, 1) == 15);
  CHECK(others_than(frame.owner, observe::no_owner) == 2);
}

TEST_CASE("an owner whose colour is stored beside Z1 enters the picture at the merge") {
  observe::FrameObserver observer(program(true));
  FakePixels pixels({0, 0, 67, 3});
  pixels.enable_only({{3, 0}, {4, 0}});
  carry_out(observer, colours(candidate_colour, 0, 0), pixels);
  pixels.enable_only({{4, 0}, {5, 0}});
  carry_out(observer, colours(candidate_colour, 1, 0), pixels);
  CHECK(others_than(observer.frame().owner, observe::no_owner) == 0);
  pixels.enable_only({{3, 0}, {4, 0}});
  carry_out(observer, merge_of_solid, pixels);
  CHECK(at(observer.frame().owner, 3, 0) == 0);
  CHECK(at(observer.frame().owner, 4, 0) == 1);
  CHECK(others_than(observer.frame().owner, observe::no_owner) == 2);
}
