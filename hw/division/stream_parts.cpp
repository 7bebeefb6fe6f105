#include "hw/division/stream_parts.h"

#include "hw/division/encoding.h"

namespace csgsim::division {

namespace {

isa::Field take_field(BitReader& in, unsigned width) {
  return {static_cast<std::uint16_t>(in.take(Widths::place)), static_cast<std::uint16_t>(width)};
}

std::int32_t take_side(BitReader& in) { return static_cast<std::int32_t>(in.take(Widths::side)); }

}  // namespace

void put_sampling(BitWriter& out, const DisplayModel& model) {
  out.put(model.width, Widths::side);
  out.put(model.height, Widths::side);
  out.put(model.z_bits, Widths::bits);
  out.put(model.fraction_bits, Widths::bits);
  out.put(model.colour_bits, Widths::bits);
}

void take_sampling(BitReader& in, DisplayModel& model) {
  model.width = static_cast<std::uint32_t>(in.take(Widths::side));
  model.height = static_cast<std::uint32_t>(in.take(Widths::side));
  model.z_bits = static_cast<unsigned>(in.take(Widths::bits));
  model.fraction_bits = static_cast<unsigned>(in.take(Widths::bits));
  model.colour_bits = static_cast<unsigned>(in.take(Widths::bits));
}

void put_fields(BitWriter& out, const Fields& fields) {
  for (const isa::Field field : {fields.depth, fields.candidate, fields.colour, fields.candidate_colour, fields.mask}) {
    out.put(field.base, Widths::place);
  }
  out.put(fields.candidate_colour.width > 0 ? 1 : 0, 1);
  out.put(fields.stack_base, Widths::place);
  out.put(fields.stack_bits, Widths::place);
}

Fields take_fields(BitReader& in, unsigned z_bits, unsigned colour_bits) {
  Fields fields;
  fields.depth = take_field(in, z_bits);
  fields.candidate = take_field(in, z_bits);
  fields.colour = take_field(in, colour_bits);
  fields.candidate_colour = take_field(in, 0);
  fields.mask = take_field(in, 1);
  if (in.take(1) != 0) fields.candidate_colour.width = fields.colour.width;
  fields.stack_base = static_cast<std::uint32_t>(in.take(Widths::place));
  fields.stack_bits = static_cast<std::uint32_t>(in.take(Widths::place));
  return fields;
}

void put_box(BitWriter& out, const Box& box, unsigned depth_bits) {
  const bool empty = box.pixels.empty();
  for (const std::int32_t side : {box.pixels.x0, box.pixels.y0, box.pixels.x1 + 1, box.pixels.y1 + 1}) {
    out.put(empty ? 0 : static_cast<std::uint64_t>(side), Widths::side);
  }
  out.put(static_cast<std::uint64_t>(box.z_low), depth_bits);
  out.put(static_cast<std::uint64_t>(box.z_high + 1), depth_bits);
}

Box take_box(BitReader& in, unsigned depth_bits) {
  Box box;
  box.pixels.x0 = take_side(in);
  box.pixels.y0 = take_side(in);
  box.pixels.x1 = take_side(in) - 1;
  box.pixels.y1 = take_side(in) - 1;
  box.z_low = static_cast<std::int64_t>(in.take(depth_bits));
  box.z_high = static_cast<std::int64_t>(in.take(depth_bits)) - 1;
  return box;
}

}  // namespace csgsim::division
