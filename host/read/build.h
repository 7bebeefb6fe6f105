#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "host/model/tree.h"
#include "host/read/arguments.h"
#include "host/read/meetings.h"
#include "host/read/nodes.h"
#include "host/read/placement.h"
#include "host/read/read.h"
#include "host/read/restore.h"
#include "host/read/source.h"
#include "host/read/syntax.h"

namespace csgsim::read {

/// Makes the tree of the statements that it visits, without empty parts.
class TreeBuilder : public StatementVisitor {
 public:
  TreeBuilder(Source& source, const Options& options, Meetings meetings);

  void begin(const Statement& statement) override;
  void end() override { close_innermost(); }

  /// The tree, after the last statement has ended.
  model::Tree finish();

 private:
  /// A statement that has not ended; the first one stands for the file. A solid is a union of itself.
  struct OpenNode {
    model::Operator op = model::Operator::unite;
    bool takes_children = true;
    std::uint32_t dimensions = 0;  ///< which its operands have to be: said by its node, or the first that has any
    std::size_t operands = 0;      ///< empty ones too
    bool is_empty = false;         ///< whatever other operands it has
    bool is_nothing = false;       ///< of a Boolean of solids: empty, and without dimensions
    bool is_removed = false;       ///< of a matrix that is not finite: whatever it moves is nothing
    std::string_view name;
    std::uint32_t offset = 0;  ///< of the statement
    model::Location location;
    glm::dmat4 transform{1};  ///< from the space of its children to the model's, or to that of the node they make
    solids::MeshPlacement mesh_placement;  ///< of its children
    std::optional<Colour> colour;
    std::size_t first_child = 0;      ///< in children_, from here on its own
    std::size_t first_node = 0;       ///< in tree_.nodes
    std::size_t first_primitive = 0;  ///< in tree_.primitives
    std::vector<flat::Area> areas;    ///< unless solids are taken: one an operand, empty if that is no area
    Maker maker;                      ///< of a node that is made
    std::uint32_t made = 0;           ///< dimensions of what is made, or of a solid
    glm::dmat4 outer{1};              ///< of a node that is made: from its own space on
  };

  /// What a statement is for the one around it: its dimensions are 0 if it is nothing, as a group() of nothing is. What
  /// is empty may have some all the same, as square(0) has.
  struct Result {
    flat::Area area;
    std::uint32_t dimensions = 0;
    bool is_empty = true;
  };

  void charge_statement(const Statement& statement);
  [[nodiscard]] OpenNode make_open(const Statement& statement) const;
  [[nodiscard]] glm::dmat4 placement(const Arguments& arguments);
  void tell_restored() const;
  void add_solid(const NodeType& node, const Arguments& arguments);
  void add_leaf(const OpenNode& open, model::Shape shape, const glm::dmat4& transform);
  void make(OpenNode& open);
  void add_pieces(const OpenNode& open, std::vector<model::Polyhedron> pieces);
  [[nodiscard]] Operands take_operands(OpenNode& open);
  void drop_operands(const OpenNode& open);
  [[nodiscard]] flat::Area combined(OpenNode& open) const;
  [[nodiscard]] Result result_of(OpenNode& open) const;
  [[nodiscard]] std::uint32_t dimensions_of(const OpenNode& open) const;
  void close_innermost();
  void join_operands(const OpenNode& open, bool of_pieces);
  void hand_on(OpenNode& open, Result result);
  [[nodiscard]] bool goes_with(const OpenNode& open, const Result& result);
  static void count_operand(OpenNode& parent, const Result& result);

  Source& source_;
  Options options_;
  Meetings meetings_;
  RestoredCount restored_;
  model::Tree tree_;
  std::vector<OpenNode> open_;
  std::vector<std::uint32_t> children_;  ///< finished operands of the open frames
};

}  // namespace csgsim::read
