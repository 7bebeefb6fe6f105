// The binary form of Programs, protected by a checksum and the size of a part, which mutations must keep consistent.

#include <algorithm>
#include <boost/crc.hpp>
#include <cstring>
#include <optional>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "hw/isa/binary.h"
#include "hw/isa/bytes.h"
#include "tests/fuzz/program_invariants.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace isa = csgsim::isa;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace {

constexpr std::size_t head_size = 5;  ///< magic and version
constexpr std::size_t checksum_size = 4;

/// The parts of a file that can be mutated.
struct Parts {
  std::vector<std::uint8_t> metadata;
  std::vector<std::uint8_t> instructions;
};

std::vector<std::uint8_t> numbers(std::span<const std::byte> bytes) {
  std::vector<std::uint8_t> values;
  std::ranges::transform(bytes, std::back_inserter(values), [](std::byte byte) { return std::uint8_t(byte); });
  return values;
}

std::optional<Parts> parts_of(std::span<const std::byte> file) {
  if (file.size() < head_size + checksum_size) return std::nullopt;
  try {
    isa::ByteReader in(file.subspan(head_size, file.size() - head_size - checksum_size));
    const auto metadata = in.block(in.varint());
    return Parts{numbers(metadata), numbers(in.block(in.left()))};
  } catch (const isa::MalformedBytes&) {
    return std::nullopt;
  }
}

/// The file of the head and the parts, with the correct checksum.
std::vector<std::byte> sealed(std::span<const std::uint8_t> head, const Parts& parts) {
  isa::ByteWriter out;
  out.block(head);
  out.varint(parts.metadata.size());
  out.block(parts.metadata);
  out.block(parts.instructions);
  boost::crc_32_type crc;
  crc.process_bytes(out.written().data(), out.written().size());
  for (std::size_t i = 0; i < checksum_size; ++i) out.byte(static_cast<std::uint8_t>(crc.checksum() >> 8U * i));
  return out.take();
}

void change(std::vector<std::uint8_t>& part, std::size_t room) {
  const std::size_t size = part.size();
  part.resize(size + room);
  part.resize(LLVMFuzzerMutate(part.data(), size, part.size()));
}

}  // namespace

/// Usually mutates the metadata or the instructions, with a correct checksum; sometimes any byte, with a wrong one.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  std::minstd_rand random(seed);
  std::optional<Parts> parts = parts_of(std::as_bytes(std::span(data, size)));
  if (!parts || random() % 16 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::size_t room = most > size ? most - size : 0;
  change(random() % 2 == 0 ? parts->metadata : parts->instructions, room);
  const std::vector<std::byte> file = sealed({data, head_size}, *parts);
  if (file.size() > most) return size;
  std::memcpy(data, file.data(), file.size());
  return file.size();
}

/// Any bytes give a valid Program or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fuzz::check_program(isa::decode(std::as_bytes(std::span(data, size)), "fuzz.csgt"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.csgt");
  }
  return 0;
}
