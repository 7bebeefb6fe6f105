#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "host/read/syntax.h"

namespace csgsim::read {

/// Where solids meet: in statements that have two children or more with a shape, or at the top of the file if it has.
struct Meetings {
  std::unordered_set<std::uint32_t> statements;  ///< by where their names are in the text
  bool on_top = false;
};

/// Finds them.
class MeetingFinder : public StatementVisitor {
 public:
  void begin(const Statement& statement) override;
  void end() override;

  /// After the last statement has ended.
  [[nodiscard]] const Meetings& meetings() const { return meetings_; }

 private:
  struct Open {
    std::uint32_t offset = 0;
    bool is_shape = false;     ///< by itself
    std::uint32_t shapes = 0;  ///< children that have a shape
  };

  std::vector<Open> open_;
  std::uint32_t on_top_ = 0;
  Meetings meetings_;
};

}  // namespace csgsim::read
