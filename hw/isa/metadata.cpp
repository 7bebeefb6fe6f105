#include "hw/isa/metadata.h"

#include <fmt/format.h>

#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <type_traits>

#include "hw/isa/bytes.h"
#include "hw/isa/describe.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/quoting.h"

namespace csgsim::isa {

namespace {

using nlohmann::json;

template <class Record>
json members_by_name(const Record& record) {
  json object = json::object();
  describe(record, [&](const char* key, const auto& member) { object[key] = member; });
  return object;
}

json field_row(const NamedField& named) {
  return json::array({named.name, named.field.base, named.field.width, name_of(named.role)});
}

template <class Record>
json number_row(const Record& record) {
  json row = json::array();
  describe(record, [&](const char*, const auto& member) { row.push_back(member); });
  return row;
}

/// A row with, if there is a display model, the counts of the group's division and the number of steps.
json segment_row(const Segment& segment, bool divided) {
  json row = number_row(segment);
  if (divided) {
    for (json& number : number_row(*segment.division)) row.push_back(std::move(number));
    row.push_back(segment.division->steps.size());
  }
  row.push_back(segment.instructions.size());
  return row;
}

[[noreturn]] void malformed(std::string_view what, std::string_view expected) {
  throw MalformedBytes(fmt::format("has metadata whose {} is not {}", what, expected));
}

template <class Unsigned>
requires std::unsigned_integral<Unsigned>
void read(const json& value, std::string_view what, Unsigned& member) {
  const auto most = std::numeric_limits<Unsigned>::max();
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
    malformed(what, fmt::format("a number of 0 to {}", most));
  member = value.get<Unsigned>();
}

void read(const json& value, std::string_view what, bool& member) {
  if (!value.is_boolean()) malformed(what, "true or false");
  member = value.get<bool>();
}

void read(const json& value, std::string_view what, double& member) {
  if (!value.is_number()) malformed(what, "a number");
  member = value.get<double>();
}

void read(const json& value, std::string_view what, std::string& member) {
  if (!value.is_string()) malformed(what, "a string");
  member = value.get<std::string>();
}

void read(const json& value, std::string_view what, FieldRole& member) {
  std::string name;
  read(value, what, name);
  const auto found = std::find(field_role_names.begin(), field_role_names.end(), name);
  if (found == field_role_names.end()) malformed(what, "a field role");
  member = static_cast<FieldRole>(found - field_role_names.begin());
}

const json& require_member(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw MalformedBytes(fmt::format("has metadata without {}", key));
  return *found;
}

/// The elements of an array, which must have `size` elements.
const json& require_row(const json& value, std::string_view what, std::size_t size) {
  if (!value.is_array() || value.size() != size) malformed(what, fmt::format("a list of {}", size));
  return value;
}

void read(const json& value, std::string_view what, NamedField& named) {
  const json& row = require_row(value, what, 4);
  read(row[0], what, named.name);
  read(row[1], what, named.field.base);
  read(row[2], what, named.field.width);
  read(row[3], what, named.role);
}

void read(const json& value, std::string_view what, RowExtent& extent) {
  const json& row = require_row(value, what, 2);
  read(row[0], what, extent.first);
  read(row[1], what, extent.last);
}

/// Number of counts of a Preparation before `products` and `quotients` were added; such rows stay readable.
constexpr std::size_t first_counts = 8;

/// A record stored as a row of its members in order.
template <class Record>
requires std::same_as<Record, DivisionStep> || std::same_as<Record, Preparation> || std::same_as<Record, PruningFacts>
void read(const json& value, std::string_view what, Record& record) {
  std::size_t members = 0;
  describe(record, [&](const char*, auto&) { ++members; });
  const bool is_first = std::same_as<Record, Preparation> && value.is_array() && value.size() == first_counts;
  if (is_first) members = first_counts;
  const json& row = require_row(value, what, members);
  std::size_t column = 0;
  describe(record, [&](const char* key, auto& member) {
    if (column < members) read(row[column++], key, member);
  });
}

template <class Element>
void read(const json& value, std::string_view what, std::vector<Element>& member) {
  if (!value.is_array()) malformed(what, "a list");
  for (const json& element : value) read(element, what, member.emplace_back());
}

/// Reads the number of pieces of each primitive.
void read_pieces(const json& value, Facts& facts) {
  std::vector<std::uint32_t> counts;
  read(value, "pieces", counts);
  const std::uint64_t all = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  const bool has_none = std::find(counts.begin(), counts.end(), 0U) != counts.end();
  if (has_none || counts.size() != facts.primitives.size() || all > max_pieces)
    malformed("pieces", fmt::format("a number above 0 for each primitive, at most {} in total", max_pieces));
  set_piece_counts(counts, facts);
}

/// Counts in a segment's row that are not stored in the segment.
struct SegmentSizes {
  std::uint64_t steps = 0;
  std::uint64_t instructions = 0;
};

SegmentSizes read_segment(const json& value, bool divided, Segment& segment) {
  std::size_t members = 0;
  const auto add = [&](const char*, auto&) { ++members; };
  describe(segment, add);
  if (divided) {
    describe(*segment.division, add);
    ++members;
  }
  const json& row = require_row(value, "segments", members + 1);
  std::size_t column = 0;
  const auto take = [&](const char* key, auto& member) { read(row[column++], key, member); };
  describe(segment, take);
  SegmentSizes sizes;
  if (divided) {
    describe(*segment.division, take);
    take("step count", sizes.steps);
  }
  take("instruction count", sizes.instructions);
  return sizes;
}

/// Distributes the steps to the segments by the counts of their rows.
void distribute(const std::vector<DivisionStep>& steps, std::span<const std::uint64_t> counts, Program& program) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > steps.size() - next) malformed("number of steps", "the sum of the segments' step counts");
    const auto first = steps.begin() + static_cast<std::ptrdiff_t>(next);
    program.segments[i].division->steps.assign(first, first + static_cast<std::ptrdiff_t>(counts[i]));
    next += static_cast<std::size_t>(counts[i]);
  }
  if (next != steps.size()) malformed("number of steps", "the sum of the segments' step counts");
}

