#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"
#include "sim/checkpoint/format.h"
#include "sim/checkpoint/packed.h"
#include "sim/checkpoint/snapshot.h"

namespace csgsim::checkpoint {

namespace {

constexpr std::uint64_t any_number = ~std::uint64_t{0};

void require(bool holds, const char* what) {
  if (!holds) throw isa::MalformedBytes(what);
}

/// The bytes between version and checksum, after checking magic, version and checksum.
std::span<const std::byte> checked_body(std::span<const std::byte> bytes) {
  constexpr std::size_t head = snapshot_magic.size() + 1;
  require(bytes.size() >= snapshot_magic.size() &&
              std::equal(snapshot_magic.begin(), snapshot_magic.end(), bytes.begin(),
                         [](std::uint8_t expected, std::byte found) { return std::byte{expected} == found; }),
          "is another kind of file: it does not begin with CSGS");
  require(bytes.size() >= head + snapshot_checksum_size, "ends too soon");
  const auto version = std::to_integer<unsigned>(bytes[snapshot_magic.size()]);
  if (version != snapshot_version)
    throw isa::MalformedBytes(
        fmt::format("has format version {}, but this csgsim reads {}", version, snapshot_version));
  const auto summed = bytes.first(bytes.size() - snapshot_checksum_size);
  isa::ByteReader sum(bytes.subspan(summed.size()));
  require(read_fixed(sum, snapshot_checksum_size) == snapshot_checksum(summed),
          "is damaged: its checksum does not match");
  return summed.subspan(head);
}

/// Bits of the last word of a row that belong to no pixel.
std::uint64_t padding_of(const isa::Region& region) {
  return region.width % 64 == 0 ? 0 : ~std::uint64_t{0} << region.width % 64;
}

void read_planes(isa::ByteReader& in, const isa::Program& program, engine::RunState& run) {
  if (program.segments.empty()) return require(in.varint() == 0, "holds pixels, but the Program has no segments");
  const isa::Region region = program.segments[run.place.segment].region;
  const std::size_t row = (region.width + 63U) / 64U;
  const std::size_t words = row * region.height;
  const std::uint64_t stored = in.varint();  // 0: all planes are zero
  require(stored == 0 || stored == words, "holds pixels of a region of another size");
  run.planes.resize(std::size_t{program.shape.memory_bits} + 1);
  if (stored == 0) return;
  for (std::vector<std::uint64_t>& one : run.planes) {
    one = read_plane(in, words);
    for (std::size_t last = row - 1; last < one.size(); last += row)
      require((one[last] & padding_of(region)) == 0, "sets bits beyond the last pixel of a row");
  }
}

/// Number of executed instructions, computed from place and skips, which must be consistent.
std::uint64_t executed_instructions(const engine::RunState& run, const isa::Program& program) {
  std::uint64_t count = 0;
  std::uint64_t skipped = 0;
  std::size_t answers = 0;
  auto skip = run.skips.begin();
  for (std::uint32_t segment = 0; segment <= run.place.segment && segment < program.segments.size(); ++segment) {
    const std::vector<isa::Instruction>& all = program.segments[segment].instructions;
    const std::size_t end = segment == run.place.segment ? run.place.index : all.size();
    std::size_t index = 0;
    for (; index < end; ++index, ++count) {
      if (all[index].opcode == isa::Opcode::global_or) ++answers;
      if (skip == run.skips.end() || skip->segment != segment || skip->index != index) continue;
      const std::uint64_t left_out = isa::skipped_instruction_count(all[index], 0);
      require(left_out > 0, "has a skip at an instruction that cannot skip");
      skipped += left_out;
      index += static_cast<std::size_t>(left_out);
      ++skip;
    }
    require(index == end, "stops inside skipped instructions");
  }
  require(skip == run.skips.end() && skipped == run.skipped, "has skips that the Program cannot make");
  require(answers == run.answers.size(), "has a number of global-OR results that does not match the Program");
  return count;
}

engine::RunState read_run(isa::ByteReader& in, const isa::Program& program) {
  engine::RunState run;
  const std::size_t segments = program.segments.size();
  run.place.segment = in.varint_at_most<std::uint32_t>(segments == 0 ? 0 : segments - 1);
  const std::size_t instructions = segments == 0 ? 0 : program.segments[run.place.segment].instructions.size();
  run.place.index = in.varint_at_most<std::uint32_t>(instructions);
  run.is_end_reported = in.varint_at_most<std::uint8_t>(1) != 0;
  require(!run.is_end_reported || run.place.index == instructions,
          "reports the end of a segment before its last instruction");
  run.overflows = in.varint_at_most<std::uint64_t>(any_number);
  run.skipped = in.varint_at_most<std::uint64_t>(any_number);
  run.answers = read_bits(in, engine::Numbers(program).count());
  const std::uint64_t skips = in.varint();
  require(skips <= in.left(), "ends too soon");
  for (std::uint64_t i = 0; i < skips; ++i) {
    const auto segment = in.varint_at_most<std::uint32_t>(~std::uint32_t{0});
    run.skips.push_back({segment, in.varint_at_most<std::uint32_t>(~std::uint32_t{0})});
  }
  read_planes(in, program, run);
  return run;
}

void check_below(const std::vector<std::uint32_t>& values, std::uint64_t limit, std::uint32_t other, const char* what) {
  require(
      std::all_of(values.begin(), values.end(), [&](std::uint32_t value) { return value < limit || value == other; }),
      what);
}

observe::FrameObserver::Gathered read_picture(isa::ByteReader& in, const isa::Program& program) {
  const std::size_t count = std::size_t{program.shape.width} * program.shape.height;
  const std::size_t owners = isa::piece_count(*program.facts);
  observe::FrameObserver::Gathered picture;
  picture.frame.width = program.shape.width;
  picture.frame.height = program.shape.height;
  picture.frame.colour = read_pixels(in, count);
  picture.frame.depth = read_pixels(in, count);
  picture.frame.owner = read_pixels(in, count);
  if (isa::find_field(program, isa::FieldRole::candidate_colour).width > 0)
    picture.candidate_owner = read_pixels(in, count);
  if (!observe::FrameObserver(program).gathered().panes.owner.empty()) {
    for (std::vector<std::uint32_t>* const one :
         {&picture.frame.opaque_depth, &picture.frame.opaque_owner, &picture.panes.owner, &picture.panes.depth})
      *one = read_pixels(in, count);
  }
  const unsigned colour = program.colour.width;
  const unsigned depth = isa::find_field(program, isa::FieldRole::depth).width;
  check_below(picture.frame.colour, std::uint64_t{1} << colour, program.background, "holds a colour out of range");
  for (const std::vector<std::uint32_t>* one : {&picture.frame.depth, &picture.frame.opaque_depth})
    check_below(*one, std::uint64_t{1} << depth, 0, "holds a depth out of range");
  check_below(picture.panes.depth, std::uint64_t{1} << depth, observe::FrameObserver::unread_depth,
              "holds a depth out of range");
  for (const std::vector<std::uint32_t>* one :
       {&picture.frame.owner, &picture.candidate_owner, &picture.frame.opaque_owner, &picture.panes.owner})
    check_below(*one, owners, observe::no_owner, "holds an owner that the Program does not name");
  return picture;
}

observe::Stats read_stats(isa::ByteReader& in, const isa::Program& program) {
  observe::Stats stats = observe::StatsObserver(program).stats();
  for_each_cost(stats, [&](observe::Cost& cost) {
    for (std::uint64_t* number : {&cost.instructions, &cost.clocks, &cost.pixel_operations, &cost.enabled})
      *number = in.varint();
  });
  return stats;
}

Snapshot read_body(std::span<const std::byte> body, const isa::Program& program, const machines::Machine& machine) {
  isa::ByteReader in(body);
  Snapshot snapshot;
  snapshot.identity.program = read_fixed(in, 8);
  snapshot.identity.machine = read_fixed(in, 8);
  const RunIdentity expected = identity_of(program, machine);
  if (snapshot.identity.program != expected.program)
    throw InputError("the checkpoint belongs to another Program; resume it with the Program it was taken from");
  if (snapshot.identity.machine != expected.machine)
    throw InputError("the checkpoint belongs to a run on another machine; give the same --machine");
  snapshot.run = read_run(in, program);
  snapshot.picture = read_picture(in, program);
  snapshot.stats = read_stats(in, program);
  require(in.left() == 0, "has bytes after its end");
  require(snapshot.stats.total.instructions == executed_instructions(snapshot.run, program),
          "has an instruction count that does not match its place");
  return snapshot;
}

}  // namespace

Snapshot decode(std::span<const std::byte> bytes, std::string_view source_name, const isa::Program& program,
                const machines::Machine& machine) {
  try {
    return read_body(checked_body(bytes), program, machine);
  } catch (const isa::MalformedBytes& error) {
    throw InputError(
        fmt::format("{}: the checkpoint {}; run the Program from its beginning", source_name, error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", source_name, error.what()));
  }
}

}  // namespace csgsim::checkpoint
