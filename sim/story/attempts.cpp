#include <algorithm>
#include <optional>

#include "hw/isa/facts.h"
#include "sim/story/events.h"

namespace csgsim::story {

namespace {

using Events = std::span<const Event>;

/// Whether the event belongs to the surface rendered last.
bool belongs_to_surface(const Event& event, std::uint32_t primitive, std::uint32_t segment) {
  const isa::Origin& origin = event.origin;
  if (event.segment != segment) return false;
  switch (event.kind) {
    case EventKind::depth_test:
    case EventKind::comparison:
    case EventKind::bits:
    case EventKind::merge:
    case EventKind::skip: return origin.primitive == primitive && origin.purpose != isa::Purpose::render;
    case EventKind::shade: return origin.primitive == primitive || origin.node == primitive;
    case EventKind::setup:
    case EventKind::surface:
    case EventKind::stored:
    case EventKind::effect: return false;
  }
  return false;
}

/// The last event of the attempt that satisfies the predicate.
template <class Holds>
std::optional<std::size_t> last_that(Events events, const Attempt& attempt, Holds holds) {
  for (std::size_t i = attempt.last_event; i > attempt.first_event; --i)
    if (holds(events[i])) return i;
  return std::nullopt;
}

std::optional<std::size_t> last_of(Events events, const Attempt& attempt, EventKind kind) {
  return last_that(events, attempt, [kind](const Event& event) { return event.kind == kind; });
}

/// Number of depth tests that the pixel passed: one per product, where products are tested one by one.
std::ptrdiff_t passed_tests(Events events, const Attempt& attempt) {
  const Events own = events.subspan(attempt.first_event, attempt.last_event + 1 - attempt.first_event);
  return std::ranges::count_if(own, [](const Event& event) {
    return event.kind == EventKind::depth_test && event.decision && event.enabled_after;
  });
}

/// The attempt up to the withdrawal of Z1, if the surface is not admitted; later depth tests have no effect.
Attempt until_withdrawn(const isa::Program& program, Events events, const Attempt& attempt) {
  Attempt until = attempt;
  const auto withdrawn = last_that(events, attempt, [&](const Event& event) {
    return event.kind == EventKind::bits && event.change_of(program, isa::FieldRole::candidate_depth) != nullptr;
  });
  until.last_event = withdrawn.value_or(attempt.last_event);
  return until;
}

/// Whether the comparison of the depth test disabled the pixel, not another instruction of the event.
bool is_behind(const Event& surface, const Event& test) {
  return test.cut && test.decision && surface.decision &&
         test.cut->instruction.fields[0] == surface.decision->instruction.fields[0];
}

void find_classification(const isa::Program& program, Events events, Attempt& attempt) {
  attempt.fate = Fate::classified;
  const auto emptied = last_that(events, attempt, [&](const Event& event) {
    const Change* const mask = event.change_of(program, isa::FieldRole::mask);
    return event.kind == EventKind::bits && mask != nullptr && mask->before == 1 && mask->after == 0;
  });
  attempt.deciding_event = emptied.value_or(attempt.last_event);
  Attempt until = attempt;
  until.last_event = attempt.deciding_event;
  const auto comparison = last_of(events, until, EventKind::comparison);
  const auto count = std::count_if(events.begin() + static_cast<std::ptrdiff_t>(until.first_event),
                                   events.begin() + static_cast<std::ptrdiff_t>(until.last_event) + 1,
                                   [](const Event& event) { return event.kind == EventKind::comparison; });
  // The leaf that a label waits for depends on earlier results.
  const bool has_labels = isa::find_field(program, isa::FieldRole::label).width > 0;
  const bool has_products = passed_tests(events, attempt) > 1;
  const bool is_alone =
      count == 1 || (emptied && !events[*emptied].uses_several_results && !has_labels && !has_products);
  if (comparison && is_alone) attempt.deciding_comparison = comparison;
}

bool writes(const Event& event, isa::Field field) {
  return std::any_of(event.changes.begin(), event.changes.end(),
                     [field](const Change& one) { return one.field == field; });
}

/// Whether an event after the merge removes the merged surface from the pixel: another merge of the same drawing into
/// that depth field, or a new beginning of that drawing or of the whole picture.
bool covers(const isa::Program& program, const Event& event, const Event& merge) {
  if (event.kind == EventKind::setup)
    return writes(event, merge.merged_into) || event.change_of(program, isa::FieldRole::depth) != nullptr;
  return event.kind == EventKind::merge && event.merged_into == merge.merged_into &&
         event.origin.effect == merge.origin.effect;
}

/// The next event that removes the merged surface from the pixel.
std::optional<std::size_t> covered_by(const isa::Program& program, Events events, std::size_t merge) {
  for (std::size_t i = merge + 1; i < events.size(); ++i)
    if (covers(program, events[i], events[merge])) return i;
  return std::nullopt;
}

/// Finds the fate of a surface that was at the pixel but was not merged.
void find_unmerged_fate(const isa::Program& program, Events events, Attempt& attempt) {
  const Attempt tested = until_withdrawn(program, events, attempt);
  const auto test = last_of(events, tested, EventKind::depth_test);
  if (!test || !events[*test].enabled_before) {
    // another piece of the same solid is compared before the depth test
    const auto joint =
        last_that(events, tested, [](const Event& event) { return event.kind == EventKind::comparison && !event.cut; });
    if (joint) {
      attempt.fate = Fate::classified;
      attempt.deciding_event = *joint;
      attempt.deciding_comparison = joint;
      return;
    }
  }
  if (test && !events[*test].enabled_after) {
    attempt.fate = is_behind(events[attempt.first_event], events[*test]) ? Fate::behind : Fate::refused;
    attempt.deciding_event = *test;
    return;
  }
  find_classification(program, events, attempt);
}

void find_fate(const isa::Program& program, Events events, Attempt& attempt) {
  const Event& surface = events[attempt.first_event];
  attempt.deciding_event = attempt.first_event;
  if (!surface.enabled_after) {
    attempt.fate = surface.decision ? Fate::no_depth : Fate::outside;
    return;
  }
  const auto merge = last_of(events, attempt, EventKind::merge);
  if (!merge) return find_unmerged_fate(program, events, attempt);
  if (events[*merge].takes_pixel) attempt.shown = events[attempt.last_event].owner_after;
  const auto covering = covered_by(program, events, *merge);
  attempt.fate = covering ? Fate::covered : Fate::seen;
  attempt.deciding_event = covering.value_or(*merge);
}

/// Several surfaces may end uncovered. The nearest one, which took the pixel last, is visible; the others contribute to
/// the colour.
void mark_blended(Events events, std::span<Attempt> attempts, std::uint32_t owner) {
  const auto nearest = std::find_if(attempts.rbegin(), attempts.rend(), [&](const Attempt& one) {
    return one.fate == Fate::seen && events[one.deciding_event].takes_pixel;
  });
  if (nearest == attempts.rend()) return;
  for (Attempt& one : attempts)
    if (one.fate == Fate::seen && &one != &*nearest) one.fate = Fate::blended;
  nearest->shown = owner;
}

}  // namespace

std::vector<Attempt> find_attempts(const isa::Program& program, std::span<const Event> events, std::uint32_t owner) {
  std::vector<Attempt> attempts;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind != EventKind::surface) continue;
    Attempt attempt;
    attempt.primitive = attempt.shown = events[i].origin.primitive;
    attempt.first_event = attempt.last_event = i;
    while (attempt.last_event + 1 < events.size() &&
           belongs_to_surface(events[attempt.last_event + 1], attempt.primitive, events[i].segment))
      ++attempt.last_event;
    find_fate(program, events, attempt);
    attempts.push_back(attempt);
  }
  mark_blended(events, attempts, owner);
  return attempts;
}

}  // namespace csgsim::story
