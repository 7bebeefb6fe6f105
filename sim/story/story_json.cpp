#include "sim/story/story_json.h"

#include <nlohmann/json.hpp>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"
#include "sim/observe/frame.h"

namespace csgsim::story {

namespace {

using Json = nlohmann::ordered_json;

Json primitive_json(const isa::Program& program, std::uint32_t piece) {
  if (piece == observe::no_owner) return nullptr;
  const std::uint32_t primitive = isa::primitive_of(*program.facts, piece);
  Json json{{"index", primitive}};
  if (primitive < program.facts->primitives.size()) json["name"] = printable(program.facts->primitives[primitive]);
  const isa::PieceRange pieces = isa::pieces_of(*program.facts, primitive);
  if (pieces.count > 1) json["piece"] = piece - pieces.first;
  return json;
}

Json depth_json(const isa::Program& program, std::uint32_t steps) {
  const std::optional<double> distance = distance_of(program, steps);
  return {{"steps", steps}, {"distance", distance ? Json(*distance) : Json(nullptr)}};
}

bool is_depth(isa::FieldRole role) {
  return role == isa::FieldRole::depth || role == isa::FieldRole::candidate_depth || role == isa::FieldRole::stored;
}

Json change_json(const isa::Program& program, const Change& change) {
  const isa::FieldRole role = role_of(program, change.field);
  const auto value = [&](std::uint64_t number) {
    return is_depth(role) ? depth_json(program, static_cast<std::uint32_t>(number)) : Json(number);
  };
  return {{"field", field_name(program, change.field)},
          {"role", isa::name_of(role)},
          {"before", value(change.before)},
          {"after", value(change.after)},
          {"instruction", change.number}};
}

Json quadric_json(const Subject& subject, const ModelQuadric& quadric) {
  Json json{{"primitive", primitive_json(subject.program, quadric.primitive)},
            {"index", quadric.index},
            {"count", quadric.count},
            {"kind", name_of(quadric.kind)},
            {"origin", {quadric.origin.x, quadric.origin.y, quadric.origin.z}}};
  if (quadric.kind != facet::QuadricKind::ellipsoid) json["axis"] = {quadric.axis.x, quadric.axis.y, quadric.axis.z};
  return json;
}

/// The computation of a quadric's depth; instructions by their numbers.
Json working_json(const QuadricDepth& depth) {
  return {
      {"side", depth.is_far ? "far" : "near"},
      {"discriminant", {{"instructions", {depth.load_number - 1, depth.load_number}}, {"value", depth.discriminant}}},
      {"root",
       {{"instruction", depth.root_number},
        {"base", depth.field.base},
        {"width", depth.field.width},
        {"value", depth.root}}},
      {"depth", {{"instruction", depth.depth_number}, {"middle", depth.middle}, {"offset", depth.offset}}}};
}

Json decision_json(const Subject& subject, const Decision& decision) {
  Json json{{"instruction", decision.number},
            {"text", printable(isa::text_of(decision.instruction, subject.program.facts->fields))}};
  if (decision.instruction.linear.width > 0) {
    const isa::Linear& linear = decision.instruction.linear;
    json["plane"] = {{"a", linear.a}, {"b", linear.b}, {"c", linear.c}, {"shift", linear.shift}};
    json["value"] = decision.value;
  }
  if (decision.squares) {
    const isa::Linear& squares = decision.squares->linear;
    json["squares"] = {{"xx", squares.a}, {"xy", squares.b}, {"yy", squares.c}};
  }
  if (decision.instruction.fields[0].width > 0) json["met"] = decision.first_operand;
  if (decision.instruction.fields[1].width > 0) json["met_too"] = decision.second_operand;
  if (const auto found = halfspace_of(subject, decision)) {
    json["halfspace"] = {{"primitive", primitive_json(subject.program, found->primitive)},
                         {"index", found->index},
                         {"count", found->count},
                         {"normal", {found->normal.x, found->normal.y, found->normal.z}},
                         {"distance", found->distance}};
  }
  if (const auto found = quadric_of(subject, decision)) json["quadric"] = quadric_json(subject, *found);
  if (decision.quadric) json["worked_out"] = working_json(*decision.quadric);
  return json;
}

Json event_json(const Subject& subject, const Event& event) {
  const isa::Program& program = subject.program;
  Json json{{"what", name_of(event.kind)}, {"segment", event.segment}, {"first", event.first}, {"last", event.last}};
  if (!event.clocks.empty()) json["clocks"] = {event.clocks.begin, event.clocks.end};
  json["purpose"] = isa::info(event.origin.purpose).name;
  if (event.origin.primitive != isa::no_primitive) json["primitive"] = primitive_json(program, event.origin.primitive);
  if (event.origin.node != isa::no_node) json["against"] = primitive_json(program, event.origin.node);
  const std::vector<std::string>& effects = program.facts->compile.effects;
  if (event.origin.effect < effects.size()) json["effect"] = printable(effects[event.origin.effect]);
  json["enabled"] = {event.enabled_before, event.enabled_after};
  if (event.decision) json["decision"] = decision_json(subject, *event.decision);
  if (event.cut) json["cut"] = decision_json(subject, *event.cut);
  if (event.misfit) json["misfit"] = decision_json(subject, *event.misfit);
  json["changes"] = Json::array();
  for (const Change& change : event.changes) json["changes"].push_back(change_json(program, change));
  json["owner"] = {primitive_json(program, event.owner_before), primitive_json(program, event.owner_after)};
  return json;
}

Json attempt_json(const Subject& subject, const Story& story, const Attempt& attempt) {
  Json json{{"primitive", primitive_json(subject.program, attempt.shown)}};
  if (attempt.shown != attempt.primitive) json["drawn_as"] = primitive_json(subject.program, attempt.primitive);
  json["fate"] = name_of(attempt.fate);
  json["events"] = {attempt.first_event, attempt.last_event};
  json["deciding_event"] = attempt.deciding_event;
  json["text"] = fate_text(subject, story, attempt);
  return json;
}

}  // namespace

nlohmann::ordered_json to_json(const Subject& subject, const Story& story) {
  const isa::Program& program = subject.program;
  Json json{{"pixel", {story.x, story.y}},
            {"model", printable(program.facts->model.file)},
            {"segments", Json::array()},
            {"owner", primitive_json(program, story.owner)},
            {"depth", depth_json(program, story.depth)}};
  if (is_seen_through(story))
    json["opaque"] = {{"owner", primitive_json(program, story.opaque_owner)},
                      {"depth", depth_json(program, story.opaque_depth)}};
  json["colour"] = colour_text(program, story.colour);
  json["events"] = Json::array();
  json["surfaces"] = Json::array();
  for (const StorySegment& part : story.segments)
    json["segments"].push_back({{"segment", part.segment}, {"instructions", {part.first, part.end}}});
  for (const Event& event : story.events) json["events"].push_back(event_json(subject, event));
  for (const Attempt& attempt : story.attempts) json["surfaces"].push_back(attempt_json(subject, story, attempt));
  return json;
}

nlohmann::ordered_json to_json(const Subject& subject, const Story& story, const WhyNot& answer) {
  return {{"primitive", primitive_json(subject.program, answer.pieces.first)},
          {"seen", answer.is_seen},
          {"broadcast", answer.is_broadcast},
          {"drawn_as", primitive_json(subject.program, answer.drawn_as)},
          {"surfaces", answer.attempts},
          {"text", text_of(subject, story, answer)}};
}

}  // namespace csgsim::story
