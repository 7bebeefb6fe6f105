#include "hw/multi_processor/records.h"

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <numeric>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/division/encoding.h"
#include "hw/division/stream_parts.h"

namespace csgsim::multi_processor {

namespace {

using division::BitReader;
using division::BitWriter;
using division::DisplayModel;
using division::Primitive;
using division::Widths;

constexpr unsigned background_bits = 32;
constexpr unsigned max_bits = 64;  ///< maximum width of a number

/// Widths of a valid model are within these limits, and a coefficient has at least one bit.
void put(BitWriter& out, std::uint64_t value, unsigned width) { out.put(value, std::min(width, max_bits)); }
void put_signed(BitWriter& out, std::int64_t value, unsigned width) {
  out.put_signed(value, std::clamp(width, 1U, max_bits));
}

/// Format that follows from the model's widths and the number of its primitives.
RecordFormat format_of(const Widths& widths, std::uint64_t primitives) {
  const std::uint64_t last = primitives == 0 ? 0 : primitives - 1;
  return {.depth = widths.depth,
          .colour = widths.colour,
          .slope = widths.slope,
          .constant = widths.constant,
          .halfspaces = widths.halfspaces,
          .operands = widths.operands,
          .index = std::max(1U, static_cast<unsigned>(std::bit_width(last))),
          .primitives = std::max(1U, static_cast<unsigned>(std::bit_width(primitives)))};
}

RecordFormat format_of(const DisplayModel& model) { return format_of(widths_of(model), model.primitives.size()); }

division::Bits header_record(const DisplayModel& model, const RecordFormat& format) {
  BitWriter out;
  out.put(model.primitives.size(), Widths::count);
  out.put(model.nodes.size(), Widths::count);
  put_sampling(out, model);
  for (const unsigned width : {format.slope, format.constant, format.halfspaces}) out.put(width, Widths::width);
  out.put(format.operands, Widths::bits);
  put_fields(out, model.fields);
  out.put(model.background, background_bits);
  return out.take();
}

division::Bits primitive_record(const Primitive& one, const RecordFormat& format) {
  BitWriter out;
  put_box(out, one.box, format.depth);
  out.put(one.complemented ? 1 : 0, 1);
  out.put(one.joined ? 1 : 0, 1);
  put(out, one.near_colour, format.colour);
  return out.take();
}

division::Bits node_record(const division::Node& node, const RecordFormat& format) {
  BitWriter out;
  out.put(node.operands == 0 ? 0 : 1, 1);
  out.put(node.op == division::Operator::intersect ? 1 : 0, 1);
  put(out, node.operands, format.operands);
  return out.take();
}

division::Bits halfspace_record(const DisplayModel& model, const division::Halfspace& one, const RecordFormat& format) {
  BitWriter out;
  const division::Plane& plane = model.planes[one.plane];
  out.put(plane.is_edge ? 1 : 0, 1);
  out.put(one.forward ? 1 : 0, 1);
  put_signed(out, plane.a, format.slope);
  put_signed(out, plane.b, format.slope);
  put_signed(out, plane.c, format.constant);
  put(out, one.colour, format.colour);
  return out.take();
}

/// A number that forms a separate record.
struct Number {
  std::uint64_t value = 0;
  unsigned width = 0;
};

division::Bits numbers_record(std::initializer_list<Number> numbers) {
  BitWriter out;
  for (const Number& one : numbers) put(out, one.value, one.width);
  return out.take();
}

void require(bool holds, const char* what) {
  if (!holds) throw InputError(std::string("invalid records on the bus: ") + what);
}

ReadHalfspace take_halfspace(BitReader& in, const RecordFormat& format) {
  ReadHalfspace read;
  read.plane.is_edge = in.take(1) != 0;
  read.halfspace.forward = in.take(1) != 0;
  read.plane.a = in.take_signed(format.slope);
  read.plane.b = in.take_signed(format.slope);
  read.plane.c = in.take_signed(format.constant);
  read.halfspace.colour = static_cast<std::uint32_t>(in.take(format.colour));
  return read;
}

}  // namespace

unsigned RecordFormat::primitive_record() const { return 4 * Widths::side + 2 * depth + 2 + colour; }

std::array<unsigned, 6> RecordFormat::box_numbers() const {
  return {Widths::side, Widths::side, Widths::side, Widths::side, depth, depth};
}

Records frame_records(const DisplayModel& model) {
  const RecordFormat format = format_of(model);
  Records records{header_record(model, format)};
  for (const Primitive& one : model.primitives) records.push_back(primitive_record(one, format));
  for (const division::Node& node : model.nodes) records.push_back(node_record(node, format));
  return records;
}

Records segment_records(const DisplayModel& model, const division::Candidates& survivors) {
  Records records = segment_records_without_halfspaces(model, survivors);
  auto next = records.begin();
  for (const std::uint32_t index : survivors.primitives) {
    ++next;
    for (std::uint32_t number = 0; number < survivors.halfspaces[index].size(); ++number)
      next = records.insert(next + 1, halfspace_record(model, survivors, {index, number}));
  }
  return records;
}

Records segment_records_without_halfspaces(const DisplayModel& model, const division::Candidates& survivors) {
  const RecordFormat format = format_of(model);
  Records records{numbers_record({{survivors.primitives.size(), format.primitives}})};
  for (const std::uint32_t index : survivors.primitives) {
    const std::uint64_t own = survivors.halfspaces[index].size();
    records.push_back(numbers_record({{index, format.index}, {own, format.halfspaces}}));
  }
  return records;
}

void append_word(BitWriter& bits, const isa::LinkWord& word, unsigned word_bits) {
  for (unsigned at = 0; at < word_bits; at += max_bits) {
    const unsigned count = std::min(max_bits, word_bits - at);
    bits.put(word.number(at, count), count);
  }
}

HalfspaceId decode_request(const DisplayModel& model, const division::Candidates& survivors,
                           const division::Bits& request) {
  const RecordFormat format = format_of(model);
  BitReader in(request);
  HalfspaceId id;
  id.primitive = static_cast<std::uint32_t>(in.take(format.index));
  id.number = static_cast<std::uint32_t>(in.take(format.halfspaces));
  require(id.primitive < survivors.halfspaces.size() && id.number < survivors.halfspaces[id.primitive].size(),
          "request for a half-space that does not remain in the segment");
  return id;
}

division::Bits halfspace_record(const DisplayModel& model, const division::Candidates& survivors,
                                const HalfspaceId& id) {
  const std::uint32_t number = survivors.halfspaces[id.primitive][id.number];
  return halfspace_record(model, model.primitives[id.primitive].halfspaces[number], format_of(model));
}

void RecordReader::begin_frame() {
  model_ = {};
  frame_words_ = segment_words_ = 0;
  expect_record(Record::header);
}

void RecordReader::begin_segment(bool with_halfspaces) {
  with_halfspaces_ = with_halfspaces;
  segment_words_ = 0;
  model_.planes.clear();
  for (division::Primitive& primitive : model_.primitives) primitive.halfspaces.clear();
  survivors_ = {};
  survivors_.halfspaces.resize(model_.primitives.size());
  survivors_.listed.assign(model_.primitives.size(), false);
  expect_record(Record::count);
}

void RecordReader::take(const isa::LinkWord& word) {
  require(!is_complete(), "word after the last record");
  for (unsigned at = 0; at < word_bits_ && missing_bits_ > 0;) {
    const unsigned count = std::min({64U, word_bits_ - at, missing_bits_});
    gathered_.put(word.number(at, count), count);
    at += count;
    missing_bits_ -= count;
  }
  if (missing_bits_ > 0) return;
  const division::Bits bits = gathered_.take();
  BitReader in(bits);
  read_record(in);
  await_next();
}

void RecordReader::expect_record(Record record) {
  next_ = record;
  gathered_ = {};
  missing_bits_ = bits_of(record);
}

/// The next record is of the first kind that is still to be received.
void RecordReader::await_next() {
  const bool of_frame = next_ == Record::header || next_ == Record::primitive || next_ == Record::node;
  (of_frame ? frame_words_ : segment_words_) += quotient_up(bits_of(next_), memory_word_bits_);
  if (of_frame) {
    if (model_.primitives.size() < primitives_) return expect_record(Record::primitive);
    if (model_.nodes.size() < nodes_) return expect_record(Record::node);
  } else {
    if (halfspaces_to_come_ > 0) return expect_record(Record::halfspace);
    if (primitives_to_come_ > 0) return expect_record(Record::survivor);
  }
  expect_record(Record::none);
  division::validate(model_);
}

unsigned RecordReader::bits_of(Record record) const {
  switch (record) {
    case Record::none: return 0;
    case Record::header: return RecordFormat::header;
    case Record::primitive: return format_.primitive_record();
    case Record::node: return format_.node_record();
    case Record::count: return format_.count_record();
    case Record::survivor: return format_.survivor_record();
    case Record::halfspace: return format_.halfspace_record();
  }
  return 0;
}

void RecordReader::read_record(BitReader& in) {
  switch (next_) {
    case Record::none: return;
    case Record::header: return read_header(in);
    case Record::primitive: return read_primitive(in);
    case Record::node: return read_node(in);
    case Record::count: primitives_to_come_ = in.take(format_.primitives); return;
    case Record::survivor: return read_survivor(in);
    case Record::halfspace: return read_halfspace(in);
  }
}

void RecordReader::read_header(BitReader& in) {
  primitives_ = in.take(Widths::count);
  nodes_ = in.take(Widths::count);
  take_sampling(in, model_);
  Widths widths;
  widths.slope = static_cast<unsigned>(in.take(Widths::width));
  widths.constant = static_cast<unsigned>(in.take(Widths::width));
  widths.halfspaces = static_cast<unsigned>(in.take(Widths::width));
  widths.operands = static_cast<unsigned>(in.take(Widths::bits));
  widths.depth = model_.z_bits + 1;
  widths.colour = model_.colour_bits;
  format_ = format_of(widths, primitives_);
  model_.fields = division::take_fields(in, model_.z_bits, model_.colour_bits);
  model_.background = static_cast<std::uint32_t>(in.take(background_bits));
}

void RecordReader::read_primitive(BitReader& in) {
  Primitive one;
  one.box = division::take_box(in, format_.depth);
  one.complemented = in.take(1) != 0;
  one.joined = in.take(1) != 0;
  one.near_colour = static_cast<std::uint32_t>(in.take(format_.colour));
  model_.primitives.push_back(std::move(one));
}

void RecordReader::read_node(BitReader& in) {
  const bool is_operator = in.take(1) != 0;
  const auto op = in.take(1) != 0 ? division::Operator::intersect : division::Operator::unite;
  const auto operands = static_cast<std::uint32_t>(in.take(format_.operands));
  require(is_operator == (operands > 0), "leaf with operands, or operator without operands");
  model_.nodes.push_back({operands, op});
}

void RecordReader::read_survivor(BitReader& in) {
  const auto index = static_cast<std::uint32_t>(in.take(format_.index));
  halfspaces_to_come_ = in.take(format_.halfspaces);
  --primitives_to_come_;
  require(index < model_.primitives.size() && (survivors_.primitives.empty() || index > survivors_.primitives.back()),
          "primitive out of order");
  survivors_.primitives.push_back(index);
  survivors_.listed[index] = true;
  if (with_halfspaces_) return;
  survivors_.halfspaces[index].resize(static_cast<std::size_t>(halfspaces_to_come_));
  std::iota(survivors_.halfspaces[index].begin(), survivors_.halfspaces[index].end(), 0U);
  halfspaces_to_come_ = 0;
}

void RecordReader::read_halfspace(BitReader& in) {
  --halfspaces_to_come_;
  ReadHalfspace read = take_halfspace(in, format_);
  const std::uint32_t primitive = survivors_.primitives.back();
  std::vector<division::Halfspace>& own = model_.primitives[primitive].halfspaces;
  survivors_.halfspaces[primitive].push_back(static_cast<std::uint32_t>(own.size()));
  read.halfspace.plane = static_cast<std::uint32_t>(model_.planes.size());
  own.push_back(read.halfspace);
  model_.planes.push_back(read.plane);
}

division::Bits RecordReader::encode_request(const HalfspaceId& id) const {
  return numbers_record({{id.primitive, format_.index}, {id.number, format_.halfspaces}});
}

ReadHalfspace RecordReader::decode_halfspace(const division::Bits& record) const {
  BitReader in(record);
  return take_halfspace(in, format_);
}

}  // namespace csgsim::multi_processor
