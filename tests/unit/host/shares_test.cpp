#include "hw/host/shares.h"

#include "hw/host/host.h"
#include "hw/host/recipes.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/processors/processor.h"
#include "tests/support/test.h"
#include "tests/support/two_cubes.h"

using namespace csgsim;
using processors::Operation;
using processors::operation_counts;
using processors::Operations;

namespace {

machines::Machine machine_with(std::uint32_t count, const std::string& name = "pixel-planes-4") {
  machines::Machine machine = kinds::load(fmt::format("{}+host.processor=mc68000+host.count={}", name, count));
  machines::set_picture_size(machine, {64, 64});
  return machine;
}

/// A chunk of two instructions.
const std::vector<isa::Instruction> chunk{{.opcode = isa::Opcode::enable_all}, {.opcode = isa::Opcode::enable_invert}};

isa::Segment segment_of(unsigned chunks, std::uint64_t boxes) {
  isa::Segment segment{.region = {0, 0, 64, 64}, .instructions = {}};
  for (unsigned i = 0; i < chunks; ++i)
    segment.instructions.insert(segment.instructions.end(), chunk.begin(), chunk.end());
  segment.preparation->boxes = boxes;
  return segment;
}

host::Written written(unsigned chunks, unsigned link_width) {
  host::Writer writer(link_width);
  writer.begin({});
  for (unsigned i = 0; i < chunks; ++i)
    for (const isa::Instruction& one : chunk) writer.add(one);
  return writer.written();
}

Operations sum_of(std::initializer_list<Operations> parts) {
  Operations all;
  for (const Operations& part : parts) all += part;
  return all;
}

Operations merge_operations(std::uint64_t longs, std::uint64_t chunks) {
  return sum_of({longs * operation_counts({{Operation::load_long, 1},
                                           {Operation::store_long, 1},
                                           {Operation::add_long, 2},
                                           {Operation::compare_long, 1},
                                           {Operation::branch_taken, 1}}),
                 chunks * operation_counts({{Operation::load_long, 2},
                                            {Operation::add_long, 1},
                                            {Operation::compare, 1},
                                            {Operation::branch, 1},
                                            {Operation::store_long, 1}})});
}

Operations share(const isa::Program& program, const machines::Machine& machine) {
  return host::busiest_processor_operations(program, machine, processors::built_in_processor("mc68000"));
}

}  // namespace

TEST_CASE("processors of a host take chunks in turn and the first one merges") {
  const machines::Machine two = machine_with(2);
  isa::Program program;
  program.shape = two.array;
  program.preparation->planes = 30;
  program.segments = {segment_of(3, 12), segment_of(1, 8)};
  // The first processor has chunks 0 and 2, the second has chunk 1 and the chunk of the second segment. Of the planes,
  // in three parts, the first has two parts.
  const host::Written of_second = written(2, two.link.width);
  const std::uint64_t longs = of_second.longs + of_second.kept_longs;
  CHECK(share(program, two) ==
        sum_of({20 * host::recipe("planes"), 8 * host::recipe("boxes"),
                host::count_operations(written(2, two.link.width)), merge_operations(longs, 2)}));
}

TEST_CASE("more processors than chunks do not make the largest share smaller") {
  isa::Program program;
  program.shape = machine_with(1).array;
  program.preparation->planes = 32;
  program.segments = {segment_of(4, 400)};
  const machines::Machine four = machine_with(4);
  const Operations largest = share(program, four);
  CHECK(largest == sum_of({8 * host::recipe("planes"), 100 * host::recipe("boxes"),
                           host::count_operations(written(1, four.link.width)),
                           merge_operations(3 * written(1, four.link.width).longs, 3)}));
  CHECK(share(program, machine_with(64)) == largest);
}

TEST_CASE("one processor has all of the host's work without a merge") {
  for (const char* name : {"pixel-planes-4", "scan-line", "pixel-square"}) {
    const machines::Machine machine = machine_with(1, name);
    const isa::Program program = testing::two_cubes(machine, {2, 2, 2});
    const double seconds =
        processors::seconds(host::count_operations(program, machine), processors::built_in_processor("mc68000"));
    CHECK(host::compile_clocks(program, machine) ==
          static_cast<std::uint64_t>(std::ceil(seconds * static_cast<double>(machine.clock_hz))));
  }
}

TEST_CASE("several processors need more than an even share and less than one alone") {
  for (const char* name : {"pixel-planes-4", "scan-line", "pixel-square", "multi-processor"}) {
    CAPTURE(name);
    const machines::Machine one = machine_with(1, name);
    const isa::Program program = testing::two_cubes(one, {2, 2, 2});
    const std::uint64_t alone = host::compile_clocks(program, one);
    const std::uint64_t together = host::compile_clocks(program, machine_with(2, name));
    CHECK(together > alone / 2);
    CHECK(together < alone);
  }
}

TEST_CASE("a segment without chunks is prepared by one processor") {
  const machines::Machine two = machine_with(2);
  isa::Program program;
  program.shape = two.array;
  program.segments = {segment_of(0, 5), segment_of(0, 9)};
  CHECK(share(program, two) == 9 * host::recipe("boxes"));
}
