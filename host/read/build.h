// Construction of the CSG tree from statements.
// Used by read.cpp.
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

/// Builds the tree of the statements that it visits, without empty parts.
class TreeBuilder : public StatementVisitor {
 public:
  TreeBuilder(Source& source, const Options& options, Meetings meetings);

  void begin(const Statement& statement) override;
  void end() override { close_innermost(); }

  /// Returns the tree; called after the last statement has ended.
  model::Tree finish();

 private:
  /// A statement that has not ended; the first one represents the file. A solid is treated as a union with one operand.
  struct OpenNode {
    model::Operator op = model::Operator::unite;
    bool takes_children = true;
    /// Dimensions required of its operands; set by its node, or by its first operand that has dimensions.
    std::uint32_t dimensions = 0;
    std::size_t operands = 0;  ///< number of operands, including empty ones
    bool is_empty = false;     ///< whether the result is empty regardless of the other operands
    bool is_nothing = false;   ///< whether the result is a Boolean of solids that is empty and has no dimensions
    bool is_removed = false;   ///< whether everything inside is removed, because a matrix is not finite
    std::string_view name;
    std::uint32_t offset = 0;  ///< position of the statement in the text
    model::Location location;
    glm::dmat4 transform{1};  ///< maps its children's space to that of the model, or of the enclosing made node
    solids::MeshPlacement mesh_placement;  ///< placement of its children's meshes
    std::optional<Colour> colour;
    std::size_t first_child = 0;      ///< index into children_ of its first child
    std::size_t first_node = 0;       ///< index into tree_.nodes
    std::size_t first_primitive = 0;  ///< index into tree_.primitives
    /// One per operand, unless the node takes solids; empty for an operand without an area.
    std::vector<flat::Area> areas;
    Maker maker;             ///< makes the node from its children
    std::uint32_t made = 0;  ///< dimensions of the made result or of a solid
    glm::dmat4 outer{1};     ///< maps a made node's own space to the enclosing space
  };

  /// The result of a statement for the enclosing statement. Its dimensions are 0 if there is no result, as for a
  /// group() without children. An empty result may have dimensions, as for square(0).
  struct Result {
    flat::Area area;
    std::uint32_t dimensions = 0;
    bool is_empty = true;
  };

  void charge_statement(const Statement& statement);
  [[nodiscard]] OpenNode make_open_node(const Statement& statement) const;
  [[nodiscard]] glm::dmat4 placement(const Arguments& arguments);
  void report_restored() const;
  void add_solid(const NodeType& node, const Arguments& arguments);
  void add_leaf(const OpenNode& open, model::Shape shape, const glm::dmat4& transform);
  void make_node(OpenNode& open);
  void add_pieces(const OpenNode& open, std::vector<model::Polyhedron> pieces);
  [[nodiscard]] Operands take_operands(OpenNode& open);
  void drop_operands(const OpenNode& open);
  [[nodiscard]] flat::Area combine_areas(OpenNode& open) const;
  [[nodiscard]] Result make_result(OpenNode& open) const;
  [[nodiscard]] std::uint32_t result_dimensions(const OpenNode& open) const;
  void close_innermost();
  void join_operands(const OpenNode& open, bool of_pieces);
  void add_to_enclosing(OpenNode& open, Result result);
  [[nodiscard]] bool accepts(const OpenNode& open, const Result& result);
  static void count_operand(OpenNode& parent, const Result& result);

  Source& source_;
  Options options_;
  Meetings meetings_;
  RestoredCount restored_;
  model::Tree tree_;
  std::vector<OpenNode> open_;
  std::vector<std::uint32_t> children_;  ///< finished operands of the open statements
};

}  // namespace csgsim::read
