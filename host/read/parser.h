// Actions of the `.csg` grammar.
// Used by syntax.cpp.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/read/source.h"
#include "host/read/syntax.h"

namespace csgsim::read {

/// State of the grammar's actions: the current statement and the open braces. Each action receives the text that its
/// rule matched.
class Parser {
 public:
  Parser(Source& source, StatementVisitor& visitor) : source_(source), visitor_(visitor) {}

  void open_quote(std::string_view text) { quote_ = offset_of(text.data()); }
  void add_modifier(std::string_view text);
  void name_statement(std::string_view text);
  void name_argument(std::string_view text);
  void finish_argument(std::string_view text);
  void add_number(std::string_view text);
  void add_true(std::string_view text) { add_value(text, ValueKind::boolean, 1); }
  void add_false(std::string_view text) { add_value(text, ValueKind::boolean, 0); }
  void add_undefined(std::string_view text) { add_value(text, ValueKind::undefined); }
  void add_string(std::string_view text) { add_value(text, ValueKind::string, static_cast<double>(text.size() - 2)); }
  void open_vector(std::string_view text);
  void close_vector(std::string_view text);
  void finish_leaf(std::string_view text);
  void open_braces(std::string_view text);
  void close_braces(std::string_view text);
  void finish_file();

  [[nodiscard]] std::size_t offset_of(const char* position) const {
    return static_cast<std::size_t>(position - source_.text().data());
  }
  [[nodiscard]] std::string statement_name() const { return shown(statement_.name); }

  [[noreturn]] void fail_expecting(std::size_t offset, std::string_view expected);
  [[noreturn]] void fail_without_arguments(std::size_t offset);

  /// Throws InputError at the start of the last comment or string.
  [[noreturn]] void fail_in_quote(std::string_view message) { source_.fail(quote_, message); }

  template <typename... Parts>
  [[noreturn]] void fail(std::size_t offset, fmt::format_string<Parts...> message, Parts&&... parts) {
    source_.fail(offset, fmt::format(message, std::forward<Parts>(parts)...));
  }

 private:
  struct Open {
    std::string_view name;
    std::uint32_t offset;
  };

  void add_value(std::string_view text, ValueKind kind, double number = 0);
  /// What the text has at the offset, for messages: a character, a byte or the end of the file.
  [[nodiscard]] std::string description_at(std::size_t offset) const;
  void clear_statement();

  Source& source_;
  StatementVisitor& visitor_;
  Statement statement_;
  std::string_view argument_name_;
  std::uint32_t argument_value_ = 0;
  std::vector<std::uint32_t> vectors_;  ///< indices of the open vectors
  std::vector<Open> open_;              ///< statements whose braces are open
  std::uint32_t statements_ = 0;
  std::size_t quote_ = 0;  ///< start of the last comment or string
};

}  // namespace csgsim::read
