// Statements that combine several solids. Used by build.h and read.cpp.
#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "host/read/syntax.h"

namespace csgsim::read {

/// The places where solids are combined with other solids: statements with at least two children that have a shape, and
/// possibly the top level of the file.
struct Meetings {
  std::unordered_set<std::uint32_t> statements;  ///< offsets of their names in the text
  bool at_top_level = false;
};

/// Finds the statements that combine solids.
class MeetingFinder : public StatementVisitor {
 public:
  void begin(const Statement& statement) override;
  void end() override;

  /// Valid after the last statement has ended.
  [[nodiscard]] const Meetings& meetings() const { return meetings_; }

 private:
  struct Open {
    std::uint32_t offset = 0;
    bool is_shape = false;     ///< whether it has a shape even without its children
    std::uint32_t shapes = 0;  ///< number of children with a shape
  };

  std::vector<Open> open_;
  std::uint32_t top_shapes_ = 0;
  Meetings meetings_;
};

}  // namespace csgsim::read
