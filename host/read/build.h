#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "host/model/tree.h"
#include "host/read/arguments.h"
#include "host/read/nodes.h"
#include "host/read/placement.h"
#include "host/read/source.h"
#include "host/read/syntax.h"

namespace csgsim::read {

/// Makes the tree of the statements it is told of, without empty parts. Statements under `%` and `*` are passed over.
class TreeBuilder : public StatementVisitor {
 public:
  explicit TreeBuilder(Source& source);

  void begin(const Statement& statement) override;
  void end() override;

  /// The tree, after the last statement has ended. Throws InputError if there was none.
  model::Tree finish();

 private:
  /// A statement that has not ended; the first one stands for the file. A solid is a union of itself.
  struct OpenNode {
    model::Operator op = model::Operator::unite;
    bool is_solid = false;
    bool is_empty = false;      ///< whatever other operands it has
    bool has_operands = false;  ///< empty ones too
    std::string_view name;
    glm::dmat4 transform{1};
    std::optional<Colour> colour;
    std::size_t first_child = 0;      ///< in children_, from here on its own
    std::size_t first_node = 0;       ///< in tree_.nodes
    std::size_t first_primitive = 0;  ///< in tree_.primitives
  };

  [[nodiscard]] OpenNode make_open(std::string_view name) const;
  void add_solid(const NodeType& node, const Statement& statement, const Arguments& arguments);
  void close_innermost();

  Source& source_;
  model::Tree tree_;
  std::vector<OpenNode> open_;
  std::vector<std::uint32_t> children_;  ///< finished operands of the open frames
  std::size_t left_out_ = 0;             ///< open statements from a `%` or `*` on
  bool has_statements_ = false;
};

}  // namespace csgsim::read
