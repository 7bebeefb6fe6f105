#include "hw/division/encoding.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "hw/base/error.h"

namespace csgsim::division {

namespace {

unsigned unsigned_width(std::uint64_t most) { return static_cast<unsigned>(std::bit_width(most)); }

unsigned signed_width(std::int64_t value) {
  return unsigned_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)) + 1;
}

std::uint64_t last_of(std::size_t count) { return count == 0 ? 0 : count - 1; }

/// The numbers that a stream begins with.
struct Header {
  std::uint32_t planes = 0;
  std::uint32_t primitives = 0;
  std::uint32_t nodes = 0;
  Widths widths;
};

void put_field(BitWriter& out, isa::Field field) { out.put(field.base, Widths::place); }

void put_header(BitWriter& out, const DisplayModel& model, const Widths& widths) {
  out.put(model.planes.size(), Widths::count);
  out.put(model.primitives.size(), Widths::count);
  out.put(model.nodes.size(), Widths::count);
  out.put(model.width, Widths::side);
  out.put(model.height, Widths::side);
  out.put(model.z_bits, Widths::bits);
  out.put(model.fraction_bits, Widths::bits);
  out.put(model.colour_bits, Widths::bits);
  out.put(widths.slope, Widths::width);
  out.put(widths.constant, Widths::width);
  out.put(widths.halfspaces, Widths::width);
  out.put(widths.operands, Widths::bits);
  out.put(widths.plane, Widths::bits);
  const Fields& fields = model.fields;
  for (const isa::Field field : {fields.depth, fields.candidate, fields.colour, fields.candidate_colour, fields.mask}) {
    put_field(out, field);
  }
  out.put(fields.candidate_colour.width > 0 ? 1 : 0, 1);
  out.put(fields.stack_base, Widths::place);
  out.put(fields.stack_bits, Widths::place);
  out.put(model.background, widths.colour);
}

void put_box(BitWriter& out, const Box& box, const Widths& widths) {
  // An end is one more than the last.
  const bool empty = box.pixels.empty();
  for (const std::int32_t side : {box.pixels.x0, box.pixels.y0, box.pixels.x1 + 1, box.pixels.y1 + 1}) {
    out.put(empty ? 0 : static_cast<std::uint64_t>(side), Widths::side);
  }
  out.put(static_cast<std::uint64_t>(box.z_low), widths.depth);
  out.put(static_cast<std::uint64_t>(box.z_high + 1), widths.depth);
}

void put_primitive(BitWriter& out, const DisplayModel& model, const Primitive& one, const Widths& widths) {
  put_box(out, one.box, widths);
  out.put(one.complemented ? 1 : 0, 1);
  out.put(one.joined ? 1 : 0, 1);
  if (!one.complemented) out.put(one.near_colour, widths.colour);
  out.put(one.halfspaces.size(), widths.halfspaces);
  for (const Halfspace& halfspace : one.halfspaces) {
    out.put(halfspace.plane, widths.plane);
    out.put(halfspace.forward ? 1 : 0, 1);
    if (seen(side_of(model.planes[halfspace.plane], halfspace.forward), one.complemented))
      out.put(halfspace.colour, widths.colour);
  }
}

void put_node(BitWriter& out, const Node& node, const Widths& widths) {
  out.put(node.operands == 0 ? 0 : 1, 1);
  if (node.operands == 0) return;
  out.put(node.op == Operator::intersect ? 1 : 0, 1);
  out.put(node.operands, widths.operands);
}

isa::Field take_field(BitReader& in, unsigned width) {
  return {static_cast<std::uint16_t>(in.take(Widths::place)), static_cast<std::uint16_t>(width)};
}

Header take_header(BitReader& in, DisplayModel& model) {
  Header header;
  header.planes = static_cast<std::uint32_t>(in.take(Widths::count));
  header.primitives = static_cast<std::uint32_t>(in.take(Widths::count));
  header.nodes = static_cast<std::uint32_t>(in.take(Widths::count));
  model.width = static_cast<std::uint32_t>(in.take(Widths::side));
  model.height = static_cast<std::uint32_t>(in.take(Widths::side));
  model.z_bits = static_cast<unsigned>(in.take(Widths::bits));
  model.fraction_bits = static_cast<unsigned>(in.take(Widths::bits));
  model.colour_bits = static_cast<unsigned>(in.take(Widths::bits));
  Widths& widths = header.widths;
  widths.slope = static_cast<unsigned>(in.take(Widths::width));
  widths.constant = static_cast<unsigned>(in.take(Widths::width));
  widths.halfspaces = static_cast<unsigned>(in.take(Widths::width));
  widths.operands = static_cast<unsigned>(in.take(Widths::bits));
  widths.plane = static_cast<unsigned>(in.take(Widths::bits));
  widths.depth = model.z_bits + 1;
  widths.colour = model.colour_bits;
  Fields& fields = model.fields;
  fields.depth = take_field(in, model.z_bits);
  fields.candidate = take_field(in, model.z_bits);
  fields.colour = take_field(in, model.colour_bits);
  fields.candidate_colour = take_field(in, 0);
  fields.mask = take_field(in, 1);
  if (in.take(1) != 0) fields.candidate_colour.width = fields.colour.width;
  fields.stack_base = static_cast<std::uint32_t>(in.take(Widths::place));
  fields.stack_bits = static_cast<std::uint32_t>(in.take(Widths::place));
  model.background = static_cast<std::uint32_t>(in.take(widths.colour));
  return header;
}

/// Throws InputError unless so many records of that many bits at least can still come, so that no number of them fills
/// memory.
void require_room(const BitReader& in, std::uint64_t records, unsigned bits) {
  if (records > in.left() / bits) throw InputError("the display model: the stream ends too soon");
}

