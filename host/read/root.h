// Modifiers that select the drawn statements.
// Used by read.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "host/read/syntax.h"

namespace csgsim::read {

/// Index, in file order, of the statement that `!` selects as the whole model: the first such statement that is not
/// under `*`. Throws InputError as visit_statements() does.
std::optional<std::uint32_t> find_root_statement(Source& source);

/// Passes on only the statements that are drawn: those of the file, or of the root's subtree, that are not under `%` or
/// `*`. Modifiers of the root itself are ignored.
class DrawnFilter : public StatementVisitor {
 public:
  DrawnFilter(StatementVisitor& visitor, std::optional<std::uint32_t> root) : visitor_(visitor), root_(root) {}

  void begin(const Statement& statement) override;
  void end() override;

  /// Whether the file has any statement, drawn or not.
  [[nodiscard]] bool has_statements() const { return count_ > 0; }

 private:
  StatementVisitor& visitor_;
  std::optional<std::uint32_t> root_;
  std::uint32_t count_ = 0;     ///< number of visited statements
  std::uint32_t depth_ = 0;     ///< number of open statements, from the root inwards
  std::uint32_t left_out_ = 0;  ///< number of open statements, from the outermost one with `%` or `*` inwards
};

}  // namespace csgsim::read
