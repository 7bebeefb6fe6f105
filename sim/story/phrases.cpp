#include "sim/story/phrases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hw/base/text.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"
#include "sim/observe/frame.h"

namespace csgsim::story {

namespace {

constexpr std::array<std::string_view, 10> kind_names{"setup", "surface", "depth_test", "comparison", "bits",
                                                      "merge", "shade",   "effect",     "skip",       "stored"};
constexpr std::array<std::string_view, 8> fate_names{"outside",    "no_depth", "refused", "behind",
                                                     "classified", "covered",  "blended", "seen"};
constexpr std::array<std::string_view, 3> quadric_names{"ellipsoid", "cylinder", "cone"};

const isa::NamedField* find(const isa::Program& program, isa::Field field) {
  const auto& fields = program.facts->fields;
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const isa::NamedField& named) { return named.field == field; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

std::string_view name_of(EventKind kind) { return kind_names.at(static_cast<std::size_t>(kind)); }
std::string_view name_of(Fate fate) { return fate_names.at(static_cast<std::size_t>(fate)); }
std::string_view name_of(facet::QuadricKind kind) { return quadric_names.at(static_cast<std::size_t>(kind)); }

std::string primitive_text(const isa::Program& program, std::uint32_t primitive) {
  if (primitive == observe::no_owner) return "nothing";
  return isa::piece_name(*program.facts, primitive);
}

std::optional<double> distance_of(const isa::Program& program, std::uint32_t steps) {
  const unsigned bits = isa::find_field(program, isa::FieldRole::depth).width;
  const double distance = isa::distance_of(program.facts->depth_scale, bits, steps);
  return std::isfinite(distance) ? std::optional(distance) : std::nullopt;
}

std::string depth_text(const isa::Program& program, std::uint32_t steps) {
  const std::optional<double> distance = distance_of(program, steps);
  return distance ? fmt::format("{} ({:.6g})", steps, *distance) : "nothing";
}

std::string colour_text(const isa::Program& program, std::uint32_t colour) {
  const unsigned bits = program.colour.width;
  if (bits < isa::minimum_colour_bits || bits > isa::max_colour_bits) return fmt::format("{:#x}", colour);
  const std::array<std::uint8_t, 3> channels = isa::unpack_colour(colour, bits);
  return fmt::format("#{:02x}{:02x}{:02x}", channels[0], channels[1], channels[2]);
}

isa::FieldRole role_of(const isa::Program& program, isa::Field field) {
  const isa::NamedField* const named = find(program, field);
  return named != nullptr ? named->role : isa::FieldRole::scratch;
}

std::string value_text(const isa::Program& program, isa::Field field, std::uint64_t value) {
  const auto low = static_cast<std::uint32_t>(value);
  switch (role_of(program, field)) {
    case isa::FieldRole::depth:
    case isa::FieldRole::stored:
    case isa::FieldRole::candidate_depth: return depth_text(program, low);
    case isa::FieldRole::colour:
    case isa::FieldRole::candidate_colour:
    case isa::FieldRole::shown: return colour_text(program, low);
    case isa::FieldRole::scratch:
    case isa::FieldRole::mask:
    case isa::FieldRole::stack:
    case isa::FieldRole::product:
    case isa::FieldRole::label:
    case isa::FieldRole::owner:
    case isa::FieldRole::effect: break;
  }
  return std::to_string(value);
}

std::string field_name(const isa::Program& program, isa::Field field) {
  const isa::NamedField* const named = find(program, field);
  if (named != nullptr) return printable(named->name);
  return isa::text_of(field);
}

std::string decision_text(const isa::Program& program, const Decision& decision) {
  std::string text =
      fmt::format("i{} {}", decision.number, printable(isa::text_of(decision.instruction, program.facts->fields)));
  if (decision.squares) {
    text += fmt::format(", after i{} {}", decision.number - 1,
                        printable(isa::text_of(*decision.squares, program.facts->fields)));
  }
  if (decision.instruction.linear.width > 0) text += fmt::format(": F = {}", decision.value);
  return text;
}

std::optional<ModelHalfspace> halfspace_of(const Subject& subject, const Decision& decision) {
  if (subject.model == nullptr) return std::nullopt;
  return subject.model->find(decision.instruction, subject.program.segments[decision.segment].region);
}

std::optional<ModelQuadric> quadric_of(const Subject& subject, const Decision& decision) {
  if (subject.model == nullptr) return std::nullopt;
  const isa::Region& region = subject.program.segments[decision.segment].region;
  if (decision.squares) return subject.model->find(*decision.squares, decision.instruction, region);
  if (decision.quadric) return subject.model->find(decision.quadric->squares, decision.quadric->load, region);
  return std::nullopt;
}

namespace {

std::string place_text(const glm::dvec3& place) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", place.x, place.y, place.z);
}

/// D, its root and the depth computed from it.
std::string working_text(const isa::Program& program, const QuadricDepth& depth) {
  const auto half = static_cast<std::uint16_t>(depth.field.width / 2);
  const isa::Field root{static_cast<std::uint16_t>(depth.field.base + half + 1U), half};
  return fmt::format("i{}..i{} D = {}; i{} root {} in {}; i{} {} depth = {} {} {}", depth.load_number - 1,
                     depth.load_number, depth.discriminant, depth.root_number, depth.root, field_name(program, root),
                     depth.depth_number, depth.is_far ? "far" : "near", depth.middle, depth.is_far ? "+" : "-",
                     depth.offset);
}

std::string quadric_text(const Subject& subject, const Decision& decision) {
  std::string text;
  if (const std::optional<ModelQuadric> found = quadric_of(subject, decision)) {
    const std::string_view which = decision.squares ? "outline" : decision.quadric->is_far ? "far depth" : "near depth";
    text =
        fmt::format("{} of quadric {} of {} of {}: {} about {}", which, found->index + 1, found->count,
                    primitive_text(subject.program, found->primitive), name_of(found->kind), place_text(found->origin));
    if (found->kind != facet::QuadricKind::ellipsoid) text += " along " + place_text(found->axis);
  }
  if (!decision.quadric) return text;
  return text + (text.empty() ? "" : "\n") + working_text(subject.program, *decision.quadric);
}

}  // namespace

std::string geometry_text(const Subject& subject, const Decision& decision) {
  if (decision.squares || decision.quadric) return quadric_text(subject, decision);
  const std::optional<ModelHalfspace> found = halfspace_of(subject, decision);
  if (!found) return "";
  const glm::dvec3& normal = found->normal;
  return fmt::format("half-space {} of {} of {}: normal ({:.4g}, {:.4g}, {:.4g}), distance {:.6g}", found->index + 1,
                     found->count, primitive_text(subject.program, found->primitive), normal.x, normal.y, normal.z,
                     found->distance);
}

}  // namespace csgsim::story
