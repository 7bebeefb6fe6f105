// Checkpoint files, whose checksum mutations must keep consistent.

#include "sim/checkpoint/snapshot.h"

#include <algorithm>
#include <cstring>
#include <random>
#include <span>
#include <vector>

#include "hw/isa/bytes.h"
#include "hw/isa/text.h"
#include "hw/machines/kind.h"
#include "hw/pixel_planes/kind.h"
#include "sim/checkpoint/format.h"
#include "sim/checkpoint/packed.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace isa = csgsim::isa;
namespace checkpoint = csgsim::checkpoint;
namespace engine = csgsim::engine;
namespace observe = csgsim::observe;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace {

/// The Program of the checkpoints in the corpus.
constexpr const char* text = R"(.array width=70 height=3 memory_bits=16
.frame colour_base=8 colour_bits=6
.field Z2 [0+:8] depth
.field colour [8+:6] colour
.field beside [2+:6] candidate_colour
.primitive "a"
.segment x=0 y=0 width=70 height=3
  enable_all
  load_linear [0+:8], x + 2*y (w12)
  skip_if_none 1
  global_or
  edge_negative 5 - x (w9)
  skip_if_none 2
  set_constant colour, 33 ; shade p0
  set_constant beside, 7 ; shade p0 against p0
.segment x=3 y=1 width=9 height=2
  enable_all
  set_constant colour, 63
)";

const isa::Program& program() {
  static const isa::Program one = isa::parse(text, "fuzz");
  return one;
}

csgsim::machines::Machine planes() {
  csgsim::machines::Machine machine = csgsim::machines::blank_machine(csgsim::pixel_planes::kind);
  machine.array = program().shape;
  machine.picture = {program().shape.width, program().shape.height};
  machine.clock_hz = 10'000'000;
  return machine;
}

const csgsim::machines::Machine& machine() {
  static const csgsim::machines::Machine one = planes();
  return one;
}

/// The file of the parts before and after the hashes, with correct hashes and checksum.
std::vector<std::byte> sealed(std::span<const std::uint8_t> front, std::span<const std::uint8_t> body) {
  static const checkpoint::RunIdentity identity = checkpoint::identity_of(program(), machine());
  isa::ByteWriter out;
  out.block(front);
  checkpoint::put_fixed(out, identity.program, 8);
  checkpoint::put_fixed(out, identity.machine, 8);
  out.block(body);
  const std::uint32_t sum = checkpoint::snapshot_checksum(out.written());
  for (std::size_t i = 0; i < checkpoint::snapshot_checksum_size; ++i)
    out.byte(static_cast<std::uint8_t>(sum >> 8U * i));
  return out.take();
}

}  // namespace

/// Usually mutates with a correct checksum, sometimes with a wrong one.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  constexpr std::size_t front = checkpoint::snapshot_magic.size() + 1;
  constexpr std::size_t head = front + 16;  // includes the hashes
  std::minstd_rand random(seed);
  if (size < head + checkpoint::snapshot_checksum_size || random() % 16 == 0) return LLVMFuzzerMutate(data, size, most);
  std::vector<std::uint8_t> body(data + head, data + size - checkpoint::snapshot_checksum_size);
  const std::size_t used = body.size();
  body.resize(std::max(used, most - head - checkpoint::snapshot_checksum_size));
  body.resize(LLVMFuzzerMutate(body.data(), used, body.size()));
  const std::vector<std::byte> file = sealed({data, front}, body);
  if (file.size() > most) return size;
  std::memcpy(data, file.data(), file.size());
  return file.size();
}

/// Any bytes give one line of error, or a state from which a run continues to its end, and which is written as it was
/// read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const checkpoint::Snapshot read =
        checkpoint::decode(std::as_bytes(std::span(data, size)), "fuzz.csgs", program(), machine());
    const std::vector<std::byte> written = checkpoint::encode(read);
    fuzz::require(checkpoint::decode(written, "fuzz.csgs", program(), machine()) == read,
                  "a checkpoint is read as written");
    const auto engine = engine::make_functional_engine(machine());
    const auto run = engine->begin(program());
    run->restore(read.run);
    fuzz::require(run->save() == read.run, "a resumed run has the given state");
    run->advance(engine::Run::end, {});
    fuzz::require(run->is_finished(), "a resumed run reaches its end");
    (void)run->result();
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.csgs");
  }
  return 0;
}