/// One row for the frame and one per segment; null if nothing was counted.
json preparation_rows(const Program& program) {
  bool any = *program.preparation != Preparation{};
  json rows = json::array({number_row(*program.preparation)});
  for (const Segment& segment : program.segments) {
    any = any || *segment.preparation != Preparation{};
    rows.push_back(number_row(*segment.preparation));
  }
  return any ? rows : json();
}

void distribute(const std::vector<Preparation>& rows, Program& program) {
  if (rows.size() != program.segments.size() + 1)
    malformed("preparation", "one row for the frame and one for each segment");
  *program.preparation = rows.front();
  for (std::size_t i = 0; i < program.segments.size(); ++i) *program.segments[i].preparation = rows[i + 1];
}

/// Rejects nesting deeper than encode_metadata() writes, which bounds the recursion of the CBOR reader.
class DepthGuard : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return false; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return ++depth_ <= deepest; }
  bool end_object() override { return depth_-- > 0; }
  bool start_array(std::size_t) override { return ++depth_ <= deepest; }
  bool end_array() override { return depth_-- > 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  static constexpr int deepest = 3;
  int depth_ = 0;
};

/// Rejects indefinite-length strings, which encode_metadata() never writes: the CBOR reader recurses for each chunk,
/// and chunks may nest. A flat scan suffices because the items of CBOR follow one another at any nesting depth.
void refuse_indefinite_strings(std::span<const std::byte> cbor) {
  constexpr unsigned bytes_major = 2;
  constexpr unsigned text_major = 3;
  constexpr unsigned first_long = 24;  // the argument follows in 1, 2, 4 or 8 bytes
  constexpr unsigned last_long = 27;
  constexpr unsigned indefinite_length = 31;
  ByteReader in(cbor);
  while (in.left() > 0) {
    const unsigned head = in.byte();
    const unsigned major = head >> 5U;
    std::uint64_t argument = head & 0x1fU;
    const bool is_string = major == bytes_major || major == text_major;
    if (is_string && argument == indefinite_length)
      throw MalformedBytes("has metadata with an indefinite-length string");
    if (argument >= first_long && argument <= last_long) {
      const unsigned size = 1U << (argument - first_long);
      argument = 0;
      for (unsigned i = 0; i < size; ++i) argument = argument << 8U | in.byte();
    }
    if (is_string) in.block(argument);
  }
}

json parse_cbor(std::span<const std::byte> cbor) {
  refuse_indefinite_strings(cbor);
  const auto* begin = reinterpret_cast<const std::uint8_t*>(cbor.data());
  const auto* end = begin + cbor.size();
  DepthGuard guard;
  if (!json::sax_parse(begin, end, &guard, json::input_format_t::cbor))
    throw MalformedBytes("has metadata that is not CBOR as csgsim writes it");
  json parsed = json::from_cbor(begin, end, true, false);
  if (!parsed.is_object()) throw MalformedBytes("has metadata that is not a map");
  return parsed;
}

