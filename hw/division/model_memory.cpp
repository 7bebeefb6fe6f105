#include "hw/division/model_memory.h"

#include <algorithm>

#include "hw/base/quotient.h"
#include "hw/division/stream_parts.h"

namespace csgsim::division {

namespace {

constexpr unsigned max_chunk_bits = 64;

unsigned primitive_bits(const Widths& widths) { return widths.primitive_record() + widths.colour; }
unsigned halfspace_bits(const Widths& widths) { return widths.halfspace_record() + widths.colour; }

Bits record_of(const Primitive& one, const Widths& widths) {
  BitWriter out;
  put_box(out, one.box, widths.depth);
  out.put(one.complemented ? 1 : 0, 1);
  out.put(one.joined ? 1 : 0, 1);
  out.put(one.near_colour, widths.colour);
  out.put(one.halfspaces.size(), widths.halfspaces);
  return out.take();
}

Bits record_of(const Halfspace& one, const Widths& widths) {
  BitWriter out;
  out.put(one.plane, widths.plane);
  out.put(one.forward ? 1 : 0, 1);
  out.put(one.colour, widths.colour);
  return out.take();
}

Bits record_of(const Plane& one, const Widths& widths) {
  BitWriter out;
  out.put(one.is_edge ? 1 : 0, 1);
  out.put_signed(one.a, widths.slope);
  out.put_signed(one.b, widths.slope);
  out.put_signed(one.c, widths.constant);
  return out.take();
}

}  // namespace

ModelMemory::ModelMemory(const DisplayModel& model, unsigned word_bits)
    : word_bits_(word_bits),
      widths_(widths_of(model)),
      primitives_{quotient_up(std::uint64_t{primitive_bits(widths_)}, word_bits), {}},
      halfspaces_{quotient_up(std::uint64_t{halfspace_bits(widths_)}, word_bits), {}},
      planes_{quotient_up(std::uint64_t{widths_.plane_record()}, word_bits), {}} {
  std::size_t first = 0;
  for (const Primitive& one : model.primitives) {
    add(record_of(one, widths_), primitives_);
    for (const Halfspace& halfspace : one.halfspaces) add(record_of(halfspace, widths_), halfspaces_);
    first_halfspaces_.push_back(first);
    first += one.halfspaces.size();
  }
  for (const Plane& plane : model.planes) add(record_of(plane, widths_), planes_);
}

void ModelMemory::add(const Bits& record, Records& records) const {
  const std::vector<isa::LinkWord> words = to_link(record, word_bits_);
  records.words.insert(records.words.end(), words.begin(), words.end());
}

Bits ModelMemory::read(const Records& records, std::size_t index) const {
  BitWriter out;
  for (std::size_t i = 0; i < records.record_words; ++i) {
    const isa::LinkWord& word = records.words[index * static_cast<std::size_t>(records.record_words) + i];
    for (unsigned at = 0; at < word_bits_; at += max_chunk_bits) {
      const unsigned count = std::min(max_chunk_bits, word_bits_ - at);
      out.put(word.number(at, count), count);
    }
  }
  return out.take();
}

PrimitiveHead ModelMemory::primitive(std::uint32_t index) const {
  const Bits record = read(primitives_, index);
  BitReader in(record);
  PrimitiveHead head;
  head.box = take_box(in, widths_.depth);
  head.complemented = in.take(1) != 0;
  head.joined = in.take(1) != 0;
  head.near_colour = static_cast<std::uint32_t>(in.take(widths_.colour));
  return head;
}

Halfspace ModelMemory::halfspace(std::uint32_t primitive, std::uint32_t number) const {
  const Bits record = read(halfspaces_, first_halfspaces_[primitive] + number);
  BitReader in(record);
  Halfspace one;
  one.plane = static_cast<std::uint32_t>(in.take(widths_.plane));
  one.forward = in.take(1) != 0;
  one.colour = static_cast<std::uint32_t>(in.take(widths_.colour));
  return one;
}

Plane ModelMemory::plane(std::uint32_t index) const {
  const Bits record = read(planes_, index);
  BitReader in(record);
  const bool is_edge = in.take(1) != 0;
  const std::int64_t a = in.take_signed(widths_.slope);
  const std::int64_t b = in.take_signed(widths_.slope);
  return {is_edge, a, b, in.take_signed(widths_.constant)};
}

}  // namespace csgsim::division
