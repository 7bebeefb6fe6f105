#include "hw/isa/wire.h"

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

__extension__ using Wide = __int128;

constexpr Instruction set_constant{Opcode::set_constant, {{{16, 8}}}, {}, 0xa5, {}};
constexpr Instruction longest{Opcode::keep_max, {{{0, 8}}}, {-1, -1, -1, 62, 0}, 0, {}};

std::vector<LinkWord> words_of(const Command& command, unsigned link_width) {
  std::vector<LinkWord> words;
  encode(command, link_width, [&](const LinkWord& word) { words.push_back(word); });
  return words;
}

/// The bits of the words in sequence, each word's first bit first.
std::string bits_of(const std::vector<LinkWord>& words, unsigned link_width) {
  std::string bits;
  for (const LinkWord& word : words)
    for (unsigned bit = 0; bit < link_width; ++bit) bits += (word.bits[bit / 64] >> bit % 64 & 1U) != 0 ? '1' : '0';
  return bits;
}

std::string bits_of(const Command& command, unsigned link_width) {
  return bits_of(words_of(command, link_width), link_width);
}

LinkWord word_of(const std::string& bits) {
  LinkWord word;
  for (std::size_t bit = 0; bit < bits.size(); ++bit)
    if (bits[bit] == '1') word.bits[bit / 64] |= std::uint64_t{1} << bit % 64;
  return word;
}

/// Error of a decoder for bits that arrive over a link of exactly that width.
std::string refusal_of(const std::string& bits) {
  WireDecoder decoder(static_cast<unsigned>(bits.size()));
  return testing::error_of([&] { decoder.take(word_of(bits)); });
}

/// The only command in the words; it must end with the last of them.
Command decoded(const std::vector<LinkWord>& words, unsigned link_width) {
  WireDecoder decoder(link_width);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    RC_ASSERT(!decoder.take(words[i]).has_value());
    RC_ASSERT(!decoder.is_between_commands());
  }
  const std::optional<Command> command = decoder.take(words.back());
  RC_ASSERT(command.has_value());
  RC_ASSERT(decoder.is_between_commands());
  return *command;
}

/// The number congruent modulo 2^width with its sign in that many bits.
Wide residue(Wide number, unsigned width) {
  const Wide modulus = static_cast<Wide>(1) << width;
  const Wide rest = ((number % modulus) + modulus) % modulus;
  return rest >= modulus / 2 ? rest - modulus : rest;
}

/// F according to the instruction set's documentation.
Wide value_of_f(const Linear& linear, std::uint32_t x, std::uint32_t y) {
  const Wide sum = static_cast<Wide>(linear.a) * x + static_cast<Wide>(linear.b) * y + linear.c;
  return residue(sum, linear.width) >> linear.shift;
}

/// Bits of each kind of operand according to the instruction set's documentation.
unsigned expected_bits(const Instruction& instruction) {
  unsigned bits = 6;
  for (const OperandKind kind : info(instruction.opcode).operands) {
    if (is_field(kind)) bits += 12 + 6;
    if (kind == OperandKind::linear) bits += 6 + 6 + 3U * instruction.linear.width;
    if (kind == OperandKind::squares) bits += 6 + 3U * instruction.linear.width;
    if (kind == OperandKind::constant) bits += instruction.fields[0].width;
    if (kind == OperandKind::count) bits += 32;
  }
  return bits;
}

Instruction expected_of(Instruction instruction) {
  Linear& linear = instruction.linear;
  if (linear.width > 0) {
    for (std::int64_t* coefficient : {&linear.a, &linear.b, &linear.c})
      *coefficient = static_cast<std::int64_t>(residue(*coefficient, linear.width));
  }
  instruction.origin = {};
  return instruction;
}

constexpr ArrayShape shape{1000, 700, 4096};

Instruction some_instruction() { return *test::arbitrary_instruction(shape, shape.memory_bits, 3, 2); }

TEST_CASE("an instruction on a field is encoded as number and base and width") {
  CHECK(bits_of(Instruction{Opcode::enable_and, {{{5, 1}}}, {}, 0, {}}, 24) ==
        "110000"
        "101000000000"
        "100000");
}

TEST_CASE("an encoded constant is as wide as its field") {
  CHECK(bits_of(set_constant, 32) ==
        "010010"
        "000010000000"
        "000100"
        "10100101");
}

TEST_CASE("a linear expression is encoded as width and shift and A and B and C") {
  CHECK(bits_of(Instruction{Opcode::linear_ge, {{{0, 3}}}, {-1, 2, -5, 6, 1}, 0, {}}, 54) ==
        "010100"
        "000000000000"
        "110000"
        "011000"
        "100000"
        "111111"
        "010000"
        "110111");
}

TEST_CASE("squares are encoded as width and A and B and C") {
  CHECK(bits_of(Instruction{Opcode::squares, {}, {-1, 2, -5, 6, 0}, 0, {}}, 30) ==
        "100001"
        "011000"
        "111111"
        "010000"
        "110111");
}

