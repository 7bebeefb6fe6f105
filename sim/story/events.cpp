#include "sim/story/events.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "sim/observe/frame.h"

namespace csgsim::story {

namespace {

using isa::FieldRole;
using isa::Opcode;
using isa::Purpose;

bool compares_fields(Opcode opcode) { return opcode == Opcode::field_lt || opcode == Opcode::field_le; }

/// Whether the instruction stores depths for classification; instructions that compare them name a node.
bool stores_classified_depths(const isa::Origin& origin) {
  return origin.purpose == Purpose::classify && origin.node == isa::no_node;
}

bool adds_to_expression(Opcode opcode) { return opcode == Opcode::linear_plus || opcode == Opcode::linear_minus; }

/// Whether the instruction may produce the depth of a facet or of a quadric.
bool may_set_depth(Opcode opcode) {
  if (opcode == Opcode::copy || adds_to_expression(opcode)) return true;
  return opcode == Opcode::load_linear || opcode == Opcode::set_constant || opcode == Opcode::keep_max ||
         opcode == Opcode::keep_min;
}

/// Whether the instruction produced the pixel's depth.
bool sets_depth(Opcode opcode, const PixelStep& step) {
  if (!step.enabled_before) return false;
  if (opcode == Opcode::keep_max) return step.value > static_cast<std::int64_t>(step.first_operand);
  if (opcode == Opcode::keep_min) return step.value < static_cast<std::int64_t>(step.first_operand);
  return true;
}

/// An event in progress.
struct Open {
  Event event;
  bool is_met = false;       ///< the pixel was enabled or written
  bool tests_depth = false;  ///< includes a comparison of fields
};

/// Splits the steps of a run into events; an event ends where the origin changes.
class Narrator {
 public:
  Narrator(const isa::Program& program, const PixelRun& run, std::span<const std::uint64_t> first_instruction_numbers)
      : program_(program), run_(run), first_numbers_(first_instruction_numbers) {}

  std::vector<Event> narrate() {
    for (const PixelStep& step : run_.steps) {
      if (open_ && open_->event.segment != step.segment) close();
      take(step);
      owner_ = step.owner;
    }
    close();
    return std::move(events_);
  }

 private:
  [[nodiscard]] const isa::Instruction& instruction_of(const PixelStep& step) const {
    return program_.segments[step.segment].instructions[step.index];
  }

  [[nodiscard]] std::uint64_t number_of(const PixelStep& step) const {
    return first_numbers_[step.segment] + step.index;
  }

  [[nodiscard]] Decision decision_of(const PixelStep& step) const {
    const isa::Instruction& instruction = instruction_of(step);
    Decision decision{step.segment, number_of(step), instruction, step.value, step.first_operand, step.second_operand};
    if (const isa::Instruction* const squares = isa::pending_squares(program_.segments[step.segment], step.index))
      decision.squares = *squares;
    if (uses_quadric(instruction)) decision.quadric = quadric_;
    return decision;
  }

  /// Whether the instruction may use a depth computed from a root: surfaces are drawn or compared there.
  [[nodiscard]] bool uses_quadric(const isa::Instruction& instruction) const {
    const Purpose purpose = instruction.origin.purpose;
    if (purpose != Purpose::render && purpose != Purpose::classify) return false;
    if (uses_stored_depth(instruction)) return false;
    return compares_fields(instruction.opcode) || instruction.opcode == Opcode::copy ||
           adds_to_expression(instruction.opcode);
  }

  /// Whether the instruction uses a depth stored earlier.
  [[nodiscard]] bool uses_stored_depth(const isa::Instruction& instruction) const {
    if (stores_classified_depths(instruction.origin)) return false;
    return std::ranges::any_of(instruction.fields,
                               [&](isa::Field field) { return has_role(field, FieldRole::stored); });
  }

  [[nodiscard]] bool has_role(isa::Field field, FieldRole role) const {
    return std::any_of(program_.facts->fields.begin(), program_.facts->fields.end(), [&](const isa::NamedField& named) {
      return named.role == role && field.width > 0 && named.field.overlaps(field);
    });
  }

  [[nodiscard]] bool is_result(isa::Field field) const {
    return has_role(field, FieldRole::stack) || has_role(field, FieldRole::product);
  }

  /// Whether the surface's colours are being written beside Z1.
  [[nodiscard]] bool goes_on_with_surface(const isa::Origin& origin) const {
    return open_ && open_->event.kind == EventKind::surface &&
           (origin.purpose == Purpose::shade ||
            (origin.purpose == Purpose::render && origin.primitive == open_->event.origin.primitive));
  }

