// The history of a pixel in a frame.
// Used by sim/story, sim/app and sim/report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/isa/field_role.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"

namespace csgsim::story {

/// Kind of a stretch of instructions at a pixel.
enum class EventKind : std::uint8_t {
  setup,       ///< initial values, before any surface
  surface,     ///< a primitive's visible surface is written into Z1
  depth_test,  ///< comparison of Z1 with Z2
  comparison,  ///< comparison of Z1 with a primitive of the active tree
  bits,        ///< combination of the results of comparisons
  merge,       ///< Z1 is copied to Z2
  shade,       ///< the colour is written
  effect,      ///< work of an effect for no particular surface
  skip,        ///< instructions skipped by a skip_if_none
  stored,      ///< a primitive's depths are stored in separate fields
};

/// The change of a written field, from its value before the first write to that after the last.
struct Change {
  isa::Field field;  ///< the named field, if the target lies within one
  std::uint64_t before = 0;
  std::uint64_t after = 0;
  std::uint64_t number = 0;  ///< number of the last writing instruction

  [[nodiscard]] bool differs() const { return before != after; }
};

/// A depth of a quadric at the pixel, computed before the instruction that uses it: near = M - (q << unit), far = M +
/// ((q + 1) << unit), with q = floor(sqrt(D)) (host/view/screen_quadric.h).
struct QuadricDepth {
  isa::Instruction squares;        ///< the first three coefficients of the discriminant
  isa::Instruction load;           ///< the other coefficients; directly follows the squares
  std::uint64_t load_number = 0;   ///< number of that instruction
  std::int64_t discriminant = 0;   ///< D
  isa::Field field;                ///< field in which the root was taken
  std::uint64_t root_number = 0;   ///< number of the instruction that took the root
  std::uint64_t root = 0;          ///< q
  std::uint64_t depth_number = 0;  ///< number of the instruction that computed the depth from it
  std::int64_t middle = 0;         ///< F of that instruction: M, or M + (1 << unit) for the far depth
  std::uint64_t offset = 0;        ///< q << unit
  bool is_far = false;
};

/// A deciding instruction, with its operands at the pixel.
struct Decision {
  std::uint32_t segment = 0;
  std::uint64_t number = 0;
  isa::Instruction instruction;
  std::int64_t value = 0;                     ///< F; 0 without a linear expression
  std::uint64_t first_operand = 0;            ///< value of the instruction's first field before it
  std::uint64_t second_operand = 0;           ///< value of its second field
  std::optional<isa::Instruction> squares{};  ///< quadratic terms of its expression, if it has any
  std::optional<QuadricDepth> quadric{};      ///< the depth that it compares or copies, if it belongs to a quadric
};

/// Consecutive instructions of one origin that found the pixel enabled or wrote its memory.
struct Event {
  EventKind kind{};
  std::uint32_t segment = 0;
  std::uint64_t first = 0;     ///< number of the first instruction (hw/isa/instruction_numbers.h)
  std::uint64_t last = 0;      ///< number of the last instruction
  machines::ClockSpan clocks;  ///< clocks in which the pixel executes them; empty if unknown or skipped
  isa::Origin origin;
  bool enabled_before = false;
  bool enabled_after = false;
  /// The instruction that disabled the pixel, if it is disabled afterwards.
  std::optional<Decision> cut;
  /// For a surface, the instruction that set Z1; for shade, the one that found the facet; for depth_test, the
  /// comparison with Z2.
  std::optional<Decision> decision;
  std::optional<Decision> misfit;  ///< the first instruction whose A*x + B*y + C did not fit its width while the pixel
                                   ///< was enabled
  std::vector<Change> changes;
  isa::Field merged_into;             ///< merge: the field that received the depth
  bool takes_pixel = false;           ///< merge: its primitive becomes the owner
  bool uses_several_results = false;  ///< bits: several comparison results took part, not only the last one
  std::uint32_t owner_before = 0;     ///< primitive that owns the pixel before; observe::no_owner if none
  std::uint32_t owner_after = 0;      ///< primitive that owns the pixel after

  /// The first change of a field with that role; null if there is none.
  [[nodiscard]] const Change* change_of(const isa::Program& program, isa::FieldRole role) const;
};

/// Outcome of a drawn surface at the pixel.
enum class Fate : std::uint8_t {
  outside,     ///< the pixel, beside the primitive's outline, was disabled before it had a depth
  no_depth,    ///< nothing remains between the half-spaces of its other side, or within the depth range
  refused,     ///< rejected by an effect or a mirror
  behind,      ///< Z1 is not nearer than Z2
  classified,  ///< removed by primitives of its active tree
  covered,     ///< merged, and later covered by another merge
  blended,     ///< merged and a part of the colour, but not nearest: behind glass, in a mirror, at another sample
  seen,        ///< merged and nearest: final owner of the pixel
};

/// A surface of a primitive, or of several that form one convex solid, from its rendering to its merge.
struct Attempt {
  std::uint32_t primitive = 0;  ///< the first one, if there are several
  std::uint32_t shown = 0;      ///< if merged: the primitive whose facet is at the pixel, found by its colour
  std::size_t first_event = 0;  ///< index into Story::events: its rendering
  std::size_t last_event = 0;   ///< the last event before another surface is rendered, or an effect begins
  Fate fate{};
  /// Index of the deciding event: surface, depth_test, the bits that emptied the mask, the merge that covered the
  /// surface, or its own merge.
  std::size_t deciding_event = 0;
  /// classified: the comparison that decided alone, if there is one.
  std::optional<std::size_t> deciding_comparison;
};

/// A segment that contains the pixel.
struct StorySegment {
  std::uint32_t segment = 0;
  std::uint64_t first = 0;  ///< number of its first instruction
  std::uint64_t end = 0;    ///< number after its last instruction
};

/// The history of a pixel in a frame.
struct Story {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::vector<StorySegment> segments;  ///< one, or several if the picture is drawn several times; none: the background
                                       ///< shows
  std::uint32_t owner = 0;             ///< primitive of the nearest visible surface; observe::no_owner if none
  std::uint32_t depth = 0;             ///< depth of that surface in steps; all ones if nothing is visible
  std::uint32_t opaque_owner = 0;      ///< primitive of the visible opaque surface, possibly behind others
  std::uint32_t opaque_depth = 0;      ///< depth of that surface
  std::uint32_t colour = 0;            ///< value of the colour field
  std::vector<Event> events;           ///< events in program order
  std::vector<Attempt> attempts;
};

/// Whether the nearest surface is transparent and blended with what is behind it.
inline bool is_seen_through(const Story& story) { return story.depth != story.opaque_depth; }

/// Computes the stories of a Program's pixels. The Program must outlive this object.
class StoryBuilder {
 public:
  /// Runs the Program once at the functional level if its clocks depend on the run. Throws InputError if the machine
  /// cannot run it.
  StoryBuilder(const isa::Program& program, const machines::Machine& machine);

  /// Throws InputError if the picture has no such pixel.
  [[nodiscard]] Story story_of(std::uint32_t x, std::uint32_t y) const;

 private:
  const isa::Program& program_;
  machines::Machine machine_;
  std::vector<std::uint64_t> first_numbers_;
  machines::RunRecord record_;
  std::optional<machines::Timeline> timeline_;  ///< nothing if the machine's kind provides none
};

}  // namespace csgsim::story
