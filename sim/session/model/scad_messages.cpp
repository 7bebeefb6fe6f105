#include "sim/session/model/scad_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "hw/base/messages.h"
#include "hw/base/text.h"

namespace csgsim::session {

namespace {

/// A kind of message, and how many of them are printed.
struct MessageKind {
  std::string_view label;
  std::string_view several;
  std::size_t most;
};

constexpr MessageKind error_kind{"ERROR", "errors", 10};
constexpr auto message_kinds = std::to_array<MessageKind>({{"ECHO", "lines of echo()", 1000},
                                                           {"WARNING", "warnings", 10},
                                                           {"DEPRECATED", "warnings of deprecation", 10},
                                                           {"TRACE", "lines of the trace", 10},
                                                           error_kind});

/// A message: its first line, and further lines of a text with line ends.
struct ScadMessage {
  const MessageKind* kind = nullptr;
  std::string_view text;
};

const MessageKind* kind_of(std::string_view line) {
  const auto found = std::ranges::find_if(message_kinds, [&](const MessageKind& kind) {
    return line.starts_with(kind.label) && line.substr(kind.label.size()).starts_with(":");
  });
  return found == message_kinds.end() ? nullptr : &*found;
}

bool is_error(const ScadMessage& message) { return message.kind->label == error_kind.label; }

/// A message with a place: `BEFORE in file FILE, line N`, in older versions followed by `: AFTER`.
struct PlacedText {
  std::string_view before;
  std::string_view file;
  std::string_view line;
  std::string_view after;
};

std::optional<PlacedText> place_in(std::string_view text) {
  constexpr std::string_view before_file = " in file ";
  constexpr std::string_view before_line = ", line ";
  const std::size_t end = text.rfind(before_file);
  if (end == text.npos) return std::nullopt;
  const std::string_view rest = text.substr(end + before_file.size());
  const std::size_t comma = rest.find(before_line);
  if (comma == rest.npos) return std::nullopt;
  std::string_view after = rest.substr(comma + before_line.size());
  const std::string_view line = after.substr(0, after.find_first_not_of("0123456789"));
  after.remove_prefix(line.size());
  if (line.empty() || !(after.empty() || after.starts_with(": "))) return std::nullopt;
  return PlacedText{text.substr(0, end), rest.substr(0, comma), line, after};
}

bool has_place(std::string_view text) { return place_in(text).has_value(); }

/// Whether a line that begins no message continues the last one: an echo() or the text of an assert() may have several
/// lines.
bool continues(const ScadMessage& last, std::string_view line) {
  return last.kind->label == "ECHO" || (is_error(last) && !has_place(last.text) && has_place(line));
}

std::vector<ScadMessage> messages_in(std::string_view output) {
  std::vector<ScadMessage> messages;
  bool is_open = false;  // whether the last line belongs to the last message
  for (std::size_t at = 0; at < output.size();) {
    const std::size_t end = std::min(output.find('\n', at), output.size());
    const std::string_view line = output.substr(at, end - at);
    at = end + 1;
    if (const MessageKind* const kind = kind_of(line)) {
      messages.push_back({kind, line});
      is_open = true;
    } else if (is_open && !line.empty() && continues(messages.back(), line)) {
      std::string_view& text = messages.back().text;
      text = {text.data(), static_cast<std::size_t>(line.data() + line.size() - text.data())};
    } else {
      is_open = false;
    }
  }
  return messages;
}

std::optional<std::size_t> first_error(const std::vector<ScadMessage>& messages) {
  const auto found = std::ranges::find_if(messages, is_error);
  if (found == messages.end()) return std::nullopt;
  return static_cast<std::size_t>(found - messages.begin());
}

void print_lines(std::string_view text) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    report_line(fmt::format("openscad: {}", text.substr(at, end - at)));
    at = end + 1;
  }
}

/// OpenSCAD names files relative to the folder of the source.
std::string path_of(std::string_view named, const std::string& file) {
  if (named.size() > 1 && named.front() == '"') named = named.substr(1, named.size() - 2);
  const std::filesystem::path source(file);
  if (named == "<stdin>" || named.empty() || source.filename() == named) return file;
  return (source.parent_path() / named).lexically_normal().native();
}

}  // namespace

void print_scad_messages(std::string_view output, const std::string& file) {
  const std::vector<ScadMessage> messages = messages_in(output);
  const std::optional<std::size_t> thrown = first_error(messages);
  std::array<std::size_t, message_kinds.size()> counts{};
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (i == thrown) continue;
    std::size_t& count = counts[static_cast<std::size_t>(messages[i].kind - message_kinds.data())];
    if (++count <= messages[i].kind->most) print_lines(messages[i].text);
  }
  for (std::size_t i = 0; i < message_kinds.size(); ++i) {
    if (counts[i] <= message_kinds[i].most) continue;
    report_line(fmt::format("openscad: {} more {}; to see them all, run openscad -o model.csg {}",
                            grouped(counts[i] - message_kinds[i].most), message_kinds[i].several, shell_word(file)));
  }
}

std::string scad_error(std::string_view output, const std::string& file) {
  const std::vector<ScadMessage> messages = messages_in(output);
  const std::optional<std::size_t> thrown = first_error(messages);
  if (!thrown) return "";
  std::string_view text = messages[*thrown].text.substr(error_kind.label.size() + 1);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const std::optional<PlacedText> placed = place_in(text);
  if (!placed) return fmt::format("{}: {}", file, text);
  return fmt::format("{}:{}: {}{}", path_of(placed->file, file), placed->line, placed->before, placed->after);
}

}  // namespace csgsim::session