  [[nodiscard]] bool copies_depth(const isa::Instruction& instruction) const {
    return instruction.opcode == Opcode::copy && z1_.width > 0 && instruction.fields[1] == z1_;
  }

  [[nodiscard]] EventKind find_kind(const isa::Instruction& instruction) const {
    const isa::Origin& origin = instruction.origin;
    if (goes_on_with_surface(origin)) return EventKind::surface;
    switch (origin.purpose) {
      case Purpose::setup: return EventKind::setup;
      case Purpose::render: return EventKind::surface;
      case Purpose::classify: return stores_classified_depths(origin) ? EventKind::stored : EventKind::comparison;
      case Purpose::stack: return EventKind::bits;
      case Purpose::shade: return EventKind::shade;
      case Purpose::effect: return EventKind::effect;
      case Purpose::merge: {
        const bool goes_on = open_ && open_->event.kind == EventKind::merge &&
                             open_->event.origin.primitive == origin.primitive && !compares_fields(instruction.opcode);
        return goes_on || copies_depth(instruction) ? EventKind::merge : EventKind::depth_test;
      }
    }
    return EventKind::effect;
  }

  void take(const PixelStep& step) {
    const isa::Instruction& instruction = instruction_of(step);
    if (instruction.opcode == Opcode::skip_if_none) return take_question(step);
    const EventKind kind = find_kind(instruction);
    const bool goes_on =
        open_ && open_->event.kind == kind &&
        (kind == EventKind::surface || kind == EventKind::merge || open_->event.origin == instruction.origin);
    if (!goes_on) begin(kind, instruction.origin, step);
    note_quadric(instruction, step);
    if (kind == EventKind::surface && instruction.origin.purpose == Purpose::render) note_depth(instruction, step);
    note_bits(instruction, step);
    note_change(step);
    note_cut(instruction, step);
    if (!step.fits && step.enabled_before && !open_->event.misfit) open_->event.misfit = decision_of(step);
    if (compares_fields(instruction.opcode)) {
      open_->tests_depth = true;
      // Within a surface, the comparison concerns a facet's depth and does not decide the final result.
      if (step.enabled_before && kind != EventKind::surface) open_->event.decision = decision_of(step);
    }
    if (kind == EventKind::shade && instruction.opcode == Opcode::linear_eq && step.enabled_after)
      open_->event.decision = decision_of(step);
    open_->is_met = open_->is_met || step.enabled_before || step.enabled_after;
    open_->event.last = number_of(step);
    open_->event.enabled_after = step.enabled_after;
    open_->event.owner_after = step.owner;
    if (kind == EventKind::merge && copies_depth(instruction)) {
      open_->event.merged_into = step.target;
      open_->event.takes_pixel = step.takes_pixel;
    }
  }

  void take_question(const PixelStep& step) {
    if (step.skipped == 0) return;
    close();
    const std::uint64_t after = number_of(step) + 1;
    Event event;
    event.kind = EventKind::skip;
    event.segment = step.segment;
    event.first = after;
    event.last = after + step.skipped - 1;
    event.origin = instruction_of(step).origin;
    event.decision = decision_of(step);
    event.owner_before = event.owner_after = owner_;
    events_.push_back(event);
  }

  void begin(EventKind kind, const isa::Origin& origin, const PixelStep& step) {
    close();
    open_.emplace();
    open_->event.kind = kind;
    open_->event.segment = step.segment;
    open_->event.first = number_of(step);
    open_->event.origin = origin;
    open_->event.enabled_before = step.enabled_before;
    open_->event.owner_before = owner_;
    if (kind == EventKind::surface) {
      z1_ = {};
      with_results_ = false;
    }
  }

  /// Whether the field holds intermediate values of quadrics or a part of a depth, not a surface's depth.
  [[nodiscard]] bool is_scratch(isa::Field field) const {
    return std::any_of(program_.facts->fields.begin(), program_.facts->fields.end(), [&](const isa::NamedField& named) {
      return named.field.overlaps(field) &&
             (named.role == FieldRole::scratch || (named.role == FieldRole::candidate_depth && named.field != field));
    });
  }

