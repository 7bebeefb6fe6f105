#include "host/swept/quadtree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <glm/common.hpp>
#include <map>
#include <utility>
#include <vector>

namespace csgsim::swept {

namespace {

inline constexpr std::uint32_t no_node = 0xffffffffU;

enum Direction : std::uint8_t { to_south, to_east, to_north, to_west };

struct TreeNode {
  Element element;
  std::uint32_t parent = no_node;
  std::uint32_t part = 0;  ///< index among its parent's parts
  std::array<std::uint32_t, 4> children{no_node, no_node, no_node, no_node};
  std::array<std::uint32_t, 4> corners{no_node, no_node, no_node, no_node};  ///< vertices of a leaf

  [[nodiscard]] bool is_leaf() const { return children[0] == no_node; }
};

/// A vertex. If it lies on the side of a larger element, `from` and `to` are the corners of that side.
struct TreeVertex {
  glm::dvec3 point{0};
  std::uint32_t number = 0;
  bool is_known = false;  ///< vertex of a wire frame
  bool is_placed = false;
  std::uint32_t from = no_node;  ///< vertices; no_node if it is on the surface
  std::uint32_t to = no_node;
  double part = 0;
};

/// The bits of a part's index: 1 is east, 2 is north.
bool lies_at(std::uint32_t part, Direction side) {
  switch (side) {
    case to_south: return (part & 2U) == 0;
    case to_north: return (part & 2U) != 0;
    case to_west: return (part & 1U) == 0;
    case to_east: return (part & 1U) != 0;
  }
  return false;
}

std::uint32_t mirrored(std::uint32_t part, Direction side) {
  return side == to_south || side == to_north ? part ^ 2U : part ^ 1U;
}

Direction opposite(Direction side) { return static_cast<Direction>((side + 2U) % 4U); }

/// The corners at which a side starts and ends, in the order of positions.
std::pair<Corner, Corner> side_ends(Direction side) {
  switch (side) {
    case to_south: return {sw, se};
    case to_north: return {nw, ne};
    case to_west: return {sw, nw};
    case to_east: return {se, ne};
  }
  return {sw, sw};
}

class Quadtree {
 public:
  Quadtree(const PatchEdges* frame, Output& output, RepairCounts& counts)
      : frame_(frame), output_(output), counts_(counts) {}

  void read(Stream& stream) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open;  // node, number of children read
    while (const std::optional<Node> node = stream.next()) {
      const auto number = static_cast<std::uint32_t>(nodes_.size());
      TreeNode& one = nodes_.emplace_back();
      one.element = node->element;
      if (!open.empty()) {
        one.parent = open.back().first;
        one.part = open.back().second++;
        nodes_[one.parent].children[one.part] = number;
      }
      if (node->is_leaf) {
        leaves_.push_back(number);
      } else {
        open.emplace_back(number, 0);
      }
      while (!open.empty() && open.back().second == 4) open.pop_back();
    }
  }

  void repair() {
    for (const std::uint32_t leaf : leaves_) {
      for (const Corner corner : {sw, se, nw, ne}) find_vertex(leaf, corner);
    }
    for (const std::uint32_t leaf : leaves_) {
      for (const Direction side : {to_south, to_east, to_north, to_west}) snap_to_side(leaf, side);
    }
    for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex) place(vertex);
    for (const std::uint32_t leaf : leaves_) emit(leaf);
    counts_.elements += leaves_.size();
    counts_.most_elements = std::max<std::uint64_t>(counts_.most_elements, leaves_.size());
    counts_.most_vertices = std::max<std::uint64_t>(counts_.most_vertices, vertices_.size());
    counts_.most_edges = std::max<std::uint64_t>(counts_.most_edges, nodes_.size());
  }

