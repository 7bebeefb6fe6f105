#include "hw/multi_processor/records.h"

#include <rapidcheck.h>

#include "hw/base/quotient.h"
#include "hw/division/divide.h"
#include "hw/division/division_check.h"
#include "hw/division/encoding.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"
#include "hw/multi_processor/list_wire.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/timing_model.h"
#include "hw/multi_processor/timing_parts.h"
#include "hw/multi_processor/timing_passes.h"
#include "tests/lockstep/divided_program.h"
#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;
using multi_processor::frame_records;
using multi_processor::frame_words;
using multi_processor::RecordReader;
using multi_processor::Records;
using multi_processor::segment_records;
using multi_processor::segment_words;
using multi_processor::subsegments_by_segment;

namespace {

using Words = std::vector<isa::LinkWord>;

machines::Machine any_machine() {
  const auto below = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); };
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  machine.array = {1 + below(4), 1 + below(4), 200};
  machine.picture = {1 + below(60), 1 + below(60)};
  machine.link.width = 1 + below(80);
  machines::kind_figures<multi_processor::Figures>(machine).levels = below(5);
  return machine;
}

Words words_of(const Records& records, unsigned width) {
  Words words;
  for (const division::Bits& record : records) {
    const Words own = division::to_link(record, width);
    words.insert(words.end(), own.begin(), own.end());
  }
  return words;
}

void take_all(RecordReader& reader, const Words& words) {
  for (const isa::LinkWord& word : words) reader.take(word);
}

/// Returns the division of a node's subsegment from the words received over the bus.
division::SquareDivision divided_by_node(const RecordReader& reader, const isa::Region& part) {
  division::PlainDatapath path(reader.model());
  return division::Divider(reader.model()).divide(part, reader.survivors(), path);
}

/// A display processor with a model, and the subsegments of a segment that it divides.
struct Display {
  isa::Program program;
  machines::Machine machine;
  division::DisplayModel model;
  division::Divider divider;

  explicit Display(const machines::Machine& described)
      : program(test::any_divided_program(described)),
        machine(described),
        model(division::display_model_of(program.display_model)),
        divider(model) {}

  [[nodiscard]] Words frame() const { return words_of(frame_records(model), machine.link.width); }

  [[nodiscard]] Words segment(const isa::Region& region) const {
    division::PlainDatapath path(model);
    return words_of(segment_records(model, divider.survivors(region, path)), machine.link.width);
  }

  [[nodiscard]] isa::Region whole_of(multi_processor::Subsegments parts) const {
    const isa::Region& first = parts.front().region;
    const isa::Region& last = parts.back().region;
    return {first.x, first.y, last.x + last.width - first.x, last.y + last.height - first.y};
  }
};

bool alike(const isa::Instruction& one, const isa::Instruction& other) {
  return isa::as_received(one) == isa::as_received(other);
}

void check_list(const division::SquareDivision& divided, const isa::Segment& expected) {
  RC_ASSERT(std::equal(divided.instructions.begin(), divided.instructions.end(), expected.instructions.begin(),
                       expected.instructions.end(), alike));
  const isa::DivisionStep facts = expected.division->sum();
  const division::Counts counts = divided.counts();
  RC_ASSERT(counts.boxes == facts.boxes);
  RC_ASSERT(counts.halfspaces == facts.halfspaces);
  RC_ASSERT(counts.cells == facts.cells);
  RC_ASSERT(counts.nodes == facts.nodes);
}

void flip(Words& words, std::uint64_t bit, unsigned width) {
  words[static_cast<std::size_t>(bit / width)].bits[bit % width / 64] ^= std::uint64_t{1} << bit % width % 64;
}

}  // namespace

