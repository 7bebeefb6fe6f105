#include "sim/debug/stops.h"

#include <fmt/format.h>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "sim/debug/condition.h"

namespace csgsim::debug {

Stop::Stop(const Target& target, const isa::Program& program, const engine::Numbers& numbers, const engine::Run& run,
           Clocks& clocks)
    : target_(target), program_(program), numbers_(numbers), run_(run), begin_(numbers.of(run.place())) {
  if (const auto* at = std::get_if<AtInstruction>(&target)) {
    if (at->number >= numbers.count())
      throw InputError(
          fmt::format("there is no instruction i{}: the Program has {}, counted from i0", at->number, numbers.count()));
    number_ = at->number;
  }
  if (const auto* at = std::get_if<AtClock>(&target)) number_ = clocks.first_not_issued(at->clock, begin_);
  const auto* condition = std::get_if<Condition>(&target);
  if (condition == nullptr || program.segments.empty()) return;
  if (!run.region().holds(condition->watched.x, condition->watched.y)) return;
  segment_ = run.place().segment;
  value_ = read_value(condition->watched, run);
  held_ = holds(*condition, value_, value_);
}

bool Stop::is_behind() const {
  const bool is_place = std::holds_alternative<AtInstruction>(target_) || std::holds_alternative<AtClock>(target_);
  return is_place && number_ <= begin_;
}

bool Stop::is_first_of_primitive(std::uint32_t primitive, std::uint64_t number) const {
  const auto serves = [&](std::uint64_t one) {
    const auto [segment, index] = numbers_.place(one);
    const std::uint32_t piece = program_.segments[segment].instructions[index].origin.primitive;
    return isa::primitive_of(*program_.facts, piece) == primitive;
  };
  return number < numbers_.count() && serves(number) && (number == 0 || !serves(number - 1));
}

std::uint64_t Stop::next_check_of_primitive(std::uint32_t primitive, std::uint64_t first_number) const {
  for (std::uint64_t number = first_number + 1; number < numbers_.count(); ++number)
    if (is_first_of_primitive(primitive, number)) return number;
  return engine::Run::end;
}

std::uint64_t Stop::next_check_of_condition(const Condition& condition, std::uint64_t first_number) const {
  for (std::uint64_t number = first_number; number < numbers_.count();) {
    const auto [segment, index] = numbers_.place(number);
    const isa::Segment& part = program_.segments[segment];
    if (!part.region.holds(condition.watched.x, condition.watched.y)) {
      number = numbers_.first(segment + 1);
      continue;
    }
    if (can_change(part.instructions[index], condition.watched.field)) return number + 1;
    ++number;
  }
  return engine::Run::end;
}

std::uint64_t Stop::next_check() {
  const std::uint64_t from = numbers_.of(run_.place());
  if (next_check_ > from) return next_check_;
  if (const auto* condition = std::get_if<Condition>(&target_)) {
    next_check_ = next_check_of_condition(*condition, from);
  } else if (const auto* at = std::get_if<AtPrimitive>(&target_)) {
    next_check_ = next_check_of_primitive(at->primitive, from);
  } else {
    next_check_ = number_ > from ? number_ : engine::Run::end;
  }
  return next_check_;
}

bool Stop::is_met(const Condition& condition) {
  const std::uint32_t segment = run_.place().segment;
  if (!run_.region().holds(condition.watched.x, condition.watched.y)) return false;
  if (segment_ != segment) {  // memory is 0 at the start of a segment
    segment_ = segment;
    value_ = 0;
    held_ = holds(condition, 0, 0);
  }
  const std::uint32_t before = value_;
  value_ = read_value(condition.watched, run_);
  const bool held_before = held_;
  held_ = condition.relation != Relation::changes && holds(condition, value_, before);
  return condition.relation == Relation::changes ? value_ != before : held_ && !held_before;
}

bool Stop::is_reached() {
  const std::uint64_t here = numbers_.of(run_.place());
  if (here < next_check_ || here == begin_) return false;
  if (const auto* condition = std::get_if<Condition>(&target_)) return is_met(*condition);
  if (const auto* at = std::get_if<AtPrimitive>(&target_)) return is_first_of_primitive(at->primitive, here);
  return begin_ < number_ && here >= number_;
}

}  // namespace csgsim::debug