 private:
  /// The neighbour at a side: a leaf of the same or a larger size, or a divided node of the same size; no_node at the
  /// patch's edge.
  std::uint32_t neighbour(std::uint32_t node, Direction side) {
    ++counts_.edges_visited;
    const TreeNode& one = nodes_[node];
    if (one.parent == no_node) return no_node;
    if (!lies_at(one.part, side)) return nodes_[one.parent].children[mirrored(one.part, side)];
    const std::uint32_t above = neighbour(one.parent, side);
    if (above == no_node || nodes_[above].is_leaf()) return above;
    ++counts_.edges_visited;
    return nodes_[above].children[mirrored(one.part, side)];
  }

  /// Calls visit(leaf) for the leaves below a node that touch one of its sides, in the order of positions.
  void visit_side(std::uint32_t node, Direction side, const std::function<void(std::uint32_t)>& visit) {
    ++counts_.edges_visited;
    if (nodes_[node].is_leaf()) return visit(node);
    for (std::uint32_t part = 0; part < 4; ++part) {
      if (lies_at(part, side)) visit_side(nodes_[node].children[part], side, visit);
    }
  }

  std::uint32_t known_vertex(std::uint32_t x, std::uint32_t y) {
    const WireEdge& edge = y == 0            ? *frame_->south
                           : y == whole_side ? *frame_->north
                           : x == 0          ? *frame_->west
                                             : *frame_->east;
    const std::uint32_t place = y == 0 || y == whole_side ? x : y;
    const auto found = std::ranges::find(edge, place, &WireVertex::place);
    return add_known(*found);
  }

  std::uint32_t add_known(const WireVertex& known) {
    const auto [place, is_new] = known_.try_emplace(known.number, static_cast<std::uint32_t>(vertices_.size()));
    if (is_new) vertices_.push_back({known.point, known.number, true, true});
    return place->second;
  }

  /// Makes the vertex at a leaf's corner, unless a neighbour has already assigned it.
  void find_vertex(std::uint32_t leaf, Corner corner) {
    if (nodes_[leaf].corners[corner] != no_node) return;
    const Square& square = nodes_[leaf].element.square;
    const std::uint32_t x = square.x + (corner % 2 == 1 ? square.size : 0);
    const std::uint32_t y = square.y + (corner / 2 == 1 ? square.size : 0);
    const bool at_edge = x == 0 || y == 0 || x == whole_side || y == whole_side;
    std::uint32_t vertex = no_node;
    if (at_edge && frame_ != nullptr) {
      vertex = known_vertex(x, y);
    } else {
      vertex = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back({nodes_[leaf].element.corners[corner], output_.new_vertex()});
      ++counts_.vertices;
    }
    assign(leaf, corner, vertex);
  }

  /// Assigns a vertex to a corner of a leaf, and to all leaves around it with the same corner.
  void assign(std::uint32_t leaf, Corner corner, std::uint32_t vertex) {
    if (nodes_[leaf].corners[corner] != no_node) return;
    nodes_[leaf].corners[corner] = vertex;
    const Direction along_x = corner % 2 == 1 ? to_east : to_west;
    const Direction along_y = corner / 2 == 1 ? to_north : to_south;
    for (const auto& [across, along] : {std::pair(along_x, along_y), std::pair(along_y, along_x)}) {
      const std::uint32_t beyond = neighbour(leaf, across);
      if (beyond == no_node) continue;
      const std::uint32_t end = corner_leaf(beyond, opposite(across), along);
      const Corner same = static_cast<Corner>(mirrored(corner, across));
      if (shares_corner(end, leaf, corner, same)) assign(end, same, vertex);
    }
  }

  /// The leaf below a node in the corner between two of its sides.
  std::uint32_t corner_leaf(std::uint32_t node, Direction one, Direction other) {
    while (!nodes_[node].is_leaf()) {
      ++counts_.edges_visited;
      for (std::uint32_t part = 0; part < 4; ++part) {
        if (lies_at(part, one) && lies_at(part, other)) {
          node = nodes_[node].children[part];
          break;
        }
      }
    }
    return node;
  }

  bool shares_corner(std::uint32_t other, std::uint32_t leaf, Corner corner, Corner same) const {
    const auto at = [&](std::uint32_t node, Corner one) {
      const Square& square = nodes_[node].element.square;
      return std::pair(square.x + (one % 2 == 1 ? square.size : 0), square.y + (one / 2 == 1 ? square.size : 0));
    };
    return at(other, same) == at(leaf, corner);
  }

