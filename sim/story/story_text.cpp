#include "sim/story/story_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "sim/observe/frame.h"
#include "sim/story/why_not.h"

namespace csgsim::story {

namespace {

constexpr std::size_t max_names_beside = 6;  ///< limit for names of surfaces beside the pixel

/// The line of the model's file in a name like cylinder@9:9; empty for other names.
std::string line_text(const isa::Program& program, std::uint32_t piece) {
  const std::uint32_t primitive = isa::primitive_of(*program.facts, piece);
  if (primitive >= program.facts->primitives.size()) return "";
  const std::string& name = program.facts->primitives[primitive];
  const std::size_t at = name.find('@');
  const std::size_t colon = name.find(':', at == std::string::npos ? 0 : at);
  if (at == std::string::npos || colon == std::string::npos || program.facts->model.file.empty()) return "";
  return fmt::format(", line {} of {}", printable(name.substr(at + 1, colon - at - 1)),
                     printable(program.facts->model.file));
}

std::string clocks_text(const Event& event) {
  return event.clocks.empty() ? "-" : fmt::format("{}..{}", event.clocks.begin, event.clocks.end - 1);
}

std::string numbers_text(const Event& event) {
  return event.first == event.last ? fmt::format("i{}", event.first) : fmt::format("i{}..i{}", event.first, event.last);
}

constexpr std::size_t title_width = 12;

/// Indents all lines but the first.
std::string indented(std::string_view text, std::size_t indent) {
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out.append(indent, ' ');
  }
  return out;
}

/// Titles of events, indexed by EventKind.
constexpr std::array<std::string_view, 10> titles{"setup", "surface", "depth test", "classify", "bits",
                                                  "merge", "shade",   "effect",     "skipped",  "store"};

class Writer {
 public:
  Writer(const Subject& subject, const Story& story) : subject_(subject), program_(subject.program), story_(story) {}

