// Statements of `.csg` files, and their visitor.
// Used throughout host/read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/read/source.h"

namespace csgsim::read {

enum class ValueKind : std::uint8_t { number, boolean, string, undefined, vector };

/// A value of a statement. A statement's values form one list in text order, so the elements of a vector follow it.
struct Value {
  double number = 0;         ///< a number; for a boolean, 0 or 1; for a string, its length in bytes without quotes
  std::uint32_t offset = 0;  ///< position in the text
  ValueKind kind = ValueKind::undefined;
  std::uint32_t extent = 1;  ///< number of list entries that the value occupies, including itself
};

struct Argument {
  std::string_view name;     ///< empty if positional
  std::uint32_t offset = 0;  ///< position in the text
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
  std::uint32_t offset = 0;  ///< position of the name in the text
  std::vector<Argument> arguments;
  std::vector<Value> values;
};

/// Receives each statement as it is read, so that the tree of statements need not be stored.
class StatementVisitor {
 public:
  virtual ~StatementVisitor() = default;
  virtual void begin(const Statement& statement) = 0;  ///< `statement` is valid only during the call
  virtual void end() = 0;                              ///< ends the innermost open statement
};

/// Reads statements, at most `max_statements`, nested at most `max_depth` braces deep. Throws InputError if the text is
/// not a valid `.csg` file. Exceptions of the visitor are passed on.
void visit_statements(Source& source, StatementVisitor& visitor);

}  // namespace csgsim::read