  /// Places the corners of smaller neighbours on the line of a leaf's side.
  void snap_to_side(std::uint32_t leaf, Direction side) {
    const std::uint32_t beyond = neighbour(leaf, side);
    if (beyond == no_node || nodes_[beyond].is_leaf()) return;
    const std::pair<Corner, Corner> ends = side_ends(side);
    const Square& square = nodes_[leaf].element.square;
    const bool is_along_x = side == to_south || side == to_north;
    const std::uint32_t begin = is_along_x ? square.x : square.y;
    visit_side(beyond, opposite(side), [&](std::uint32_t small) {
      const Corner end = side_ends(opposite(side)).second;
      const Square& other = nodes_[small].element.square;
      const std::uint32_t place = (is_along_x ? other.x : other.y) + other.size;
      if (place == begin + square.size) return;
      TreeVertex& vertex = vertices_[nodes_[small].corners[end]];
      vertex.from = nodes_[leaf].corners[ends.first];
      vertex.to = nodes_[leaf].corners[ends.second];
      vertex.part = static_cast<double>(place - begin) / square.size;
      ++counts_.snaps;
    });
  }

  /// Computes the position of a vertex. The recursion depth is the number of lines that end on other lines.
  void place(std::uint32_t number) {
    TreeVertex& vertex = vertices_[number];
    if (vertex.is_placed) return;
    if (vertex.from != no_node) {
      place(vertex.from);
      place(vertex.to);
      vertex.point = glm::mix(vertices_[vertex.from].point, vertices_[vertex.to].point, vertex.part);
    }
    vertex.is_placed = true;
    output_.vertex(vertex.number, vertex.point);
  }

  void emit(std::uint32_t leaf) {
    std::vector<std::uint32_t> numbers;
    const auto add = [&](Corner corner, Direction side, bool is_backwards) {
      numbers.push_back(vertices_[nodes_[leaf].corners[corner]].number);
      std::vector<std::uint32_t> between = between_on(leaf, side);
      if (is_backwards) std::ranges::reverse(between);
      numbers.insert(numbers.end(), between.begin(), between.end());
    };
    add(sw, to_south, false);
    add(se, to_east, false);
    add(ne, to_north, true);
    add(nw, to_west, true);
    output_.element(nodes_[leaf].element.square, numbers);
  }

  std::vector<std::uint32_t> between_on(std::uint32_t leaf, Direction side) {
    const Square square = nodes_[leaf].element.square;
    const bool is_along_x = side == to_south || side == to_north;
    const std::uint32_t begin = is_along_x ? square.x : square.y;
    std::vector<std::uint32_t> numbers;
    const std::uint32_t beyond = neighbour(leaf, side);
    if (beyond == no_node) {
      if (frame_ == nullptr) return numbers;
      const std::array edges{frame_->south, frame_->east, frame_->north, frame_->west};
      for (const WireVertex& one : *edges[side]) {
        if (one.place > begin && one.place < begin + square.size) numbers.push_back(one.number);
      }
      return numbers;
    }
    if (nodes_[beyond].is_leaf()) return numbers;
    const Corner end = side_ends(opposite(side)).second;
    visit_side(beyond, opposite(side),
               [&](std::uint32_t small) { numbers.push_back(vertices_[nodes_[small].corners[end]].number); });
    numbers.pop_back();
    return numbers;
  }

  const PatchEdges* frame_;
  Output& output_;
  RepairCounts& counts_;
  std::vector<TreeNode> nodes_;
  std::vector<std::uint32_t> leaves_;
  std::vector<TreeVertex> vertices_;
  std::map<std::uint32_t, std::uint32_t> known_;  ///< vertices by their numbers in the wire frame
};

}  // namespace

void repair_by_quadtree(Stream& stream, const PatchEdges* edges, Output& output, RepairCounts& counts) {
  Quadtree tree(edges, output, counts);
  tree.read(stream);
  tree.repair();
}

}  // namespace csgsim::swept