  std::vector<TextPart> write() {
    write_head();
    write_story();
    return std::move(parts_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    if (parts_.empty() || parts_.back().end > 0) begin_part();
    parts_.back().text += fmt::format(format, std::forward<Args>(args)...) + "\n";
  }

  void begin_part() { parts_.emplace_back(); }

  [[nodiscard]] std::string plane_lines(const Decision& decision) const {
    const std::string halfspace = geometry_text(subject_, decision);
    return halfspace.empty() ? "" : fmt::format("\n{:<12}{}", "", indented(halfspace, 12));
  }

  /// The visible opaque surface behind the nearest one.
  [[nodiscard]] std::string through_text() const {
    const std::optional<double> distance = distance_of(program_, story_.opaque_depth);
    const std::string name = primitive_text(program_, story_.opaque_owner);
    return distance ? fmt::format("{}, at {} steps, {:.6g} model units", name, story_.opaque_depth, *distance) : name;
  }

  void write_head() {
    const std::uint32_t owner = story_.owner;
    line("pixel {},{} shows {}{}", story_.x, story_.y, primitive_text(program_, owner), line_text(program_, owner));
    if (const std::optional<double> distance = distance_of(program_, story_.depth))
      line("  depth     {} steps, {:.6g} model units from the eye along the view axis", story_.depth, *distance);
    if (is_seen_through(story_)) line("  through   {}", through_text());
    line("  colour    {}", colour_text(program_, story_.colour));
    const auto seen = std::find_if(story_.attempts.rbegin(), story_.attempts.rend(),
                                   [](const Attempt& one) { return one.fate == Fate::seen; });
    if (owner == observe::no_owner || seen == story_.attempts.rend()) return;
    const Event& surface = story_.events[seen->first_event];
    if (surface.decision)
      line("  surface   {}{}", decision_text(program_, *surface.decision), plane_lines(*surface.decision));
    const Event& merge = story_.events[seen->deciding_event];
    const std::string clocks = merge.clocks.empty() ? "" : fmt::format(", clocks {}", clocks_text(merge));
    line("  merged    i{}{}, over {}", merge.first, clocks, primitive_text(program_, merge.owner_before));
  }

  [[nodiscard]] std::string changes_text(const Event& event) const {
    std::string text;
    for (const Change& change : event.changes) {
      if (!text.empty()) text += "; ";
      text += field_name(program_, change.field) + " ";
      if (change.differs()) text += value_text(program_, change.field, change.before) + " -> ";
      text += value_text(program_, change.field, change.after);
    }
    return text;
  }

  /// The deciding instruction and its geometry, on separate lines.
  [[nodiscard]] std::string decided(std::string_view how, const Decision& decision) const {
    const std::string halfspace = geometry_text(subject_, decision);
    return fmt::format("\n{} {}", how, decision_text(program_, decision)) + (halfspace.empty() ? "" : "\n" + halfspace);
  }

  [[nodiscard]] std::string surface_text(const Event& event) const {
    std::string text = primitive_text(program_, event.origin.primitive) + ": " + changes_text(event);
    if (event.decision) text += decided("by", *event.decision);
    if (!event.enabled_after && event.cut) text += decided("cut out by", *event.cut);
    return text;
  }

  [[nodiscard]] std::string depth_test_text(const Event& event) const {
    if (!event.enabled_after && event.cut && (!event.decision || event.cut->number != event.decision->number))
      return "not admitted" + decided("by", *event.cut);
    if (!event.decision) return changes_text(event);
    const std::string owner =
        event.owner_before == observe::no_owner ? "" : " of " + primitive_text(program_, event.owner_before);
    return fmt::format("Z1 {} {} Z2 {}{}",
                       depth_text(program_, static_cast<std::uint32_t>(event.decision->first_operand)),
                       event.enabled_after ? "is nearer than" : "is not nearer than",
                       depth_text(program_, static_cast<std::uint32_t>(event.decision->second_operand)), owner);
  }

  [[nodiscard]] std::string misfit_text(const Event& event) const {
    return event.misfit ? decided("A*x + B*y + C does not fit the width of", *event.misfit) : "";
  }

  [[nodiscard]] std::string text_of_event(const Event& event) const {
    switch (event.kind) {
      case EventKind::surface: return surface_text(event);
      case EventKind::stored: return primitive_text(program_, event.origin.primitive) + ": " + changes_text(event);
      case EventKind::depth_test: return depth_test_text(event);
      case EventKind::comparison:
        return fmt::format("against {}: {}", primitive_text(program_, event.origin.node),
                           event.cut ? "out" + decided("by", *event.cut) : "in");
      case EventKind::merge:
        return fmt::format("{}; owner {}, was {}", changes_text(event), primitive_text(program_, event.owner_after),
                           primitive_text(program_, event.owner_before));
      case EventKind::shade: return changes_text(event) + (event.decision ? decided("where", *event.decision) : "");
      case EventKind::skip:
        return fmt::format("no pixel was enabled at i{}, for {}", event.decision->number,
                           primitive_text(program_, event.origin.primitive));
      case EventKind::setup:
      case EventKind::bits:
      case EventKind::effect: return changes_text(event);
    }
    return "";
  }

  [[nodiscard]] std::string effect_text(const Event& event) const {
    const std::vector<std::string>& effects = program_.facts->compile.effects;
    if (event.origin.effect == isa::no_effect || event.origin.effect >= effects.size()) return "";
    return fmt::format("[{}] ", printable(effects[event.origin.effect]));
  }

  /// Whether the primitive whose depths are stored is at the pixel; for an absent primitive the last event initializes
  /// the depths.
  static bool is_here(const Event& stored) { return !stored.enabled_after; }

  /// Marks the events that get a line: no surfaces beside the pixel, no skipped instructions.
  [[nodiscard]] std::vector<bool> reported() const {
    std::vector<bool> reported;
    for (const Event& event : story_.events)
      reported.push_back(event.kind != EventKind::skip && (event.kind != EventKind::stored || is_here(event)));
    for (const Attempt& attempt : story_.attempts) {
      for (std::size_t i = attempt.first_event; i <= attempt.last_event; ++i)
        reported[i] = attempt.fate != Fate::outside;
    }
    return reported;
  }

  /// The fate of an attempt in a few words.
  [[nodiscard]] std::string verdict(const Attempt& attempt) const {
    const Event& deciding = story_.events[attempt.deciding_event];
    switch (attempt.fate) {
      case Fate::outside: return "beside this pixel";
      case Fate::no_depth: return "no part of it remains here";
      case Fate::refused: return "not admitted";
      case Fate::behind: return "behind " + primitive_text(program_, deciding.owner_before);
      case Fate::classified: {
        if (!attempt.deciding_comparison) return fmt::format("classified out, at i{}", deciding.last);
        const Event& comparison = story_.events[*attempt.deciding_comparison];
        return fmt::format("classified out: it is {} {}", comparison.cut ? "outside" : "in",
                           primitive_text(program_, comparison.origin.node));
      }
      case Fate::covered:
        return deciding.kind == EventKind::setup ? fmt::format("the picture restarts at i{}", deciding.first)
                                                 : fmt::format("merged; covered at i{}", deciding.first);
      case Fate::blended: return "merged; contributes to the colour";
      case Fate::seen: return "merged; this is the visible surface";
    }
    return "";
  }

  /// Adds the verdict after the last event of an attempt.
  void write_verdict(std::size_t event, std::size_t indent) {
    for (const Attempt& attempt : story_.attempts) {
      if (attempt.last_event != event) continue;
      const std::string as =
          attempt.shown == attempt.primitive ? "" : ", drawn with " + primitive_text(program_, attempt.primitive);
      line("{:{}}=> {}{}: {}", "", indent, primitive_text(program_, attempt.shown), as, verdict(attempt));
    }
  }

  void write_beside() {
    std::vector<std::uint32_t> beside;
    for (const Attempt& attempt : story_.attempts) {
      const bool is_known = std::find(beside.begin(), beside.end(), attempt.primitive) != beside.end();
      if (attempt.fate == Fate::outside && !is_known) beside.push_back(attempt.primitive);
    }
    if (beside.empty()) return;
    std::string names;
    for (std::size_t i = 0; i < std::min(beside.size(), max_names_beside); ++i)
      names += (i == 0 ? "" : ", ") + primitive_text(program_, beside[i]);
    if (beside.size() > max_names_beside) names += fmt::format(" and {} more", beside.size() - max_names_beside);
    line("  beside this pixel: {}", names);
  }

  void write_story() {
    begin_part();
    for (const StorySegment& part : story_.segments) write_segment(part);
    if (story_.segments.empty()) line("\nno segment holds this pixel: it shows the background");
    write_beside();
  }

  void write_segment(const StorySegment& part) {
    if (part.first == part.end) {
      line("\nsegment {} has no instructions: it shows the background", part.segment);
      return;
    }
    line("\nsegment {}, i{}..i{}", part.segment, part.first, part.end - 1);
    const std::vector<bool> is_reported = reported();
    std::size_t numbers = 0;
    std::size_t clocks = 0;
    for (std::size_t i = 0; i < story_.events.size(); ++i) {
      if (!is_reported[i] || story_.events[i].segment != part.segment) continue;
      numbers = std::max(numbers, numbers_text(story_.events[i]).size());
      clocks = std::max(clocks, clocks_text(story_.events[i]).size());
    }
    if (clocks > 1) line("  {:{}}  clocks", "", numbers);
    for (std::size_t i = 0; i < story_.events.size(); ++i) {
      if (!is_reported[i] || story_.events[i].segment != part.segment) continue;
      const Event& event = story_.events[i];
      begin_part();
      line("  {:<{}}  {:<{}}  {:<{}}{}{}", numbers_text(event), numbers, clocks_text(event), clocks,
           titles.at(static_cast<std::size_t>(event.kind)), title_width, effect_text(event),
           indented(text_of_event(event) + misfit_text(event), numbers + clocks + title_width + 6));
      parts_.back().end = event.last + 1;
      write_verdict(i, numbers + clocks + 6);
    }
  }

  const Subject& subject_;
  const isa::Program& program_;
  const Story& story_;
  std::vector<TextPart> parts_;
};

}  // namespace

std::vector<TextPart> parts_of(const Subject& subject, const Story& story) { return Writer(subject, story).write(); }

std::string text_of(const Subject& subject, const Story& story) {
  std::string text;
  for (const TextPart& part : parts_of(subject, story)) text += part.text;
  return text;
}

}  // namespace csgsim::story
