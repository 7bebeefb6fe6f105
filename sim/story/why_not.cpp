#include "sim/story/why_not.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "sim/observe/frame.h"

namespace csgsim::story {

namespace {

/// The first instruction of the story's segments that satisfies the predicate; null if there is none.
template <class Holds>
const isa::Instruction* find_instruction(const Subject& subject, const Story& story, Holds holds) {
  for (const StorySegment& part : story.segments) {
    const std::vector<isa::Instruction>& instructions = subject.program.segments[part.segment].instructions;
    const auto found = std::find_if(instructions.begin(), instructions.end(), holds);
    if (found != instructions.end()) return &*found;
  }
  return nullptr;
}

bool is_drawn(const Subject& subject, const Story& story, std::uint32_t primitive) {
  return find_instruction(subject, story, [primitive](const isa::Instruction& one) {
           return one.origin.purpose == isa::Purpose::render && one.origin.primitive == primitive;
         }) != nullptr;
}

/// The primitive that is rendered for this one: itself, the first of its convex set, or the one that an instruction
/// shading its facets names.
std::uint32_t drawn_as(const Subject& subject, const Story& story, std::uint32_t primitive) {
  if (is_drawn(subject, story, primitive)) return primitive;
  if (subject.model != nullptr && is_drawn(subject, story, subject.model->set_of(primitive).front()))
    return subject.model->set_of(primitive).front();
  const isa::Instruction* const shading = find_instruction(subject, story, [primitive](const isa::Instruction& one) {
    return one.origin.purpose == isa::Purpose::shade && one.origin.primitive == primitive &&
           one.origin.node != isa::no_node;
  });
  return shading != nullptr ? shading->origin.node : primitive;
}

std::string with_halfspace(const Subject& subject, const Decision& decision) {
  const std::string halfspace = geometry_text(subject, decision);
  const std::string text = decision_text(subject.program, decision);
  return halfspace.empty() ? text : text + "; " + halfspace;
}

std::string behind_text(const Subject& subject, const Event& test) {
  const isa::Program& program = subject.program;
  return fmt::format("behind {}: i{}, Z1 {} is not less than Z2 {}", primitive_text(program, test.owner_before),
                     test.decision->number,
                     depth_text(program, static_cast<std::uint32_t>(test.decision->first_operand)),
                     depth_text(program, static_cast<std::uint32_t>(test.decision->second_operand)));
}

std::string comparison_text(const Subject& subject, const Event& comparison) {
  const std::string other = primitive_text(subject.program, comparison.origin.node);
  if (!comparison.cut) return fmt::format("in {} (i{}..i{})", other, comparison.first, comparison.last);
  return fmt::format("outside {} by {}", other, with_halfspace(subject, *comparison.cut));
}

std::string classified_text(const Subject& subject, const Story& story, const Attempt& attempt) {
  if (attempt.deciding_comparison)
    return "classified out: it is " + comparison_text(subject, story.events[*attempt.deciding_comparison]);
  std::string text = fmt::format("classified out at i{}: it is ", story.events[attempt.deciding_event].last);
  bool is_first = true;
  for (std::size_t i = attempt.first_event; i <= attempt.deciding_event; ++i) {
    if (story.events[i].kind != EventKind::comparison) continue;
    text += (is_first ? "" : ", ") + comparison_text(subject, story.events[i]);
    is_first = false;
  }
  return is_first ? fmt::format("classified out at i{}", story.events[attempt.deciding_event].last) : text;
}

std::string covered_text(const Subject& subject, const Event& by) {
  if (by.kind == EventKind::setup) return fmt::format("merged, but the picture restarted at i{}", by.first);
  return fmt::format("merged, but {} was merged over it at i{}", primitive_text(subject.program, by.origin.primitive),
                     by.first);
}

/// Names the primitive, rather than a piece of it.
std::string name_text(const Subject& subject, const WhyNot& answer) {
  const isa::Facts& facts = *subject.program.facts;
  const std::uint32_t primitive = isa::primitive_of(facts, answer.pieces.first);
  if (answer.pieces.count == 1) return primitive_text(subject.program, answer.pieces.first);
  return fmt::format("p{} {}", primitive, printable(facts.primitives[primitive]));
}

view::PixelRect rectangle_of(const HalfspaceFinder& model, const isa::PieceRange& pieces) {
  view::PixelRect all;
  for (std::uint32_t i = 0; i < pieces.count; ++i) all = view::hull(all, model.rectangle_of(pieces.first + i));
  return all;
}

std::string nowhere_text(const Subject& subject, const Story& story, const WhyNot& answer) {
  const std::string name = name_text(subject, answer);
  if (answer.is_broadcast)
    return fmt::format("the instructions that draw {} find this pixel disabled, or are skipped", name);
  if (subject.model != nullptr) {
    const view::PixelRect pixels = rectangle_of(*subject.model, answer.pieces);
    const auto x = static_cast<std::int32_t>(story.x);
    const auto y = static_cast<std::int32_t>(story.y);
    if (pixels.empty()) return name + " is nowhere in the picture";
    if (x < pixels.x0 || x > pixels.x1 || y < pixels.y0 || y > pixels.y1) {
      return fmt::format("{} is beside this pixel: it is within columns {} to {} and rows {} to {}", name, pixels.x0,
                         pixels.x1, pixels.y0, pixels.y1);
    }
  }
  return fmt::format(
      "no instruction of {} draws {}: it is beside the segment's pixels, or pruning found that it is not visible there "
      "(csgsim render --pruning none draws it)",
      story.segments.empty() ? "any segment" : fmt::format("segment {}", story.segments.back().segment), name);
}

}  // namespace

WhyNot why_not(const Subject& subject, const Story& story, std::uint32_t primitive) {
  const isa::Facts& facts = *subject.program.facts;
  WhyNot answer;
  answer.pieces = isa::pieces_of(facts, primitive);
  std::vector<std::uint32_t> drawn;
  for (std::uint32_t i = 0; i < answer.pieces.count; ++i)
    drawn.push_back(drawn_as(subject, story, answer.pieces.first + i));
  answer.drawn_as = drawn.front();
  answer.is_seen = story.owner != observe::no_owner && isa::primitive_of(facts, story.owner) == primitive;
  answer.is_broadcast =
      std::any_of(drawn.begin(), drawn.end(), [&](auto one) { return is_drawn(subject, story, one); });
  for (std::size_t i = 0; i < story.attempts.size(); ++i)
    if (std::find(drawn.begin(), drawn.end(), story.attempts[i].primitive) != drawn.end()) answer.attempts.push_back(i);
  return answer;
}

std::string fate_text(const Subject& subject, const Story& story, const Attempt& attempt) {
  const Event& event = story.events[attempt.deciding_event];
  const auto cut = [&] { return event.cut ? with_halfspace(subject, *event.cut) : std::string("not enabled"); };
  switch (attempt.fate) {
    case Fate::outside: return "the pixel is outside its outline: " + cut();
    case Fate::no_depth: return "no part of it remains here: " + cut();
    case Fate::refused: return "not admitted by " + cut();
    case Fate::behind: return behind_text(subject, event);
    case Fate::classified: return classified_text(subject, story, attempt);
    case Fate::covered: return covered_text(subject, event);
    case Fate::blended:
      return fmt::format("merged at i{}; contributes to the colour, but is not the nearest", event.first);
    case Fate::seen: return fmt::format("merged at i{}", event.first);
  }
  return "";
}

std::string text_of(const Subject& subject, const Story& story, const WhyNot& answer) {
  const std::string name = name_text(subject, answer);
  const bool is_whole = answer.pieces.count == 1;
  std::string text = fmt::format("why not {}\n", name);
  if (answer.is_seen) text += fmt::format("  the pixel shows {}\n", name);
  if (is_whole && answer.drawn_as != answer.pieces.first)
    text += fmt::format("  drawn with {}, as one convex solid\n", primitive_text(subject.program, answer.drawn_as));
  if (answer.attempts.empty()) text += fmt::format("  {}\n", nowhere_text(subject, story, answer));
  for (const std::size_t i : answer.attempts) {
    const Attempt& attempt = story.attempts[i];
    if (!is_whole) text += "  " + isa::piece_label(*subject.program.facts, attempt.primitive) + ":";
    text += (is_whole ? "  " : " ") + fate_text(subject, story, attempt);
    if (attempt.fate == Fate::seen && !answer.is_seen)
      text += "; the facet visible here belongs to " + primitive_text(subject.program, story.owner);
    text += "\n";
  }
  return text;
}

}  // namespace csgsim::story
