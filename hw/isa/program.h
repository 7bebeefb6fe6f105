#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/instruction.h"

namespace csgsim::isa {

/// A rectangle of pixels of the picture; row 0 is at the top.
struct Region {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  /// Whether that pixel of the picture is in it.
  [[nodiscard]] constexpr bool holds(std::uint32_t column, std::uint32_t row) const {
    return column >= x && column - x < width && row >= y && row - y < height;
  }
  constexpr bool operator==(const Region&) const = default;
};

/// What a machine that divides the model itself does for one surface in a region, or for several of which only boxes
/// are looked at; docs/division.md has the rules. Each of up to 64 bits. First it tests, then it writes.
struct DivisionStep {
  std::uint64_t boxes = 0;         ///< of primitives, held against the region's
  std::uint64_t lists = 0;         ///< of half-spaces that are read, empty ones left out
  std::uint64_t halfspaces = 0;    ///< in them, each tested at the four corners of a rectangle
  std::uint64_t cells = 0;         ///< times that a half-space of a side is held against the leaders of a cell
  std::uint64_t nodes = 0;         ///< of the tree, looked at
  std::uint64_t instructions = 0;  ///< of the region, those that come next

  DivisionStep& operator+=(const DivisionStep& more) {
    boxes += more.boxes;
    lists += more.lists;
    halfspaces += more.halfspaces;
    cells += more.cells;
    nodes += more.nodes;
    instructions += more.instructions;
    return *this;
  }
  constexpr bool operator==(const DivisionStep&) const = default;
};

/// What such a machine does for a region, as the host counts it.
struct DivisionCounts {
  std::vector<DivisionStep> steps;
  std::uint64_t group_boxes = 0;       ///< before the first region of a group
  std::uint64_t group_lists = 0;       ///< the same
  std::uint64_t group_halfspaces = 0;  ///< the same
  std::uint64_t group_cells = 0;       ///< the same
  std::uint64_t group_entries = 0;     ///< primitives and half-spaces that the group leaves, with its first region

  /// All steps together.
  [[nodiscard]] DivisionStep sum() const {
    DivisionStep all;
    for (const DivisionStep& step : steps) all += step;
    return all;
  }
  bool operator==(const DivisionCounts&) const = default;
};

/// What the host knows of a region's part of the model and tells in the stats.
struct SegmentFacts {
  std::uint32_t primitives = 0;       ///< active in the region
  std::uint32_t halfspaces = 0;       ///< of those primitives
  std::uint32_t kept_primitives = 0;  ///< of the primitives, those that pruning leaves to be drawn
  std::uint32_t kept_halfspaces = 0;  ///< of the half-spaces, those that pruning leaves to those primitives' surfaces
  std::uint32_t comparisons = 0;      ///< of primitives with Z1, to classify it

  constexpr bool operator==(const SegmentFacts&) const = default;
};

/// What the host does before it writes instructions, as it counts it itself; docs/host.md has the rules. Of a whole
/// frame at most most_prepared of each.
struct Preparation {
  std::uint64_t planes = 0;      ///< transformed to the picture
  std::uint64_t points = 0;      ///< of solids, transformed to the picture
  std::uint64_t colours = 0;     ///< worked out
  std::uint64_t boxes = 0;       ///< held against another
  std::uint64_t halfspaces = 0;  ///< held against the corners of a rectangle
  std::uint64_t values = 0;      ///< of planes at single pixels, held against another
  std::uint64_t supports = 0;    ///< points held against a direction in space
  std::uint64_t nodes = 0;       ///< of the tree, looked at

  Preparation& operator+=(const Preparation& more) {
    planes += more.planes;
    points += more.points;
    colours += more.colours;
    boxes += more.boxes;
    halfspaces += more.halfspaces;
    values += more.values;
    supports += more.supports;
    nodes += more.nodes;
    return *this;
  }
  constexpr bool operator==(const Preparation&) const = default;
};

inline constexpr std::uint64_t most_prepared = std::uint64_t{1} << 48;

/// The instructions broadcast to one region. Linear expressions count x and y from the region's top left pixel. Without
/// instructions the region shows the background, and no pixel processor works on it.
struct Segment {
  Region region;
  std::vector<Instruction> instructions;
  SegmentFacts facts{};
  DivisionCounts division{};  ///< nothing without a display model
  Preparation preparation{};  ///< of the host, for these instructions

  bool operator==(const Segment&) const = default;
};

/// What a field of pixel memory holds, for pictures, stats and waves.
// While surfaces are drawn; then all.
#define CSGSIM_SURFACE_ROLES(R) \
  R(scratch) R(candidate_depth) R(depth) R(colour) R(candidate_colour) R(mask) R(stack) R(product) R(label) R(stored)
#define CSGSIM_FIELD_ROLES(R) CSGSIM_SURFACE_ROLES(R) R(shown) R(owner) R(effect)

enum class FieldRole : std::uint8_t {
#define CSGSIM_FIELD_ROLE_ENUMERATOR(name) name,
  CSGSIM_FIELD_ROLES(CSGSIM_FIELD_ROLE_ENUMERATOR)
#undef CSGSIM_FIELD_ROLE_ENUMERATOR
};

inline constexpr auto field_role_names = std::to_array<std::string_view>({
#define CSGSIM_FIELD_ROLE_NAME(name) #name,
    CSGSIM_FIELD_ROLES(CSGSIM_FIELD_ROLE_NAME)
#undef CSGSIM_FIELD_ROLE_NAME
});

constexpr std::string_view name_of(FieldRole role) { return field_role_names[static_cast<std::size_t>(role)]; }

struct NamedField {
  std::string name;
  Field field;
  FieldRole role = FieldRole::scratch;

