#pragma once

#include <cstdint>
#include <optional>

#include "host/read/syntax.h"

namespace csgsim::read {

/// Number, in the order of the file, of the statement whose `!` makes it the whole model: the first one that is not
/// under a `*`. Throws InputError as visit_statements does.
std::optional<std::uint32_t> find_root(Source& source);

/// Passes on the statements of one subtree, and its root without modifiers.
class RootFilter : public StatementVisitor {
 public:
  RootFilter(StatementVisitor& visitor, std::uint32_t root) : visitor_(visitor), until_root_(root) {}

  void begin(const Statement& statement) override;
  void end() override;

 private:
  StatementVisitor& visitor_;
  std::uint32_t until_root_;  ///< statements that come before it
  std::uint32_t depth_ = 0;   ///< open statements from the root on
  bool is_past_ = false;
};

}  // namespace csgsim::read
