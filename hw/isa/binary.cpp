#include "hw/isa/binary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <limits>
#include <string>
#include <type_traits>

#include "hw/base/error.h"
#include "hw/isa/bytes.h"
#include "hw/isa/describe.h"
#include "hw/isa/extents.h"
#include "hw/isa/metadata.h"
#include "hw/isa/operands.h"

namespace csgsim::isa {

namespace {

constexpr std::array<std::uint8_t, 4> magic{'C', 'S', 'G', 'T'};
constexpr std::uint8_t version = 4;
constexpr std::uint8_t first_version = 2;  ///< oldest version that can be read; it does not record its machine
constexpr std::size_t checksum_size = 4;
constexpr std::size_t usual_bytes = 32;  ///< upper bound for all instructions except the widest
constexpr std::uint8_t same_origin = 0x80;
constexpr std::uint8_t has_effect = 0x80;  ///< flag in the purpose byte: an effect index follows
static_assert(purpose_table.size() <= has_effect);
static_assert(opcode_numbers <= same_origin);
static_assert(no_primitive + 1 == 0 && no_node + 1 == 0);

std::uint32_t checksum(std::span<const std::byte> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

void write_origin(ByteWriter& out, const Origin& origin) {
  const auto purpose = static_cast<std::uint8_t>(origin.purpose);
  if (origin.effect == no_effect) {
    out.byte(purpose);
  } else {
    out.byte(purpose | has_effect);
    out.byte(origin.effect);
  }
  out.varint(origin.primitive + 1U);
  out.varint(origin.node + 1U);
}

Origin read_origin(ByteReader& in) {
  constexpr auto most = std::numeric_limits<std::uint32_t>::max();
  Origin origin;
  const std::uint8_t purpose = in.byte();
  origin.purpose = static_cast<Purpose>(purpose & ~has_effect);
  if ((purpose & has_effect) != 0) origin.effect = in.byte();
  origin.primitive = in.varint_at_most<std::uint32_t>(most) - 1U;
  origin.node = in.varint_at_most<std::uint32_t>(most) - 1U;
  return origin;
}

template <class Number>
void pass(ByteWriter& out, const Number& number) {
  if constexpr (std::is_signed_v<Number>) {
    out.varint(zigzag(number));
  } else {
    out.varint(number);
  }
}

template <class Number>
void pass(ByteReader& in, Number& number) {
  if constexpr (std::is_signed_v<Number>) {
    number = unzigzag(in.varint());
  } else {
    number = in.varint_at_most<Number>(std::numeric_limits<Number>::max());
  }
}

/// Writes or reads an operand. No other code lists the numbers of an operand in order.
template <class Bytes, Any<Instruction> T>
void pass_operand(Bytes& bytes, T& instruction, std::size_t operand) {
  const auto pass_all = [&](auto&... numbers) { (pass(bytes, numbers), ...); };
  auto& field = instruction.fields[operand];
  auto& [a, b, c, width, shift] = instruction.linear;
  switch (operands_of(instruction.opcode)[operand]) {
    case OperandKind::none: return;
    case OperandKind::target:
    case OperandKind::source: return pass_all(field.base, field.width);
    case OperandKind::linear: return pass_all(a, b, c, width, shift);
    case OperandKind::squares: return pass_all(a, b, c, width);
    case OperandKind::constant:
    case OperandKind::count: return pass_all(instruction.constant);
  }
}

void write_instruction(ByteWriter& out, const Instruction& instruction, Origin& before) {
  const auto opcode = static_cast<std::uint8_t>(instruction.opcode);
  if (instruction.origin == before) {
    out.byte(opcode | same_origin);
  } else {
    out.byte(opcode);
    write_origin(out, instruction.origin);
    before = instruction.origin;
  }
  for (std::size_t i = 0; i < max_operands; ++i) pass_operand(out, instruction, i);
}

Instruction read_instruction(ByteReader& in, Origin& before) {
  const std::uint8_t code = in.byte();
  Instruction instruction;
  instruction.opcode = static_cast<Opcode>(code & ~same_origin);
  if (!in_table(instruction.opcode))
    throw MalformedBytes(fmt::format("holds the undefined opcode {}", code & ~same_origin));
  if ((code & same_origin) == 0) before = read_origin(in);
  instruction.origin = before;
  for (std::size_t i = 0; i < max_operands; ++i) pass_operand(in, instruction, i);
  return instruction;
}

/// The bytes between version and checksum, after all checks.
std::span<const std::byte> checked_body(std::span<const std::byte> bytes) {
  if (!is_binary(bytes)) throw MalformedBytes("does not begin with CSGT");
  if (bytes.size() < magic.size() + 1 + checksum_size) throw MalformedBytes("ends too soon");
  const auto found_version = std::to_integer<unsigned>(bytes[magic.size()]);
  if (found_version < first_version || found_version > version)
    throw MalformedBytes(
        fmt::format("has format version {}, but this csgsim reads {} to {}", found_version, first_version, version));
  const auto summed = bytes.first(bytes.size() - checksum_size);
  std::uint32_t expected = 0;
  for (std::size_t i = 0; i < checksum_size; ++i)
    expected |= std::to_integer<std::uint32_t>(bytes[summed.size() + i]) << 8U * i;
  if (checksum(summed) != expected) throw MalformedBytes("is damaged: its checksum does not match");
  return summed.subspan(magic.size() + 1);
}

bool is_in_lines(const Program& program) {
  return std::ranges::all_of(program.segments, [&](const Segment& segment) {
    return segment.region.width == program.shape.width && segment.region.height == 1;
  });
}

Program decode_body(std::span<const std::byte> body, bool names_machine) {
  ByteReader in(body);
  auto [program, counts] = decode_metadata(in.block(in.varint()), names_machine);
  Origin before;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    // Each instruction takes at least one byte, so a larger count is wrong, and nothing is reserved for it.
    if (counts[s] > in.left()) throw MalformedBytes("ends too soon");
    auto& instructions = program.segments[s].instructions;
    instructions.reserve(static_cast<std::size_t>(counts[s]));
    for (std::uint64_t i = 0; i < counts[s]; ++i) instructions.push_back(read_instruction(in, before));
  }
  if (in.left() != 0) throw MalformedBytes(fmt::format("has {} bytes after its end", in.left()));
  if (!names_machine && is_in_lines(program)) program.extents = compute_row_extents(program.segments);
  return std::move(program);
}

}  // namespace

bool is_binary(std::span<const std::byte> bytes) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](std::uint8_t expected, std::byte found) { return std::byte{expected} == found; });
}

std::vector<std::byte> encode(const Program& program) {
  ByteWriter out;
  out.reserve(usual_bytes * total_instructions(program));
  out.block(magic);
  out.byte(version);
  const std::vector<std::uint8_t> metadata = encode_metadata(program);
  out.varint(metadata.size());
  out.block(metadata);
  Origin before;
  for (const Segment& segment : program.segments)
    for (const Instruction& instruction : segment.instructions) write_instruction(out, instruction, before);
  const std::uint32_t sum = checksum(out.written());
  for (std::size_t i = 0; i < checksum_size; ++i) out.byte(static_cast<std::uint8_t>(sum >> 8U * i));
  return out.take();
}

Program decode(std::span<const std::byte> bytes, std::string_view name) {
  try {
    const auto body = checked_body(bytes);
    Program program = decode_body(body, std::to_integer<unsigned>(bytes[magic.size()]) > first_version);
    validate(program);
    return program;
  } catch (const MalformedBytes& error) {
    throw InputError(fmt::format("{}: {}; compile the model again", name, error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace csgsim::isa