  /// Follows the computation of a quadric's depth.
  void note_quadric(const isa::Instruction& instruction, const PixelStep& step) {
    const isa::Segment& segment = program_.segments[step.segment];
    if (instruction.opcode == Opcode::load_linear) {
      quadric_.reset();
      const isa::Instruction* const squares = isa::pending_squares(segment, step.index);
      if (squares == nullptr) return;
      quadric_.emplace();
      quadric_->squares = *squares;
      quadric_->load = instruction;
      quadric_->load_number = number_of(step);
      quadric_->discriminant = step.value;
    }
    if (!quadric_ || !step.enabled_before) return;
    if (instruction.opcode == Opcode::root) {
      quadric_->field = instruction.fields[0];
      quadric_->root_number = number_of(step);
      if (step.target == quadric_->field) quadric_->root = step.after >> (quadric_->field.width / 2 + 1U);
    } else if (adds_to_expression(instruction.opcode)) {
      quadric_->depth_number = number_of(step);
      quadric_->middle = step.value;
      quadric_->offset = step.first_operand;
      quadric_->is_far = instruction.opcode == Opcode::linear_plus;
    }
  }

  void note_depth(const isa::Instruction& instruction, const PixelStep& step) {
    if (!may_set_depth(instruction.opcode) || is_scratch(instruction.fields[0])) return;
    z1_ = instruction.fields[0];
    if (sets_depth(instruction.opcode, step)) open_->event.decision = decision_of(step);
  }

  /// Determines whether the next narrowing of the mask depends on the last comparison only.
  void note_bits(const isa::Instruction& instruction, const PixelStep& step) {
    if (instruction.origin.purpose != Purpose::stack) return;
    const isa::Operands& operands = isa::operands_of(instruction.opcode);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (operands[i] == isa::OperandKind::source && is_result(instruction.fields[i])) with_results_ = true;
    }
    const bool meets_mask = has_role(instruction.fields[0], FieldRole::mask);
    if (!meets_mask) return;
    if (step.before == 1 && step.after == 0 && step.target.width > 0) open_->event.uses_several_results = with_results_;
    if (instruction.opcode == Opcode::enable_load || step.target.width > 0) with_results_ = false;
  }

  void note_change(const PixelStep& step) {
    const bool is_written = step.target.width > 0 && (step.enabled_before || step.before != step.after);
    if (!is_written) return;
    std::vector<Change>& changes = open_->event.changes;
    const auto known =
        std::find_if(changes.begin(), changes.end(), [&](const Change& one) { return one.field == step.target; });
    const std::uint64_t number = number_of(step);
    if (known == changes.end()) {
      changes.push_back({step.target, step.before, step.after, number});
    } else {
      known->after = step.after;
      known->number = number;
    }
    open_->is_met = true;
  }

  void note_cut(const isa::Instruction& instruction, const PixelStep& step) {
    if (step.enabled_after) {
      open_->event.cut.reset();
    } else if (step.enabled_before && instruction.opcode != Opcode::enable_load) {
      open_->event.cut = decision_of(step);
    }
  }

  void close() {
    if (!open_) return;
    if (is_reported(*open_)) events_.push_back(open_->event);
    open_.reset();
  }

  [[nodiscard]] static bool is_reported(const Open& open) {
    const std::vector<Change>& changes = open.event.changes;
    const bool differs = std::any_of(changes.begin(), changes.end(), [](const Change& one) { return one.differs(); });
    switch (open.event.kind) {
      case EventKind::setup:
      case EventKind::stored:
      case EventKind::shade: return !changes.empty();
      case EventKind::surface: return open.is_met;
      case EventKind::merge: return !changes.empty();
      case EventKind::depth_test: return (open.tests_depth || open.event.cut) && (open.event.enabled_before || differs);
      case EventKind::comparison: return open.event.enabled_before;
      case EventKind::bits:
      case EventKind::effect:
      case EventKind::skip: return differs;
    }
    return false;
  }

  const isa::Program& program_;
  const PixelRun& run_;
  std::span<const std::uint64_t> first_numbers_;
  std::vector<Event> events_;
  std::optional<Open> open_;
  std::uint32_t owner_ = observe::no_owner;
  isa::Field z1_;                        ///< field of the surface's depth
  std::optional<QuadricDepth> quadric_;  ///< computed last
  bool with_results_ = false;            ///< E holds results of several comparisons
};

}  // namespace

std::vector<Event> find_events(const isa::Program& program, const PixelRun& run,
                               std::span<const std::uint64_t> first_instruction_numbers) {
  return Narrator(program, run, first_instruction_numbers).narrate();
}

}  // namespace csgsim::story