TEST_CASE("a skip is encoded with a count of 32 bits") {
  CHECK(bits_of(Instruction{Opcode::skip_if_none, {}, {}, 12, {}}, 38) ==
        "011110"
        "0011000000000000"
        "0000000000000000");
}

TEST_CASE("the start and end of segments and the end of a frame are encoded as commands") {
  CHECK(bits_of(SegmentStart{{3, 0, 64, 16384}}, 70) ==
        "101111"
        "1100000000000000"
        "0000000000000000"
        "0000001000000000"
        "0000000000000010");
  CHECK(bits_of(SegmentEnd{}, 6) == "011111");
  CHECK(bits_of(FrameEnd{{41, 24}}, 24) ==
        "111111"
        "100101000000"
        "000110");
}

TEST_CASE("the unused bits of a command's last link word are 0") {
  const auto words = words_of(set_constant, 10);
  REQUIRE(words.size() == 4);
  CHECK(words[0] == LinkWord{{0b00'0001'0010, 0, 0, 0}});
  CHECK(bits_of(words, 10) ==
        "0100100000"
        "1000000000"
        "0100101001"
        "0100000000");
}

/// Sends an instruction over a link of the given width and checks all properties of the result.
void check_arrival(const Instruction& instruction, unsigned link_width) {
  const auto words = words_of(instruction, link_width);
  const unsigned bits = expected_bits(instruction);
  RC_ASSERT(wire_bits(instruction) == bits);
  RC_ASSERT(words.size() == (bits + link_width - 1) / link_width);
  RC_ASSERT(wire_words(instruction, link_width) == words.size());
  const Command command = decoded(words, link_width);
  RC_ASSERT(std::get<Instruction>(command) == expected_of(instruction));
  RC_ASSERT(as_received(instruction) == expected_of(instruction));
  RC_ASSERT(words_of(command, link_width) == words);
}

TEST_CASE("all instructions survive encoding without origin and with reduced coefficients") {
  std::set<Opcode> sent;
  CHECK(rc::check("decode() inverts encode() on links of every width", [&] {
    for (int i = 0; i < 100; ++i) {
      const Instruction instruction = some_instruction();
      check_arrival(instruction, *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1U, 257U)));
      sent.insert(instruction.opcode);
    }
  }));
  CHECK((!csgsim::testing::draws_from_fixed_seed() || sent.size() == opcode_table.size()));
}

TEST_CASE("every width of link carries the longest and the shortest commands") {
  for (unsigned link_width = 1; link_width <= LinkWord::max_bits; ++link_width) {
    CAPTURE(link_width);
    for (const Command& command : {Command{longest}, Command{set_constant}, Command{SegmentStart{{1, 2, 3, 4}}},
                                   Command{SegmentEnd{}}, Command{FrameEnd{{4064, 32}}}}) {
      CHECK(decoded(words_of(command, link_width), link_width) == command);
      CHECK(words_of(command, link_width).size() == (wire_bits(command) + link_width - 1) / link_width);
    }
  }
}

TEST_CASE("F of an expression is unchanged by encoding and decoding") {
  CHECK(rc::check("F of the decoded expression equals F of the sent one", [] {
    const auto any = rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::int64_t>());
    Linear linear{*any >> *rc::gen::inRange(2, 63), *any >> *rc::gen::inRange(2, 63), *any >> *rc::gen::inRange(2, 63),
                  0, 0};
    linear.width = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint16_t>(1, max_linear_width + 1));
    linear.shift = *rc::gen::inRange<std::uint16_t>(0, linear.width);
    const Instruction sent{Opcode::edge_negative, {}, linear, 0, {}};
    const auto received = std::get<Instruction>(decoded(words_of(sent, 32), 32)).linear;
    for (int i = 0; i < 10; ++i) {
      const auto x = *rc::gen::inRange(0U, max_array_side);
      const auto y = *rc::gen::inRange(0U, max_array_side);
      RC_ASSERT(value_of_f(received, x, y) == value_of_f(linear, x, y));
    }
  }));
}

TEST_CASE("encoding reduces coefficients to the nearest equivalent values") {
  CHECK(reduced({-8, 7, 8, 4, 1}) == Linear{-8, 7, -8, 4, 1});
  CHECK(reduced({16, -9, 23, 4, 0}) == Linear{0, 7, 7, 4, 0});
  CHECK(reduced({1, 2, -3, 1, 0}) == Linear{-1, 0, -1, 1, 0});
}

TEST_CASE("commands follow each other over one link and start with a new word") {
  CHECK(rc::check("a stream is decoded command by command", [] {
    const auto link_width = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1U, 257U));
    std::vector<Command> sent{SegmentStart{{0, 0, 5, 7}}};
    for (int i = *rc::gen::inRange(0, 20); i > 0; --i) sent.emplace_back(as_received(some_instruction()));
    sent.insert(sent.end(), {SegmentEnd{}, FrameEnd{{7, 24}}});
    WireDecoder decoder(link_width);
    std::vector<Command> received;
    for (const Command& command : sent)
      encode(command, link_width, [&](const LinkWord& word) {
        if (const auto whole = decoder.take(word)) received.push_back(*whole);
      });
    RC_ASSERT(received == sent);
  }));
}