Box take_box(BitReader& in, const Widths& widths) {
  Box box;
  box.pixels.x0 = static_cast<std::int32_t>(in.take(Widths::side));
  box.pixels.y0 = static_cast<std::int32_t>(in.take(Widths::side));
  box.pixels.x1 = static_cast<std::int32_t>(in.take(Widths::side)) - 1;
  box.pixels.y1 = static_cast<std::int32_t>(in.take(Widths::side)) - 1;
  box.z_low = static_cast<std::int64_t>(in.take(widths.depth));
  box.z_high = static_cast<std::int64_t>(in.take(widths.depth)) - 1;
  return box;
}

Primitive take_primitive(BitReader& in, const DisplayModel& model, const Widths& widths) {
  Primitive one;
  one.box = take_box(in, widths);
  one.complemented = in.take(1) != 0;
  one.joined = in.take(1) != 0;
  if (!one.complemented) one.near_colour = static_cast<std::uint32_t>(in.take(widths.colour));
  const std::uint64_t count = in.take(widths.halfspaces);
  require_room(in, count, widths.halfspace_record());
  for (std::uint64_t i = 0; i < count; ++i) {
    Halfspace halfspace;
    halfspace.plane = static_cast<std::uint32_t>(in.take(widths.plane));
    halfspace.forward = in.take(1) != 0;
    if (halfspace.plane >= model.planes.size())
      throw InputError("the display model: a half-space names a plane that there is not");
    if (seen(side_of(model.planes[halfspace.plane], halfspace.forward), one.complemented))
      halfspace.colour = static_cast<std::uint32_t>(in.take(widths.colour));
    one.halfspaces.push_back(halfspace);
  }
  return one;
}

}  // namespace

Widths widths_of(const DisplayModel& model) {
  Widths widths;
  for (const Plane& plane : model.planes) {
    widths.slope = std::max({widths.slope, signed_width(plane.a), signed_width(plane.b)});
    widths.constant = std::max(widths.constant, signed_width(plane.c));
  }
  widths.plane = unsigned_width(last_of(model.planes.size()));
  for (const Primitive& one : model.primitives) {
    widths.halfspaces = std::max(widths.halfspaces, unsigned_width(one.halfspaces.size()));
  }
  for (const Node& node : model.nodes) widths.operands = std::max(widths.operands, unsigned_width(node.operands));
  widths.depth = model.z_bits + 1;
  widths.colour = model.colour_bits;
  return widths;
}

Bits encode(const DisplayModel& model) {
  validate(model);
  const Widths widths = widths_of(model);
  BitWriter out;
  put_header(out, model, widths);
  for (const Plane& plane : model.planes) {
    out.put(plane.is_edge ? 1 : 0, 1);
    out.put_signed(plane.a, widths.slope);
    out.put_signed(plane.b, widths.slope);
    out.put_signed(plane.c, widths.constant);
  }
  for (const Primitive& one : model.primitives) put_primitive(out, model, one, widths);
  for (const Node& node : model.nodes) put_node(out, node, widths);
  return out.take();
}

namespace {

/// Reads a model, and leaves what follows it.
DisplayModel read(BitReader& in) {
  DisplayModel model;
  const Header header = take_header(in, model);
  const Widths& widths = header.widths;
  require_room(in, header.planes, widths.plane_record());
  for (std::uint32_t i = 0; i < header.planes; ++i) {
    const bool is_edge = in.take(1) != 0;
    const std::int64_t a = in.take_signed(widths.slope);
    const std::int64_t b = in.take_signed(widths.slope);
    model.planes.push_back({is_edge, a, b, in.take_signed(widths.constant)});
  }
  require_room(in, header.primitives, widths.primitive_record());
  for (std::uint32_t i = 0; i < header.primitives; ++i) model.primitives.push_back(take_primitive(in, model, widths));
  require_room(in, header.nodes, Widths::node_record);
  for (std::uint32_t i = 0; i < header.nodes; ++i) {
    if (in.take(1) == 0) {
      model.nodes.emplace_back();
      continue;
    }
    const Operator op = in.take(1) != 0 ? Operator::intersect : Operator::unite;
    model.nodes.push_back({static_cast<std::uint32_t>(in.take(widths.operands)), op});
  }
  return model;
}

/// What encode() would not write is no stream: wider fields than the numbers need, another form of an empty rectangle,
/// anything after the end.
void require_one_form(bool holds) {
  if (!holds) throw InputError("the display model: the stream is not in its one form");
}

}  // namespace

DisplayModel decode(const Bits& bits) {
  BitReader in(bits);
  DisplayModel model = read(in);
  require_one_form(encode(model) == bits);
  return model;
}

std::vector<isa::LinkWord> to_link(const Bits& bits, unsigned width) {
  std::vector<isa::LinkWord> words(link_words(bits.count, width));
  BitReader in(bits);
  for (isa::LinkWord& word : words) {
    for (unsigned at = 0; at < width && in.left() > 0;) {
      const auto count = static_cast<unsigned>(std::min<std::uint64_t>({64, width - at, in.left()}));
      word.put(at, count, in.take(count));
      at += count;
    }
  }
  return words;
}

DisplayModel from_link(std::span<const isa::LinkWord> words, unsigned width) {
  BitWriter out;
  for (const isa::LinkWord& word : words) {
    for (unsigned at = 0; at < width; at += 64) {
      const unsigned count = std::min(64U, width - at);
      out.put(word.number(at, count), count);
    }
  }
  const Bits bits = out.take();
  BitReader in(bits);
  DisplayModel model = read(in);
  require_one_form(std::ranges::equal(to_link(encode(model), width), words));
  return model;
}

}  // namespace csgsim::division
