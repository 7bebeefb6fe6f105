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

/// What a stretch of instructions does at a pixel.
enum class What : std::uint8_t {
  setup,       ///< nothing is seen yet
  surface,     ///< a primitive's visible surface into Z1
  depth_test,  ///< Z1 against Z2
  comparison,  ///< Z1 against a primitive of the active tree
  bits,        ///< results of comparisons combined
  merge,       ///< Z1 becomes Z2
  shade,       ///< colour
  effect,      ///< what an effect does that no surface asks for
  skip,        ///< instructions that a skip_if_none leaves out
  stored,      ///< a primitive's depths into fields of their own
};

/// A field that was written. Of several writes the value before the first and that after the last.
struct Change {
  isa::Field field;  ///< the named one, if the target lies within one
  std::uint64_t before = 0;
  std::uint64_t after = 0;
  std::uint64_t number = 0;  ///< of the instruction that wrote last

  [[nodiscard]] bool differs() const { return before != after; }
};

/// A depth of a quadric at the pixel, worked out by instructions before one that uses it: near = M - (q << unit), far =
/// M + ((q + 1) << unit), with q = floor(sqrt(D)) (host/view/screen_quadric.h).
struct QuadricDepth {
  isa::Instruction squares;        ///< the first three coefficients of the discriminant
  isa::Instruction load;           ///< the others; it comes directly after the squares
  std::uint64_t load_number = 0;   ///< of that instruction
  std::int64_t discriminant = 0;   ///< D
  isa::Field field;                ///< in which the root was taken
  std::uint64_t root_number = 0;   ///< of the instruction that took it
  std::uint64_t root = 0;          ///< q
  std::uint64_t depth_number = 0;  ///< of the instruction that made the depth of it
  std::int64_t middle = 0;         ///< F of that instruction: M, or M + (1 << unit) of the far depth
  std::uint64_t offset = 0;        ///< q << unit
  bool far = false;
};

/// An instruction that decided something, with what it met at the pixel.
struct Decision {
  std::uint32_t segment = 0;
  std::uint64_t number = 0;
  isa::Instruction instruction;
  std::int64_t value = 0;                     ///< F; 0 without a linear expression
  std::uint64_t met = 0;                      ///< the instruction's first field before it
  std::uint64_t met_too = 0;                  ///< its second field
  std::optional<isa::Instruction> squares{};  ///< those that its linear expression has besides
  std::optional<QuadricDepth> quadric{};      ///< the depth that it compares or copies, if it is a quadric's
};

/// Instructions with one origin, one after another, that had the pixel enabled or wrote to its memory.
struct Event {
  What what{};
  std::uint32_t segment = 0;
  std::uint64_t first = 0;     ///< number of the first instruction (hw/isa/instruction_numbers.h)
  std::uint64_t last = 0;      ///< of the last
  machines::ClockSpan clocks;  ///< in which the pixel carries them out; empty where they are not told, or skipped
  isa::Origin origin;
  bool enabled_before = false;
  bool enabled_after = false;
  /// Which instruction took the pixel out, if it is enabled no more.
  std::optional<Decision> cut;
  /// surface: which put Z1 there; shade: which found the facet; depth_test: the comparison with Z2.
  std::optional<Decision> decision;
  std::optional<Decision> misfit;  ///< the first whose A*x + B*y + C did not fit its width where the pixel was enabled
  std::vector<Change> changes;
  isa::Field merged_into;          ///< merge: the field that the depth came to
  bool takes_pixel = false;        ///< merge: its primitive is the owner then
  bool by_results = false;         ///< bits: results of several comparisons took part, not the last one alone
  std::uint32_t owner_before = 0;  ///< primitive that owns the pixel; observe::no_owner if none does
  std::uint32_t owner_after = 0;   ///< the same

  /// The first change of a field of that role; null if there is none.
  [[nodiscard]] const Change* change_of(const isa::Program& program, isa::FieldRole role) const;
};

/// How a surface that was drawn ended at the pixel.
enum class Fate : std::uint8_t {
  outside,     ///< cut out before it had a depth: beside the primitive's outline
  no_depth,    ///< a half-space of its other side, or the depth range, leaves nothing of it
  refused,     ///< an effect or a mirror does not admit it
  behind,      ///< Z1 is not nearer than Z2
  classified,  ///< taken out by primitives of its active tree
  covered,     ///< merged, and another merged over it later
  blended,     ///< merged, and a part of the colour, but not the nearest: seen through glass, in a mirror, by a sample
  seen,        ///< merged, and the nearest that is seen: owner of the pixel in the end
};

/// A primitive's surface, or that of several which make one convex solid, from its rendering to its merge.
struct Attempt {
  std::uint32_t primitive = 0;  ///< of several the first
  std::uint32_t shown = 0;      ///< merged: of several that whose facet it is at the pixel, as far as colours tell
  std::size_t first_event = 0;  ///< into Story::events: its rendering
  std::size_t last_event = 0;   ///< the last before another surface is rendered, or an effect works
  Fate fate{};
  /// The event that decided: surface, depth_test, the bits that emptied the mask, the merge that covered it, or its
  /// own.
  std::size_t deciding_event = 0;
  /// classified: the comparison that decided by itself, if one did.
  std::optional<std::size_t> deciding_comparison;
};

/// A part of the picture that holds the pixel.
struct StorySegment {
  std::uint32_t segment = 0;
  std::uint64_t first = 0;  ///< number of its first instruction
  std::uint64_t end = 0;    ///< one more than that of its last
};

/// All that happened at a pixel in a frame.
struct Story {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::vector<StorySegment> segments;  ///< one, unless the picture is drawn several times; none: the background shows
  std::uint32_t owner = 0;             ///< primitive of the nearest surface seen; observe::no_owner if none is
  std::uint32_t depth = 0;             ///< of that surface, steps; all ones where nothing is seen
  std::uint32_t opaque_owner = 0;      ///< of the opaque surface seen, which others may be before: the same
  std::uint32_t opaque_depth = 0;      ///< the same
  std::uint32_t colour = 0;            ///< as the colour field holds it
  std::vector<Event> events;           ///< in the order of the instructions
  std::vector<Attempt> attempts;
};

/// Whether the nearest surface is see-through and blended with what is behind it.
inline bool is_seen_through(const Story& story) { return story.depth != story.opaque_depth; }

/// Tells the stories of a Program's pixels. The Program has to outlive it.
class Teller {
 public:
  /// Runs the Program once, at the functional level, if only a run tells its clocks. Throws InputError if the machine
  /// cannot run it.
  Teller(const isa::Program& program, const machines::Machine& machine);

  /// Throws InputError where the picture has no such pixel.
  [[nodiscard]] Story story_of(std::uint32_t x, std::uint32_t y) const;

 private:
  const isa::Program& program_;
  machines::Machine machine_;
  std::vector<std::uint64_t> first_numbers_;
  machines::RunRecord record_;
  std::optional<machines::Timeline> timeline_;  ///< none of a kind of machine that does not tell
};

}  // namespace csgsim::story