TEST_CASE("random words are errors or decode to commands that encode to the same words") {
  std::mt19937_64 random(1988);
  unsigned commands = 0;
  unsigned errors = 0;
  for (unsigned link_width = 1; link_width <= LinkWord::max_bits; ++link_width) {
    WireDecoder decoder(link_width);
    std::vector<LinkWord> taken;
    for (unsigned i = 0; i < 2000; ++i) {
      // Words with few ones are more often valid.
      LinkWord word;
      for (std::uint64_t& bits : word.bits) bits = random() & random() & (i % 2 == 0 ? random() & random() : ~0ULL);
      if (i % 3 == 0) word = word.slice(0, 6 + i % 40);
      taken.push_back(word.slice(0, link_width));
      try {
        if (const auto command = decoder.take(word)) {
          ++commands;
          CHECK(words_of(*command, link_width) == taken);
        }
      } catch (const InputError&) {
        ++errors;
        CHECK(decoder.is_between_commands());
      }
      if (decoder.is_between_commands()) taken.clear();
    }
  }
  CHECK(commands > 10'000);
  CHECK(errors > 10'000);
}

TEST_CASE("the decoder rejects an unknown command number and accepts the next command") {
  WireDecoder decoder(6);
  for (unsigned number = opcode_table.size(); number < 61; ++number) {
    CAPTURE(number);
    CHECK_THROWS_AS(decoder.take(LinkWord{{number, 0, 0, 0}}), InputError);
    CHECK(std::get<Instruction>(decoder.take(LinkWord{{0, 0, 0, 0}}).value()).opcode == Opcode::enable_all);
  }
}

TEST_CASE("the decoder rejects a command that no machine could execute") {
  // enable_and of an empty field; edge_negative of 0 bits, of 63 bits, and with a shift equal to the width.
  CHECK(refusal_of("110000"
                   "101000000000"
                   "000000") != "");
  CHECK(refusal_of("100100"
                   "000000"
                   "000000") != "");
  CHECK(refusal_of("100100"
                   "111111"
                   "000000" +
                   std::string(189, '0')) != "");
  CHECK(refusal_of("100100"
                   "100000"
                   "100000"
                   "000") != "");
  CHECK(refusal_of("100100"
                   "100000"
                   "000000"
                   "000")
            .empty());
  // Empty segments, and segments beyond the largest picture.
  CHECK(refusal_of("101111" + std::string(32, '0') + "1000000000000000" + "0000000000000000") != "");
  CHECK(refusal_of("101111"
                   "1000000000000000"
                   "0000000000000000"
                   "0000000000000010"
                   "1000000000000000") != "");
}

TEST_CASE("the decoder rejects ones after the end of a command") {
  CHECK(refusal_of("000000"
                   "000")
            .empty());
  CHECK(refusal_of("000000"
                   "001") != "");
  for (const unsigned bit : {22U, 56U, 199U}) {
    auto words = words_of(longest, 200);
    words.back().put(bit, 1, 1);
    WireDecoder decoder(200);
    CHECK_FALSE(decoder.take(words.front()).has_value());
    CHECK_THROWS_AS(decoder.take(words.back()), InputError);
  }
}

TEST_CASE("the decoder ignores bits beyond the width of its link") {
  WireDecoder decoder(6);
  CHECK(decoder.take(LinkWord{{0xffffffffffffffc1U, 1, 1, 1}}) ==
        Command{Instruction{Opcode::enable_invert, {}, {}, 0, {}}});
}

TEST_CASE("links have 1 to 256 bits") {
  for (const unsigned link_width : {0U, 257U}) {
    CHECK_THROWS_AS(WireDecoder{link_width}, InputError);
    CHECK_THROWS_AS(words_of(FrameEnd{}, link_width), InputError);
    CHECK_THROWS_AS(wire_words(FrameEnd{}, link_width), InputError);
  }
}

TEST_CASE("the encoder rejects values that do not fit their bits") {
  Instruction instruction = set_constant;
  instruction.constant = 0x100;
  CHECK_THROWS_AS(pack_command(instruction), std::invalid_argument);
  instruction = set_constant;
  instruction.fields[0].base = 4096;
  CHECK_THROWS_AS(pack_command(instruction), std::invalid_argument);
  CHECK_THROWS_AS(pack_command(Instruction{Opcode::skip_if_none, {}, {}, 1ULL << 32U, {}}), std::invalid_argument);
  CHECK_THROWS_AS(pack_command(Instruction{static_cast<Opcode>(opcode_table.size()), {}, {}, 0, {}}),
                  std::invalid_argument);
  CHECK_THROWS_AS(pack_command(Instruction{static_cast<Opcode>(255), {}, {}, 0, {}}), std::invalid_argument);
  CHECK_THROWS_AS(pack_command(SegmentStart{{0, 0, 65536, 1}}), std::invalid_argument);
}

}  // namespace
