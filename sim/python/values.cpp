#include "sim/python/values.h"

#include <array>
#include <cstdint>
#include <vector>

#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"
#include "sim/observe/pictures.h"
#include "sim/pictures/encode.h"
#include "sim/session/options/usage.h"

namespace csgsim::python {

namespace {

using Json = nlohmann::ordered_json;

py::object to_object(const Json& json) {
  py::dict object;
  for (const auto& [key, value] : json.items()) object[py::str(key)] = to_python(value);
  return object;
}

py::object to_list(const Json& json) {
  py::list list;
  for (const Json& value : json) list.append(to_python(value));
  return list;
}

/// Bytes that are not UTF-8, as in file names, use Python's surrogateescape.
py::object text_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
}

template <class Value>
py::array_t<Value> image(const observe::Frame& frame) {
  return py::array_t<Value>({py::ssize_t{frame.height}, py::ssize_t{frame.width}});
}

}  // namespace

py::object to_python(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: return to_object(json);
    case Json::value_t::array: return to_list(json);
    case Json::value_t::string: return text_of(json.get_ref<const std::string&>());
    case Json::value_t::boolean: return py::bool_(json.get<bool>());
    case Json::value_t::number_integer: return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned: return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float: return py::float_(json.get<double>());
    case Json::value_t::null:
    case Json::value_t::binary:
    case Json::value_t::discarded: break;
  }
  return py::none();
}

py::array picture_array(const observe::Frame& frame, const isa::Program& program) {
  py::array_t<std::uint8_t> picture({py::ssize_t{frame.height}, py::ssize_t{frame.width}, py::ssize_t{3}});
  std::uint8_t* at = picture.mutable_data();
  for (const std::uint32_t colour : frame.colour)
    for (const std::uint8_t channel : isa::unpack_colour(colour, program.colour.width)) *at++ = channel;
  return picture;
}

py::array depth_array(const observe::Frame& frame, const isa::Program& program) {
  py::array_t<double> depth = image<double>(frame);
  double* at = depth.mutable_data();
  const unsigned bits = isa::find_field(program, isa::FieldRole::depth).width;
  for (const std::uint32_t step : frame.depth) *at++ = isa::distance_of(program.facts->depth_scale, bits, step);
  return depth;
}

py::array owner_array(const observe::Frame& frame, const isa::Program& program) {
  py::array_t<std::int32_t> owners = image<std::int32_t>(frame);
  std::int32_t* at = owners.mutable_data();
  for (const std::uint32_t owner : frame.owner) {
    const bool is_nothing = owner == observe::no_owner;
    *at++ = is_nothing ? -1 : static_cast<std::int32_t>(isa::primitive_of(*program.facts, owner));
  }
  return owners;
}

py::bytes to_png(const py::array_t<std::uint8_t, py::array::c_style>& picture) {
  if (picture.ndim() != 3 || picture.shape(2) != 3 || picture.size() == 0)
    throw session::UsageError("picture", "must have rows, columns and three channels");
  const auto side = [&](int axis) { return static_cast<std::uint32_t>(picture.shape(axis)); };
  const pictures::Bytes bytes(picture.data(), static_cast<std::size_t>(picture.size()));
  return pictures::encode("picture.png", {side(1), side(0), 3, {}, bytes});
}

namespace {

/// The label of a piece, or None.
py::object label(const isa::Facts& facts, std::uint32_t piece, std::uint32_t nothing) {
  return piece == nothing ? py::object(py::none()) : py::object(py::str(isa::piece_label(facts, piece)));
}

py::object effect_name(const isa::Facts& facts, std::uint8_t effect) {
  if (effect == isa::no_effect) return py::none();
  return py::str(facts.compile.effects.at(effect));
}

py::dict instruction_row(const isa::Instruction& instruction, const isa::Facts& facts,
                         const machines::Machine& machine) {
  py::dict row;
  row["name"] = isa::info(instruction.opcode).name;
  row["text"] = isa::text_of(instruction, facts.fields);
  row["clocks"] = machines::clocks(instruction, machine);
  row["purpose"] = isa::info(instruction.origin.purpose).name;
  row["primitive"] = label(facts, instruction.origin.primitive, isa::no_primitive);
  row["against"] = label(facts, instruction.origin.node, isa::no_node);
  row["effect"] = effect_name(facts, instruction.origin.effect);
  return row;
}

}  // namespace

py::list instruction_list(const isa::Program& program, const machines::Machine& machine) {
  py::list rows;
  std::uint64_t number = 0;
  for (std::size_t segment = 0; segment < program.segments.size(); ++segment) {
    for (const isa::Instruction& instruction : program.segments[segment].instructions) {
      py::dict row;
      row["instruction"] = number++;
      row["segment"] = segment;
      row.attr("update")(instruction_row(instruction, *program.facts, machine));
      rows.append(row);
    }
  }
  return rows;
}

py::dict machine_description(const machines::Machine& machine) {
  py::list figures;
  for (const machines::Figure& figure : machine.figures) {
    py::dict row;
    row["key"] = figure.key;
    row["value"] = machines::used_value(figure, machine);
    row["unit"] = figure.unit;
    row["provenance"] = figure.provenance;
    row["source"] = figure.source;
    if (figure.range) row["range"] = py::make_tuple(figure.range->low, figure.range->high, figure.range->reason);
    figures.append(row);
  }
  py::dict description;
  description["name"] = machine.name;
  description["description"] = machine.description;
  description["kind"] = machine.kind->name;
  description["figures"] = figures;
  return description;
}

}  // namespace csgsim::python
