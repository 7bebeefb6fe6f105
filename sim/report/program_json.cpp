#include "sim/report/program_json.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"
#include "hw/isa/quoting.h"
#include "hw/isa/text.h"
#include "sim/story/phrases.h"

namespace csgsim::report {

namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(isa::OperandKind kind) {
  switch (kind) {
    case isa::OperandKind::none: return "none";
    case isa::OperandKind::target: return "target";
    case isa::OperandKind::source: return "source";
    case isa::OperandKind::linear: return "linear";
    case isa::OperandKind::constant: return "constant";
    case isa::OperandKind::count: return "count";
    case isa::OperandKind::squares: return "squares";
  }
  return "";
}

Json opcodes_json() {
  Json opcodes = Json::object();
  for (const isa::OpcodeInfo& row : isa::opcode_table) {
    Json operands = Json::array();
    for (const isa::OperandKind kind : row.operands)
      if (kind != isa::OperandKind::none) operands.push_back(name_of(kind));
    opcodes[std::string(row.name)] = std::move(operands);
  }
  return opcodes;
}

Json fields_json(const isa::Program& program) {
  Json fields = Json::array();
  for (const isa::NamedField& named : program.facts->fields)
    fields.push_back({{"name", printable(named.name)},
                      {"token", printable(isa::word_or_quoted(named.name))},
                      {"base", named.field.base},
                      {"width", named.field.width},
                      {"role", isa::name_of(named.role)}});
  return fields;
}

/// Instructions, and the half-spaces and quadrics whose planes and outlines they stream.
class Stream {
 public:
  Stream(const isa::Program& program, const story::HalfspaceFinder* model) : program_(program), model_(model) {
    for (std::uint32_t s = 0; s < program.segments.size(); ++s)
      for (std::size_t i = 0; i < program.segments[s].instructions.size(); ++i) put(s, i);
  }

  void add_to(Json& json) && {
    json["instructions"] = std::move(lines_);
    json["geometry"] = std::move(geometry_);
  }

 private:
  void put(std::uint32_t segment, std::size_t index) {
    const isa::Instruction& instruction = program_.segments[segment].instructions[index];
    if (!lines_.empty()) lines_ += '\n';
    lines_ += printable(isa::text_of(instruction, program_.facts->fields)) + '\t' +
              isa::text_of(instruction.origin, *program_.facts);
    if (model_ != nullptr && instruction.linear.width > 0) put_geometry(segment, index);
  }

  void put_geometry(std::uint32_t segment, std::size_t index) {
    story::Decision decision;
    decision.segment = segment;
    decision.instruction = program_.segments[segment].instructions[index];
    if (const isa::Instruction* const squares = isa::pending_squares(program_.segments[segment], index))
      decision.squares = *squares;
    const std::string text = story::geometry_text({program_, model_}, decision);
    if (text.empty()) return;
    const auto [known, is_new] = known_.try_emplace(text, static_cast<std::int64_t>(known_.size()));
    if (is_new) geometry_.push_back(text);
    lines_ += fmt::format("\t{}", known->second - next_);  // mostly 0, which packs well
    next_ = known->second + 1;
  }

  const isa::Program& program_;
  const story::HalfspaceFinder* model_;
  std::string lines_;
  Json geometry_ = Json::array();
  std::map<std::string, std::int64_t> known_;
  std::int64_t next_ = 0;  ///< of what was named last, one more
};

/// Of each piece the columns and rows beside which it is nowhere, none if there are none, and the first of those that
/// may be drawn as one solid with it.
Json places_json(const isa::Program& program, const story::HalfspaceFinder* model) {
  Json places = Json::array();
  if (model == nullptr) return places;
  for (std::uint32_t piece = 0; piece < isa::piece_count(*program.facts); ++piece) {
    const view::PixelRect& pixels = model->rectangle_of(piece);
    Json place{{"front", model->set_of(piece).front()}};
    if (!pixels.empty()) place["pixels"] = {pixels.x0, pixels.y0, pixels.x1, pixels.y1};
    places.push_back(std::move(place));
  }
  return places;
}

}  // namespace

nlohmann::ordered_json program_json(const isa::Program& program, std::span<const std::uint64_t> skips,
                                    const story::HalfspaceFinder* model) {
  const isa::Facts& facts = *program.facts;
  Json json{{"width", program.shape.width},
            {"height", program.shape.height},
            {"memoryBits", program.shape.memory_bits},
            {"colour", {{"base", program.colour.base}, {"width", program.colour.width}}},
            {"background", program.background},
            {"file", printable(facts.model.file)},
            {"fields", fields_json(program)},
            {"primitives", Json::array()},
            {"pieces", Json::array()},
            {"effects", Json::array()},
            {"depth",
             {{"perspective", facts.depth_scale.perspective},
              {"near", facts.depth_scale.near},
              {"far", facts.depth_scale.far}}},
            {"opcodes", opcodes_json()},
            {"places", places_json(program, model)},
            {"segments", Json::array()},
            {"skips", skips}};
  for (std::uint32_t i = 0; i < facts.primitives.size(); ++i) {
    json["primitives"].push_back(printable(facts.primitives[i]));
    json["pieces"].push_back(isa::pieces_of(facts, i).count);
  }
  for (const std::string& effect : facts.compile.effects) json["effects"].push_back(printable(effect));
  for (const isa::Segment& segment : program.segments) {
    const isa::Region& region = segment.region;
    json["segments"].push_back({region.x, region.y, region.width, region.height, segment.instructions.size()});
  }
  Stream(program, model).add_to(json);
  return json;
}

}  // namespace csgsim::report
