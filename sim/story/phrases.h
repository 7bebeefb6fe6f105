// Texts of values, decisions and geometry.
// Used by sim/story, sim/app and sim/report.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hw/isa/field_role.h"
#include "sim/story/halfspaces.h"
#include "sim/story/story.h"

namespace csgsim::story {

/// The subject of a story: the Program, and its model if known.
struct Subject {
  const isa::Program& program;
  const HalfspaceFinder* model = nullptr;
};

std::string_view name_of(EventKind kind);
std::string_view name_of(Fate fate);
std::string_view name_of(facet::QuadricKind kind);

/// `p3 cylinder@9:9`, or `p3.2 text@9:9` for a piece (hw/isa/pieces.h); `nothing` for observe::no_owner.
std::string primitive_text(const isa::Program& program, std::uint32_t primitive);

/// `523114 (83.214)`: depth steps and model units; `nothing` if all bits are 1.
std::string depth_text(const isa::Program& program, std::uint32_t steps);

/// Distance from the eye along the view axis, in model units; nothing if all bits are 1.
std::optional<double> distance_of(const isa::Program& program, std::uint32_t steps);

/// `#c8a05a`, for a colour as stored in the colour field.
std::string colour_text(const isa::Program& program, std::uint32_t colour);

/// A field's value, formatted by the field's role.
std::string value_text(const isa::Program& program, isa::Field field, std::uint64_t value);

std::string field_name(const isa::Program& program, isa::Field field);
isa::FieldRole role_of(const isa::Program& program, isa::Field field);

/// `i123 keep_max Z1, 12*x - 7*y + 991 (w35 >> 12): F = 523114`.
std::string decision_text(const isa::Program& program, const Decision& decision);

/// `half-space 3 of 8 of p3 cylinder@9:9: normal (0, -1, 0), distance 4`; empty without a model or half-space. For a
/// quadric: `near depth of quadric 1 of 1 of p3 cylinder@9:9: cylinder about (0, 0, 2) along (0, 0, 1)`, and on a
/// second line its computation, which needs no model.
std::string geometry_text(const Subject& subject, const Decision& decision);

/// The deciding half-space, if the model is known.
std::optional<ModelHalfspace> halfspace_of(const Subject& subject, const Decision& decision);

/// The deciding quadric, found by its discriminant or by a depth, if the model is known.
std::optional<ModelQuadric> quadric_of(const Subject& subject, const Decision& decision);

}  // namespace csgsim::story
