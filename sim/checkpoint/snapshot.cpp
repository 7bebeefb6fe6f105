#include "sim/checkpoint/snapshot.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "hw/base/hash.h"
#include "hw/isa/binary.h"
#include "hw/machines/kind.h"
#include "sim/checkpoint/format.h"
#include "sim/checkpoint/packed.h"

namespace csgsim::checkpoint {

namespace {

std::uint64_t hash_of(const isa::Program& program) {
  const std::vector<std::byte> bytes = isa::encode(program);
  Hash hash;
  hash.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return hash.value();
}

std::uint64_t hash_of(const machines::Machine& machine) {
  std::string text = fmt::format("{} {}x{} of {}x{} {} {} {} {} {} {} {}", machine.kind->name, machine.picture.width,
                                 machine.picture.height, machine.array.width, machine.array.height,
                                 machine.array.memory_bits, machine.clock_hz, machine.memory_reads, machine.alu_bits,
                                 machine.evaluator_bits, machine.clear_clocks, machine.link.width);
  for (const machines::Figure& figure : machine.figures) text += fmt::format(" {}={}", figure.key, figure.value);
  Hash hash;
  hash.add(text);
  return hash.value();
}

/// Words of one plane; 0 if the run has no pixels yet.
std::size_t plane_words(const engine::RunState& run) {
  for (const std::vector<std::uint64_t>& plane : run.planes)
    if (!plane.empty()) return plane.size();
  return 0;
}

}  // namespace

RunIdentity identity_of(const isa::Program& program, const machines::Machine& machine) {
  return {hash_of(program), hash_of(machine)};
}

std::vector<std::byte> encode(const Snapshot& snapshot) {
  isa::ByteWriter out;
  out.block(snapshot_magic);
  out.byte(snapshot_version);
  put_fixed(out, snapshot.identity.program, 8);
  put_fixed(out, snapshot.identity.machine, 8);

  const engine::RunState& run = snapshot.run;
  for (const std::uint64_t number : {std::uint64_t{run.place.segment}, std::uint64_t{run.place.index},
                                     std::uint64_t{run.is_end_reported}, run.overflows, run.skipped})
    out.varint(number);
  put_bits(out, run.answers);
  out.varint(run.skips.size());
  for (const machines::Skip& skip : run.skips) {
    out.varint(skip.segment);
    out.varint(skip.index);
  }
  const std::size_t words = plane_words(run);
  out.varint(words);
  for (const std::vector<std::uint64_t>& plane : run.planes) put_plane(out, plane, words);

  const observe::FrameObserver::Gathered& picture = snapshot.picture;
  const observe::Frame& frame = picture.frame;
  for (const std::vector<std::uint32_t>* values :
       {&frame.colour, &frame.depth, &frame.owner, &picture.candidate_owner, &frame.opaque_depth, &frame.opaque_owner,
        &picture.panes.owner, &picture.panes.depth})
    put_pixels(out, *values);
  for_each_cost(snapshot.stats, [&](const observe::Cost& cost) {
    for (const std::uint64_t number : {cost.instructions, cost.clocks, cost.pixel_operations, cost.enabled})
      out.varint(number);
  });
  put_fixed(out, snapshot_checksum(out.written()), snapshot_checksum_size);
  return out.take();
}

}  // namespace csgsim::checkpoint
