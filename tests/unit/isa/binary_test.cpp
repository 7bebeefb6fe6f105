#include "hw/isa/binary.h"

#include <rapidcheck.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include "hw/isa/bytes.h"
#include "hw/isa/extents.h"
#include "hw/isa/facts.h"
#include "hw/isa/field_role.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/metadata.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program_file.h"
#include "places.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

using namespace test;

using Bytes = std::vector<std::byte>;

constexpr std::size_t checksum_size = 4;

/// Replaces the checksum of modified bytes with the correct one.
void seal(Bytes& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size() - checksum_size);
  for (std::size_t i = 0; i < checksum_size; ++i)
    bytes[bytes.size() - checksum_size + i] = static_cast<std::byte>(crc.checksum() >> 8U * i);
}

/// Asserts that decode() either rejects the bytes or returns a valid Program.
void check_valid_or_rejected(const Bytes& bytes) {
  Program program;
  if (refusal([&] { program = decode(bytes, "p.csgt"); }).empty()) validate(program);
}

TEST_CASE("the sample Program survives a binary round trip") {
  CHECK(decode(encode(sample_program()), "p.csgt") == sample_program());
}

TEST_CASE("every Program survives a binary round trip") {
  CHECK(rc::check("decode() inverts encode()", [] {
    const auto program = *test::arbitrary_program({37, 20, 72}, 60, 2);
    RC_ASSERT(decode(encode(program), "p.csgt") == program);
  }));
}

TEST_CASE("Programs of the previous version without machine record or extents are read") {
  const std::string folder = std::string(CSGSIM_SOURCE_DIR) + "/tests/fuzz/corpus/program_binary/";
  const Program lines = load_program(folder + "one_lines.csgt");
  CHECK(lines.machine == MachineRecord{});
  CHECK(lines.colour.width == 24);
  CHECK(lines.colour == find_field(lines, FieldRole::colour));
  CHECK(lines.background == 0xffffe5);
  CHECK(lines.extents.size() == 1);
  CHECK(lines.extents == compute_row_extents(lines.segments));
  CHECK(load_program(folder + "one_squares.csgt").extents.empty());
  CHECK(decode(encode(lines), "p.csgt") == lines);
}

TEST_CASE("an instruction with a linear expression takes fewer than 14 bytes") {
  Program program = sample_program();
  const std::size_t before = encode(program).size();
  for (int i = 0; i < 1000; ++i)
    program.segments[0].instructions.push_back({Opcode::keep_max, {{{0, 20}}}, {4096, -300, 99999, 35, 12}, 0, {}});
  CHECK(encode(program).size() - before < 1000 * 14);
}

TEST_CASE("varints of the binary form survive a round trip") {
  for (const std::int64_t value :
       {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1}, std::int64_t{63}, std::int64_t{-64},
        std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    ByteWriter out;
    out.varint(zigzag(value));
    ByteReader in(out.written());
    CHECK(unzigzag(in.varint()) == value);
    CHECK(in.left() == 0);
  }
  CHECK(zigzag(-1) == 1);
  CHECK(zigzag(1) == 2);
}

TEST_CASE("a varint of more than 64 bits is rejected") {
  const Bytes bytes(10, std::byte{0xff});
  ByteReader in(bytes);
  CHECK_THROWS_AS(in.varint(), MalformedBytes);
}

TEST_CASE("decode() rejects a file with any flipped bit") {
  const Bytes sound = encode(sample_program());
  for (std::size_t i = 0; i < sound.size(); ++i)
    for (unsigned bit = 0; bit < 8; ++bit) {
      Bytes damaged = sound;
      damaged[i] ^= static_cast<std::byte>(1U << bit);
      CHECK_FALSE(refusal([&] { decode(damaged, "p.csgt"); }).empty());
    }
}

TEST_CASE("decode() rejects any truncation even with a correct checksum") {
  const Bytes sound = encode(sample_program());
  for (std::size_t size = 0; size < sound.size(); ++size) {
    Bytes shortened(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(size));
    CHECK(refusal([&] { decode(shortened, "p.csgt"); }).starts_with("p.csgt: "));
    if (size < 9) continue;
    seal(shortened);
    CHECK_FALSE(refusal([&] { decode(shortened, "p.csgt"); }).empty());
  }
}

TEST_CASE("a Program with one hostile byte and a correct checksum is valid or rejected") {
  const Bytes sound = encode(sample_program());
  for (std::size_t i = 5; i + checksum_size < sound.size(); ++i)
    for (const unsigned value : {0x00U, 0x01U, 0x7fU, 0x80U, 0x9bU, 0xbfU, 0xffU}) {
      Bytes hostile = sound;
      hostile[i] = static_cast<std::byte>(value);
      seal(hostile);
      check_valid_or_rejected(hostile);
    }
}

TEST_CASE("a randomly corrupted Program with a correct checksum is valid or rejected") {
  const Bytes sound = encode(sample_program());
  CHECK(rc::check("decode() returns a valid Program or an error", [&sound] {
    Bytes hostile = sound;
    const auto changes = *rc::gen::inRange(1, 12);
    for (int i = 0; i < changes; ++i) {
      const auto place =
          *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(5, hostile.size() - checksum_size));
      hostile[place] = static_cast<std::byte>(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 256)));
    }
    seal(hostile);
    check_valid_or_rejected(hostile);
  }));
}

TEST_CASE("random bytes after a Program's header are a valid Program or rejected") {
  CHECK(rc::check("decode() returns a valid Program or an error", [] {
    const auto noise = *rc::gen::container<std::vector<std::uint8_t>>(
        rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint8_t>()));
    ByteWriter out;
    for (const char c : {'C', 'S', 'G', 'T', '\x02'}) out.byte(static_cast<std::uint8_t>(c));
    out.block(noise);
    out.block(std::vector<std::uint8_t>(checksum_size));
    Bytes bytes = out.take();
    seal(bytes);
    check_valid_or_rejected(bytes);
  }));
}

