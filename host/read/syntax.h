#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/read/source.h"

namespace csgsim::read {

enum class ValueKind : std::uint8_t { number, boolean, string, undefined, vector };

/// A value of a statement. The values of a statement stand in one list in the order of the text, so the elements of a
/// vector follow it.
struct Value {
  double number = 0;         ///< of a number; of a boolean, 0 or 1; of a string, how many bytes are between its quotes
  std::uint32_t offset = 0;  ///< where it is in the text
  ValueKind kind = ValueKind::undefined;
  std::uint32_t extent = 1;  ///< how many values it takes up in the list, with itself
};

struct Argument {
  std::string_view name;     ///< empty if positional
  std::uint32_t offset = 0;  ///< where it is in the text
  std::uint32_t value = 0;   ///< index of its value
};

struct Modifiers {
  bool disable = false;     ///< `*`
  bool background = false;  ///< `%`
  bool root = false;        ///< `!`
};

/// A statement without its children.
struct Statement {
  Modifiers modifiers;
  std::string_view name;
  std::uint32_t offset = 0;  ///< where the name is in the text
  std::vector<Argument> arguments;
  std::vector<Value> values;
};

/// Told of each statement as it is read, so that the tree of statements need not be stored.
class StatementVisitor {
 public:
  virtual ~StatementVisitor() = default;
  virtual void begin(const Statement& statement) = 0;  ///< the statement is gone after the call
  virtual void end() = 0;                              ///< of the last begun statement that has not ended
};

/// Reads statements, at most `max_statements` in at most `max_depth` braces. Throws InputError where the text is not
/// that of a `.csg` file, or what the visitor throws.
void visit_statements(Source& source, StatementVisitor& visitor);

}  // namespace csgsim::read
