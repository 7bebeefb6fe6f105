#pragma once

#include <cstdint>
#include <optional>

#include "host/read/syntax.h"

namespace csgsim::read {

/// Number, in the order of the file, of the statement whose `!` makes it the whole model: the first one that is not
/// under a `*`. Throws InputError as visit_statements does.
std::optional<std::uint32_t> find_root(Source& source);

/// Passes on the statements that are drawn: of the file, or of the subtree of its root, those that are under no `%` or
/// `*`; of the root itself modifiers do not count.
class DrawnFilter : public StatementVisitor {
 public:
  DrawnFilter(StatementVisitor& visitor, std::optional<std::uint32_t> root) : visitor_(visitor), root_(root) {}

  void begin(const Statement& statement) override;
  void end() override;

  /// Whether there was any statement, drawn or not.
  [[nodiscard]] bool has_statements() const { return count_ > 0; }

 private:
  StatementVisitor& visitor_;
  std::optional<std::uint32_t> root_;
  std::uint32_t count_ = 0;     ///< statements so far
  std::uint32_t depth_ = 0;     ///< open statements from the root on
  std::uint32_t left_out_ = 0;  ///< open statements from a `%` or `*` on
};

}  // namespace csgsim::read
