// Reads the items of a line of commands, with positions in errors. Used by the interpreter, expressions and shapes.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/commands/lines.h"

namespace csgsim::commands {

/// A cursor over the items of a line.
class Cursor {
 public:
  Cursor(read::Source& source, std::span<const Item> line) : source_(source), line_(line) {}

  [[nodiscard]] bool at_end() const { return at_ == line_.size(); }
  [[nodiscard]] bool is(std::string_view text) const { return !at_end() && line_[at_].is(text); }
  [[nodiscard]] bool is(Kind kind) const { return !at_end() && line_[at_].kind == kind; }
  [[nodiscard]] const Item& peek() const { return line_[at_]; }
  const Item& take() { return line_[at_++]; }
  /// If the next item is `text`, consumes it and returns true.
  bool take_if(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }

  /// Consumes the next item, which must be of the given kind; `description` names it in messages.
  const Item& word(std::string_view description) { return expected(Kind::word, description); }
  double number(std::string_view description) { return expected(Kind::number, description).number; }
  /// Consumes a number, which must be above 0.
  double take_positive_number(std::string_view description) {
    const Item& item = expected(Kind::number, description);
    if (!(item.number > 0)) fail(item.offset, fmt::format("{} must be above 0", description));
    return item.number;
  }
  /// Consumes the bracket or sign `text`. Fails with "expected `text` CONTEXT" if the next item is another.
  void expect_symbol(std::string_view text, std::string_view context) {
    if (!take_if(text)) fail_here(fmt::format("expected `{}` {}", text, context));
  }
  /// Consumes all numbers before the next item of another kind.
  std::vector<double> numbers() {
    std::vector<double> values;
    while (is(Kind::number)) values.push_back(take().number);
    return values;
  }
  /// Fails unless all items have been consumed.
  void end() {
    if (!at_end()) fail_here("expected the end of the line");
  }

  /// The offset of the next item, or of the end of the line.
  [[nodiscard]] std::uint32_t offset() const {
    return at_end() ? line_.back().offset + static_cast<std::uint32_t>(line_.back().text.size()) : line_[at_].offset;
  }
  [[noreturn]] void fail(std::uint32_t offset, std::string_view message) const { source_.fail(offset, message); }
  [[noreturn]] void fail_here(std::string_view message) const {
    fail(offset(), fmt::format("{}, found {}", message,
                               at_end() ? "the end of the line" : fmt::format("`{}`", read::shown(line_[at_].text))));
  }

 private:
  const Item& expected(Kind kind, std::string_view description) {
    if (!is(kind)) fail_here(fmt::format("expected {}", description));
    return take();
  }

  read::Source& source_;
  std::span<const Item> line_;
  std::size_t at_ = 0;
};

}  // namespace csgsim::commands