  bool operator==(const NamedField&) const = default;
};

/// How the integers of the depth field stand for distances from the eye along the view axis, in model units.
/// Orthographic: z = 1 + (d - near) * (2^n - 4) / (far - near).
/// Perspective:  z = 1 + (1/near - 1/d) * (2^n - 4) / (1/near - 1/far).
/// 0 is the near cap, 2^n - 1 is "nothing".
struct DepthScale {
  bool perspective = false;
  double near = 0;  ///< model units
  double far = 1;   ///< model units

  bool operator==(const DepthScale&) const = default;
};

/// What the host knows of the model and tells in the stats.
struct ModelFacts {
  std::string file;
  std::uint64_t primitives = 0;
  std::uint64_t unions = 0;
  std::uint64_t differences = 0;
  std::uint64_t intersections = 0;
  std::uint64_t halfspaces = 0;

  bool operator==(const ModelFacts&) const = default;
};

/// How the host compiled.
struct CompileFacts {
  std::string strategy;
  std::string colouring;
  std::uint32_t z_bits = 0;
  std::uint32_t fraction_bits = 0;
  double edge_on_fraction = 0;       ///< of a pixel
  std::uint32_t stack_bits = 0;      ///< bits of pixel memory that the classification uses
  std::uint32_t tree_depth = 0;      ///< levels of the deepest active tree
  std::uint64_t rendered = 0;        ///< scan-conversions: primitives whose surface goes into Z1
  std::uint64_t classified = 0;      ///< scan-conversions: primitives of active trees compared with Z1
  std::uint64_t depth_tests = 0;     ///< comparisons of Z1 with Z2
  std::vector<std::string> effects;  ///< flat shading first, then those that the scene calls for

  bool operator==(const CompileFacts&) const = default;
};

/// Pixels, of an array or of the picture that a Program draws, and the memory of each.
struct ArrayShape {
  std::uint32_t width = 0;        ///< pixels
  std::uint32_t height = 0;       ///< pixels
  std::uint32_t memory_bits = 0;  ///< a pixel

  constexpr bool operator==(const ArrayShape&) const = default;
};

/// The rows of the picture from the first to the last that have instructions for a primitive's piece.
struct RowExtent {
  std::uint16_t first = 0;
  std::uint16_t last = 0;

  constexpr bool operator==(const RowExtent&) const = default;
};

/// The machine that a Program was compiled for. All empty: it does not say.
struct MachineRecord {
  std::string name;                  ///< as machines are named, with changed figures behind it
  std::string kind;                  ///< empty: the one of the machine of that name that comes with csgsim
  std::vector<std::string> figures;  ///< KEY=VALUE; those that are left out are as that machine has them

  bool operator==(const MachineRecord&) const = default;
};

/// What people are told of a Program, in stats, pictures and waves. No hardware reads it.
struct Facts {
  std::vector<NamedField> fields;
  std::vector<std::string> primitives;  ///< a name for each
  /// Of each piece that origins name the primitive it belongs to, in order (hw/isa/pieces.h); none: each primitive is
  /// one piece.
  std::vector<std::uint32_t> primitive_of_piece{};
  DepthScale depth_scale;
  ModelFacts model;
  CompileFacts compile;

  bool operator==(const Facts&) const = default;
};

/// All that crosses from host to machine, and what is known of it.
struct Program {
  MachineRecord machine{};
  ArrayShape shape;              ///< the whole picture
  Field colour{};                ///< of pixel memory, which is shown; of width 0 where nothing is
  std::uint32_t background = 0;  ///< colour where nothing is seen, as the colour field holds it
  std::vector<Segment> segments;
  /// What a host that keeps a list of the pieces on a line sorts into buckets, a piece each, in no order that matters;
  /// none for other machines.
  std::vector<RowExtent> extents{};
  /// What a machine that divides the model itself is sent in place of the segments, the first bit in the lowest of the
  /// first byte; none for other machines. The segments are what it has to make of that.
  std::vector<std::uint8_t> display_model{};
  Preparation preparation{};  ///< of the host, for the frame, before the first segment
  Facts facts;

  bool operator==(const Program&) const = default;
};

/// What a machine is told of a frame besides its segments.
struct FrameHeader {
  ArrayShape shape;              ///< the whole picture
  Field colour;                  ///< of pixel memory, which is shown; of width 0 where nothing is
  std::uint32_t background = 0;  ///< colour of a region without instructions

  constexpr bool operator==(const FrameHeader&) const = default;
};

FrameHeader frame_header(const Program& program);

/// How many all its segments have.
std::size_t instructions_in(const Program& program);

/// The field that people are told has that role, or one of width 0 if there is none.
Field field_of(const Program& program, FieldRole role);

/// Throws InputError unless the instruction can run on an array of that memory: opcode in the table, fields inside the
/// memory and of the widths the opcode asks for, fields of one instruction disjoint (single bits may coincide), linear
/// width and shift in range and wide enough for the field it meets, constant no wider than its target, count not 0,
/// unused operands zero.
void validate(const Instruction& instruction, std::uint32_t memory_bits);

/// Throws InputError unless every part of the Program is sound; says which segment and instruction is not.
void validate(const Program& program);

}  // namespace csgsim::isa
