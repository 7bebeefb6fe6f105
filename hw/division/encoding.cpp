#include "hw/division/encoding.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "hw/base/error.h"
#include "hw/division/stream_parts.h"
#include "hw/division/widths.h"

namespace csgsim::division {

namespace {

std::uint64_t last_index(std::size_t count) { return count == 0 ? 0 : count - 1; }

/// The numbers at the start of a stream.
struct Header {
  std::uint32_t planes = 0;
  std::uint32_t primitives = 0;
  std::uint32_t nodes = 0;
  Widths widths;
};

void put_header(BitWriter& out, const DisplayModel& model, const Widths& widths) {
  out.put(model.planes.size(), Widths::count);
  out.put(model.primitives.size(), Widths::count);
  out.put(model.nodes.size(), Widths::count);
  put_sampling(out, model);
  out.put(widths.slope, Widths::width);
  out.put(widths.constant, Widths::width);
  out.put(widths.halfspaces, Widths::width);
  out.put(widths.operands, Widths::bits);
  out.put(widths.plane, Widths::bits);
  put_fields(out, model.fields);
  out.put(model.background, widths.colour);
}

void put_primitive(BitWriter& out, const DisplayModel& model, const Primitive& one, const Widths& widths) {
  put_box(out, one.box, widths.depth);
  out.put(one.complemented ? 1 : 0, 1);
  out.put(one.joined ? 1 : 0, 1);
  if (!one.complemented) out.put(one.near_colour, widths.colour);
  out.put(one.halfspaces.size(), widths.halfspaces);
  for (const Halfspace& halfspace : one.halfspaces) {
    out.put(halfspace.plane, widths.plane);
    out.put(halfspace.forward ? 1 : 0, 1);
    if (is_visible_side(side_of(model.planes[halfspace.plane], halfspace.forward), one.complemented))
      out.put(halfspace.colour, widths.colour);
  }
}

void put_node(BitWriter& out, const Node& node, const Widths& widths) {
  out.put(node.operands == 0 ? 0 : 1, 1);
  if (node.operands == 0) return;
  out.put(node.op == Operator::intersect ? 1 : 0, 1);
  out.put(node.operands, widths.operands);
}

Header take_header(BitReader& in, DisplayModel& model) {
  Header header;
  header.planes = static_cast<std::uint32_t>(in.take(Widths::count));
  header.primitives = static_cast<std::uint32_t>(in.take(Widths::count));
  header.nodes = static_cast<std::uint32_t>(in.take(Widths::count));
  take_sampling(in, model);
  Widths& widths = header.widths;
  widths.slope = static_cast<unsigned>(in.take(Widths::width));
  widths.constant = static_cast<unsigned>(in.take(Widths::width));
  widths.halfspaces = static_cast<unsigned>(in.take(Widths::width));
  widths.operands = static_cast<unsigned>(in.take(Widths::bits));
  widths.plane = static_cast<unsigned>(in.take(Widths::bits));
  widths.depth = model.z_bits + 1;
  widths.colour = model.colour_bits;
  model.fields = take_fields(in, model.z_bits, model.colour_bits);
  model.background = static_cast<std::uint32_t>(in.take(widths.colour));
  return header;
}

/// Throws InputError unless the stream has room for `records` records of at least `bits` bits, so that an invalid count
/// cannot exhaust memory.
void require_room(const BitReader& in, std::uint64_t records, unsigned bits) {
  if (records > in.left() / bits)
    throw InputError("the display model: the stream ends too soon; compile the model again");
}

Primitive take_primitive(BitReader& in, const DisplayModel& model, const Widths& widths) {
  Primitive one;
  one.box = take_box(in, widths.depth);
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
      throw InputError("the display model: a half-space refers to a nonexistent plane; compile the model again");
    if (is_visible_side(side_of(model.planes[halfspace.plane], halfspace.forward), one.complemented))
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
  widths.plane = unsigned_width(last_index(model.planes.size()));
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

/// Reads a model and leaves the rest of the stream unread.
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

/// Rejects streams that encode() would not write: fields wider than needed, another form of an empty rectangle, or
/// trailing data.
void require_canonical(bool holds) {
  if (!holds) throw InputError("the display model: the stream is not in canonical form; compile the model again");
}

}  // namespace

DisplayModel decode(const Bits& bits) {
  BitReader in(bits);
  DisplayModel model = read(in);
  require_canonical(encode(model) == bits);
  return model;
}

std::vector<isa::LinkWord> to_link(const Bits& bits, unsigned link_width) {
  std::vector<isa::LinkWord> words(static_cast<std::size_t>(link_words(bits.count, link_width)));
  BitReader in(bits);
  for (isa::LinkWord& word : words) {
    for (unsigned at = 0; at < link_width && in.left() > 0;) {
      const auto count = static_cast<unsigned>(std::min<std::uint64_t>({64, link_width - at, in.left()}));
      word.put(at, count, in.take(count));
      at += count;
    }
  }
  return words;
}

DisplayModel from_link(std::span<const isa::LinkWord> words, unsigned link_width) {
  BitWriter out;
  for (const isa::LinkWord& word : words) {
    for (unsigned at = 0; at < link_width; at += 64) {
      const unsigned count = std::min(64U, link_width - at);
      out.put(word.number(at, count), count);
    }
  }
  const Bits bits = out.take();
  BitReader in(bits);
  DisplayModel model = read(in);
  require_canonical(std::ranges::equal(to_link(encode(model), link_width), words));
  return model;
}

}  // namespace csgsim::division
