#include "sim/web/wasm/deflate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/report/codec.h"

namespace csgsim::web {

namespace {

constexpr std::size_t shortest_run = 3;
constexpr std::size_t longest_run = 258;

/// Bits in the order of the stream, lowest first.
struct Code {
  std::uint32_t bits = 0;
  unsigned count = 0;
};

/// Huffman codes begin with their highest bit.
constexpr std::uint32_t reversed(std::uint32_t code, unsigned count) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < count; ++i) bits |= (code >> i & 1U) << (count - 1 - i);
  return bits;
}

/// The fixed code of a literal or length: RFC 1951, 3.2.6.
constexpr Code fixed_code(std::uint32_t symbol) {
  if (symbol < 144) return {reversed(0x30U + symbol, 8), 8};
  if (symbol < 256) return {reversed(0x190U + symbol - 144, 9), 9};
  if (symbol < 280) return {reversed(symbol - 256, 7), 7};
  return {reversed(0xC0U + symbol - 280, 8), 8};
}

constexpr std::uint32_t end_of_block = 256;

constexpr std::array<Code, 256> make_literals() {
  std::array<Code, 256> codes{};
  for (std::uint32_t byte = 0; byte < codes.size(); ++byte) codes[byte] = fixed_code(byte);
  return codes;
}

/// Codes of runs by length: length code and extra bits (RFC 1951, 3.2.5), and the five zero bits of distance 1.
constexpr std::array<Code, longest_run + 1> make_runs() {
  constexpr unsigned distance_bits = 5;
  std::array<Code, longest_run + 1> codes{};
  std::size_t length = shortest_run;
  for (std::uint32_t symbol = 257; symbol < 285; ++symbol) {
    const unsigned extra = symbol < 265 ? 0 : (symbol - 261) / 4;
    const Code code = fixed_code(symbol);
    for (std::uint32_t i = 0; i < 1U << extra; ++i)
      codes[length++] = {code.bits | i << code.count, code.count + extra + distance_bits};
  }
  const Code longest = fixed_code(285);
  codes[longest_run] = {longest.bits, longest.count + distance_bits};
  return codes;
}

class BitStream {
 public:
  explicit BitStream(std::string& bytes) : bytes_(bytes) {}

  void put(Code code) {
    word_ |= std::uint64_t{code.bits} << count_;
    for (count_ += code.count; count_ >= 8; count_ -= 8, word_ >>= 8U) bytes_.push_back(static_cast<char>(word_));
  }

  void fill_byte() {
    if (count_ > 0) put({0, 8 - count_});
  }

 private:
  std::string& bytes_;
  std::uint64_t word_ = 0;
  unsigned count_ = 0;  ///< bits of the word that have not been written yet
};

/// Writes a byte and its repetitions.
void put_run(char byte, std::size_t again, BitStream& stream) {
  static constexpr std::array<Code, 256> literals = make_literals();
  static constexpr std::array<Code, longest_run + 1> runs = make_runs();
  const Code literal = literals[static_cast<unsigned char>(byte)];
  stream.put(literal);
  while (again >= shortest_run) {
    const std::size_t length = std::min(again, longest_run);
    stream.put(runs[length]);
    again -= length;
  }
  for (; again > 0; --again) stream.put(literal);
}

/// The Adler-32 checksum of RFC 1950. 5552 bytes can be summed before an overflow is possible.
std::uint32_t adler32(std::string_view bytes) {
  constexpr std::uint32_t base = 65521;
  constexpr std::size_t most = 5552;
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, most);
    for (const char byte : part) {
      a += static_cast<unsigned char>(byte);
      b += a;
    }
    a %= base;
    b %= base;
    bytes.remove_prefix(part.size());
  }
  return b << 16U | a;
}

}  // namespace

std::string compress_zlib(std::string_view bytes) {
  std::string made("\x78\x01");
  BitStream stream(made);
  stream.put({0b011, 3});  // final block, with fixed codes
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find_first_not_of(bytes[begin], begin), bytes.size());
    put_run(bytes[begin], end - begin - 1, stream);
    begin = end;
  }
  stream.put(fixed_code(end_of_block));
  stream.fill_byte();
  const std::uint32_t check = adler32(bytes);
  for (unsigned shift = 32; shift > 0; shift -= 8) made.push_back(static_cast<char>(check >> (shift - 8) & 0xFFU));
  return made;
}

}  // namespace csgsim::web