TEST_CASE("a node's division from the bus equals the host's list and counts") {
  CHECK(rc::check([] {
    const Display display(any_machine());
    RecordReader reader(display.machine.link.width, 16);
    reader.begin_frame();
    take_all(reader, display.frame());
    RC_ASSERT(reader.is_complete());
    for (const multi_processor::Subsegments parts : subsegments_by_segment(display.program, display.machine)) {
      reader.begin_segment();
      take_all(reader, display.segment(display.whole_of(parts)));
      RC_ASSERT(reader.is_complete());
      for (const isa::Segment& part : parts) check_list(divided_by_node(reader, part.region), part);
    }
  }));
}

TEST_CASE("lists with or without half-space numbers arrive unchanged in the computed bits") {
  CHECK(rc::check([] {
    Display display(any_machine());
    machines::kind_figures<multi_processor::Figures>(display.machine).lists =
        *rc::gen::element(multi_processor::ListKind::instructions, multi_processor::ListKind::numbers);
    const std::uint32_t width = display.machine.link.width;
    const multi_processor::ModelSizes sizes = multi_processor::read_model_sizes(display.program.display_model);
    RecordReader reader(width, 16);
    reader.begin_frame();
    take_all(reader, display.frame());
    multi_processor::ListReader list(width);
    for (const multi_processor::Subsegments parts : subsegments_by_segment(display.program, display.machine)) {
      reader.begin_segment();
      take_all(reader, display.segment(display.whole_of(parts)));
      const multi_processor::ListForm form = multi_processor::list_form(parts, false, sizes, display.machine);
      for (const isa::Segment& part : parts) {
        std::vector<isa::Command> sent{isa::SegmentStart{part.region}};
        sent.insert(sent.end(), part.instructions.begin(), part.instructions.end());
        sent.emplace_back(isa::SegmentEnd{});
        for (const isa::Command& command : sent) {
          const Words words = multi_processor::entry_words(command, form, reader.model(), part.region, width);
          RC_ASSERT(words.size() == quotient_up(multi_processor::written_bits(command, form), std::uint64_t{width}));
          std::optional<isa::Command> come;
          for (const isa::LinkWord& word : words) {
            RC_ASSERT_FALSE(come.has_value());
            come = list.take(word, form, reader.model());
          }
          RC_ASSERT(come.has_value());
          const auto* const instruction = std::get_if<isa::Instruction>(&command);
          if (instruction != nullptr) RC_ASSERT(std::get<isa::Instruction>(*come) == isa::as_received(*instruction));
          if (instruction == nullptr) RC_ASSERT(*come == command);
        }
      }
    }
  }));
}

TEST_CASE("a half-space number replaces an expression on the bus (hand calculation)") {
  const multi_processor::ListForm form{
      .has_numbers = true, .number_bits = 9, .record_bits = 80, .record_numbers = {1, 1, 20, 20, 30}};
  const isa::Instruction keep{
      .opcode = isa::Opcode::keep_max, .fields = {isa::Field{0, 20}}, .linear = {3, -2, 70, 33, 12}};
  const isa::Instruction clip{.opcode = isa::Opcode::edge_not_negative, .linear = {0, -1, 5, 9, 0}};
  const isa::Instruction within{
      .opcode = isa::Opcode::linear_lt, .fields = {isa::Field{0, 20}}, .linear = {0, 0, 0, 33, 12}};
  CHECK(multi_processor::written_bits(keep, form) == 6 + 18 + 1 + 9 + 6);
  CHECK(multi_processor::written_bits(clip, form) == 6 + 1 + 12 + 3 * 9);
  CHECK(multi_processor::written_bits(within, form) == 6 + 18 + 1 + 12 + 3 * 33);
  CHECK(multi_processor::written_bits(isa::Instruction{}, form) == 6);
  CHECK(multi_processor::written_bits(keep, {}) == 6 + 18 + 12 + 3 * 33);
  for (const isa::Instruction& one : {keep, clip, within, isa::Instruction{}})
    CHECK(multi_processor::entry_bits(one, form) == multi_processor::written_bits(one, form));
}