/// A file without instructions and with the given metadata.
Bytes file_of(const std::vector<std::uint8_t>& metadata) {
  ByteWriter out;
  for (const char c : {'C', 'S', 'G', 'T', '\x02'}) out.byte(static_cast<std::uint8_t>(c));
  out.varint(metadata.size());
  out.block(metadata);
  out.block(std::vector<std::uint8_t>(checksum_size));
  Bytes bytes = out.take();
  seal(bytes);
  return bytes;
}

TEST_CASE("metadata nested a million deep is rejected without overflowing the stack") {
  constexpr std::size_t depth = 1000000;
  const Bytes arrays = file_of(std::vector<std::uint8_t>(depth, 0x81));
  CHECK(contains(refusal([&] { decode(arrays, "p.csgt"); }), "not CBOR"));
  for (const std::uint8_t in_pieces : {std::uint8_t{0x7f}, std::uint8_t{0x5f}}) {
    const Bytes strings = file_of(std::vector<std::uint8_t>(depth, in_pieces));
    CHECK(contains(refusal([&] { decode(strings, "p.csgt"); }), "an indefinite-length string"));
  }
}

TEST_CASE("decode() finds an indefinite-length string after items of every kind") {
  const std::vector<std::uint8_t> items{0x18, 0xff, 0x39, 1,    2,    0x1b, 1,    2,    3,    4,    5,    6,
                                        7,    8,    0x62, 'a',  0x7f, 0x42, 0x7f, 0x7f, 0x82, 0xa1, 0xc1, 0xf4,
                                        0xf9, 0x7f, 0x7f, 0xfb, 1,    2,    3,    4,    5,    6,    7,    0x7f};
  CHECK_FALSE(contains(refusal([&] { decode(file_of(items), "p.csgt"); }), "indefinite-length string"));
  std::vector<std::uint8_t> one_more = items;
  one_more.push_back(0x7f);
  CHECK(contains(refusal([&] { decode(file_of(one_more), "p.csgt"); }), "indefinite-length string"));
}

TEST_CASE("each error in a binary Program has a specific message") {
  Bytes bytes = encode(sample_program());
  const auto current_error = [&] { return refusal([&] { decode(bytes, "p.csgt"); }); };

  bytes.back() ^= std::byte{1};
  CHECK(contains(current_error(), "p.csgt: is damaged: its checksum does not match; "));

  bytes[4] = std::byte{9};
  CHECK(contains(current_error(), "format version 9"));

  bytes.resize(5 + checksum_size);
  CHECK(contains(current_error(), "format version 9"));
  bytes.resize(4 + checksum_size);
  CHECK(contains(current_error(), "ends too soon"));

  bytes[0] = std::byte{'X'};
  CHECK(contains(current_error(), "does not begin with CSGT"));

  bytes = encode(sample_program());
  bytes.insert(bytes.end() - checksum_size, std::byte{0});
  seal(bytes);
  CHECK(contains(current_error(), "1 bytes after its end"));

  bytes = encode(sample_program());
  bytes[bytes.size() - checksum_size - 1] = std::byte{0x80 | opcode_table.size()};  // opcode of the last instruction
  seal(bytes);
  CHECK(contains(current_error(), "undefined opcode " + std::to_string(opcode_table.size())));
}

TEST_CASE("a count beyond the available bytes is rejected before memory is allocated") {
  Bytes bytes = encode(sample_program());
  // The instruction count of the first segment, 9, is the last element of its row: 0x09 before the next row's 0x8a.
  constexpr std::array pattern{std::byte{0x09}, std::byte{0x8a}};
  const auto row = std::search(bytes.begin(), bytes.end(), pattern.begin(), pattern.end());
  REQUIRE(row != bytes.end());
  *row = std::byte{0x17};
  seal(bytes);
  CHECK(contains(refusal([&] { decode(bytes, "p.csgt"); }), "ends too soon"));
}

TEST_CASE("an invalid Program is rejected when it is read") {
  Program program = sample_program();
  program.segments[0].instructions[3].linear.width = 3;
  CHECK(refusal([&] { decode(encode(program), "p.csgt"); }).starts_with("p.csgt: segment 0, instruction 3: "));
}

}  // namespace

TEST_CASE("reads Programs from before products, quotients and the model's work were counted") {
  isa::Program program;
  program.shape = {8, 8, 16};
  program.segments.push_back({.region = {0, 0, 8, 8}, .instructions = {}});
  *program.preparation = {.planes = 1, .nodes = 2, .products = 3, .quotients = 4};
  *program.model_preparation = {.supports = 5};
  program.facts->prunings.push_back({.name = "space", .tried = 6});
  nlohmann::json root = nlohmann::json::from_cbor(isa::encode_metadata(program));
  for (nlohmann::json& row : root["preparation"]) row.erase(row.begin() + 8, row.end());
  root.erase("model_preparation");
  root.erase("prunings");
  const std::vector<std::uint8_t> old = nlohmann::json::to_cbor(root);
  const isa::Program read = isa::decode_metadata(std::as_bytes(std::span(old)), true).program;
  CHECK(*read.preparation == isa::Preparation{.planes = 1, .nodes = 2});
  CHECK(*read.model_preparation == isa::Preparation{});
  CHECK(read.facts->prunings.empty());
  root["preparation"][0].erase(7);
  const std::vector<std::uint8_t> bad = nlohmann::json::to_cbor(root);
  CHECK_THROWS_AS(isa::decode_metadata(std::as_bytes(std::span(bad)), true), MalformedBytes);
}