/// Converts metadata of the oldest readable version to the current one. The old version records no machine, stores the
/// background in the compile record, and displays the field with the role colour.
json upgraded(json root) {
  json shown{{"colour_base", 0},
             {"colour_bits", 0},
             {"background", require_member(require_member(root, "compile"), "background")}};
  std::vector<NamedField> fields;
  read(require_member(root, "fields"), "fields", fields);
  const auto colour = std::ranges::find(fields, FieldRole::colour, &NamedField::role);
  if (colour != fields.end()) {
    shown["colour_base"] = colour->field.base;
    shown["colour_bits"] = colour->field.width;
  }
  root["frame"] = std::move(shown);
  root["machine"] = members_by_name(MachineRecord{});
  return root;
}

}  // namespace

std::vector<std::uint8_t> encode_metadata(const Program& program) {
  json root = json::object();
  describe_header(program, [&](const char* name, const auto& record) { root[name] = members_by_name(record); });
  root["primitives"] = program.facts->primitives;
  if (!program.facts->primitive_of_piece.empty()) root["pieces"] = piece_counts(*program.facts);
  json& fields = root["fields"] = json::array();
  for (const NamedField& named : program.facts->fields) fields.push_back(field_row(named));
  if (!program.extents.empty()) {
    json& extents = root["extents"] = json::array();
    for (const RowExtent& extent : program.extents) extents.push_back({extent.first, extent.last});
  }
  json& segments = root["segments"] = json::array();
  const bool divided = !program.display_model.empty();
  for (const Segment& segment : program.segments) segments.push_back(segment_row(segment, divided));
  if (divided) {
    root["display_model"] = hexadecimal(program.display_model);
    json& steps = root["steps"] = json::array();
    for (const Segment& segment : program.segments)
      for (const DivisionStep& step : segment.division->steps) steps.push_back(number_row(step));
  }
  if (json rows = preparation_rows(program); !rows.is_null()) root["preparation"] = std::move(rows);
  if (*program.model_preparation != Preparation{}) root["model_preparation"] = number_row(*program.model_preparation);
  if (!program.facts->prunings.empty()) {
    json& prunings = root["prunings"] = json::array();
    for (const PruningFacts& pruning : program.facts->prunings) prunings.push_back(number_row(pruning));
  }
  return json::to_cbor(root);
}

Metadata decode_metadata(std::span<const std::byte> cbor, bool names_machine) {
  const json root = names_machine ? parse_cbor(cbor) : upgraded(parse_cbor(cbor));
  Metadata metadata;
  Program& program = metadata.program;
  describe_header(program, [&](const char* name, auto& record) {
    const json& object = require_member(root, name);
    if (!object.is_object()) malformed(name, "a map");
    describe(record, [&](const char* key, auto& member) { read(require_member(object, key), key, member); });
  });
  read(require_member(root, "primitives"), "primitives", program.facts->primitives);
  if (const auto pieces = root.find("pieces"); pieces != root.end()) read_pieces(*pieces, *program.facts);
  read(require_member(root, "fields"), "fields", program.facts->fields);
  if (const auto extents = root.find("extents"); extents != root.end()) read(*extents, "extents", program.extents);
  if (const auto model = root.find("display_model"); model != root.end()) {
    std::string digits;
    read(*model, "display_model", digits);
    const auto bytes = parse_hexadecimal(digits);
    if (!bytes || bytes->empty()) malformed("display_model", "hexadecimal digits, two per byte");
    program.display_model = *bytes;
  }
  const json& segments = require_member(root, "segments");
  if (!segments.is_array()) malformed("segments", "a list");
  const bool divided = !program.display_model.empty();
  std::vector<std::uint64_t> step_counts;
  for (const json& row : segments) {
    const SegmentSizes sizes = read_segment(row, divided, program.segments.emplace_back());
    metadata.instruction_counts.push_back(sizes.instructions);
    step_counts.push_back(sizes.steps);
  }
  if (divided) {
    std::vector<DivisionStep> steps;
    read(require_member(root, "steps"), "steps", steps);
    distribute(steps, step_counts, program);
  }
  if (const auto found = root.find("preparation"); found != root.end()) {
    std::vector<Preparation> rows;
    read(*found, "preparation", rows);
    distribute(rows, program);
  }
  if (const auto found = root.find("model_preparation"); found != root.end())
    read(*found, "model_preparation", *program.model_preparation);
  if (const auto found = root.find("prunings"); found != root.end()) read(*found, "prunings", program.facts->prunings);
  return metadata;
}

}  // namespace csgsim::isa