TEST_CASE("records of a segment take the computed words on the bus and in memory") {
  CHECK(rc::check([] {
    const Display display(any_machine());
    const std::uint32_t width = display.machine.link.width;
    const multi_processor::ModelSizes sizes = multi_processor::read_model_sizes(display.program.display_model);
    RC_ASSERT(sizes.planes == display.model.planes.size());
    RC_ASSERT(display.frame().size() == frame_words(sizes, width));
    const auto memory_width = *rc::gen::inRange<std::uint32_t>(1, 70);
    RecordReader reader(width, memory_width);
    reader.begin_frame();
    take_all(reader, display.frame());
    RC_ASSERT(reader.memory_words() == frame_words(sizes, memory_width));
    for (const multi_processor::Subsegments parts : subsegments_by_segment(display.program, display.machine)) {
      const multi_processor::SegmentDivision division = multi_processor::segment_division(parts);
      const auto words_of = [&](std::uint32_t bits) {
        return segment_words(sizes, division.primitives, division.halfspaces, bits);
      };
      RC_ASSERT(display.segment(display.whole_of(parts)).size() == words_of(width));
      reader.begin_segment();
      take_all(reader, display.segment(display.whole_of(parts)));
      RC_ASSERT(reader.memory_words() == frame_words(sizes, memory_width) + words_of(memory_width));
    }
  }));
}

TEST_CASE("a changed bit on the bus is rejected or changes the received model or is padding") {
  std::uint64_t refused = 0;
  std::uint64_t another = 0;
  CHECK(rc::check([&] {
    const Display display(any_machine());
    const unsigned width = display.machine.link.width;
    const isa::Region whole{0, 0, display.program.shape.width, display.program.shape.height};
    const Words frame = display.frame();
    Words words = display.segment(whole);
    RecordReader expected(width, 16);
    expected.begin_frame();
    take_all(expected, frame);
    RecordReader actual = expected;
    expected.begin_segment();
    take_all(expected, words);
    flip(words, *rc::gen::inRange<std::uint64_t>(0, words.size() * width), width);
    try {
      actual.begin_segment();
      take_all(actual, words);
    } catch (const InputError&) {
      ++refused;
      return;
    }
    const bool differs = !(actual.model() == expected.model()) ||
                         actual.survivors().primitives != expected.survivors().primitives ||
                         actual.survivors().halfspaces != expected.survivors().halfspaces || !actual.is_complete();
    another += differs ? 1 : 0;
  }));
  CHECK((!testing::draws_usual_cases() || refused > 0));
  CHECK((!testing::draws_usual_cases() || another > 0));
}

TEST_CASE("a changed coefficient on the bus changes the list") {
  division::DisplayModel model;
  model.width = 8;
  model.height = 8;
  model.z_bits = 6;
  model.colour_bits = 3;
  model.fields = {.depth = {0, 6}, .candidate = {6, 6}, .colour = {12, 3}, .candidate_colour = {}, .mask = {15, 1}};
  model.planes = {{false, 1, 0, 20}};
  model.primitives = {{{{{0, 0, 7, 7}, 20, 40}, false, false, 1}, {{0, true, 2}}}};
  model.nodes = {{}};
  testing::ModelDivider divider(model);
  Words words = words_of(segment_records(model, divider.survivors({0, 0, 8, 8})), 256);
  const auto list_of = [&] {
    RecordReader reader(256, 16);
    reader.begin_frame();
    take_all(reader, words_of(frame_records(model), 256));
    reader.begin_segment();
    take_all(reader, words);
    return divided_by_node(reader, {0, 0, 8, 8}).instructions;
  };
  const std::vector<isa::Instruction> before = list_of();
  CHECK(before == divider.divide({0, 0, 8, 8}).instructions);
  // The half-space is the third record: two flags, A, B, then C, whose lowest bit was 0.
  const division::Widths widths = division::widths_of(model);
  flip(words, 2 * 256 + 2 + 2 * std::uint64_t{widths.slope}, 256);
  CHECK_FALSE(list_of() == before);
}
