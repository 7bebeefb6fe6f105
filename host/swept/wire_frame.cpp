#include "host/swept/wire_frame.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <memory>

namespace csgsim::swept {

namespace {

template <class Mark>
void add(std::vector<Mark>& marks, std::uint32_t place, const glm::dvec3& point) {
  marks.push_back({place, point});
}

}  // namespace

WireFrame::WireFrame(Surface& surface, const Accuracy& accuracy, SubdivisionCounts& counts, Output& output)
    : columns_(surface.columns()),
      rows_(surface.rows()),
      u_joints_(rows_ + (surface.wraps_rows() ? 0 : 1)),
      v_joints_(columns_ + (surface.wraps_columns() ? 0 : 1)),
      along_u_(columns_ * u_joints_),
      along_v_(v_joints_ * rows_) {
  // Marks of the patches on the two sides of each edge; for an edge along u, of the patch above it and of the patch
  // below it.
  std::vector<std::array<Marks, 2>> u_marks(along_u_.size());
  std::vector<std::array<Marks, 2>> v_marks(along_v_.size());
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::unique_ptr<Stream> stream = surface.subdivide(column, row, accuracy, counts);
      Marks& south = u_marks[u_edge(column, row)][0];
      Marks& north = u_marks[u_edge(column, row + 1)][1];
      Marks& west = v_marks[v_edge(column, row)][0];
      Marks& east = v_marks[v_edge(column + 1, row)][1];
      while (const std::optional<Node> node = stream->next()) {
        if (!node->is_leaf) continue;
        const auto& [square, corners] = node->element;
        if (square.y == 0) add(south, square.x, corners[sw]);
        if (square.x == 0) add(west, square.y, corners[sw]);
        if (square.y + square.size == whole_side) add(north, square.x, corners[nw]);
        if (square.x + square.size == whole_side) add(east, square.y, corners[se]);
        if (square.x + square.size == whole_side && square.y == 0) add(south, whole_side, corners[se]);
        if (square.y + square.size == whole_side && square.x == 0) add(west, whole_side, corners[nw]);
        if (square.x + square.size == whole_side && square.y + square.size == whole_side) {
          add(north, whole_side, corners[ne]);
          add(east, whole_side, corners[ne]);
        }
      }
    }
  }
  for (std::size_t i = 0; i < along_u_.size(); ++i) join(along_u_[i], u_marks[i][0], u_marks[i][1]);
  for (std::size_t i = 0; i < along_v_.size(); ++i) join(along_v_[i], v_marks[i][0], v_marks[i][1]);
  number_corners(output);
  for (std::vector<WireEdge>* const edges : {&along_u_, &along_v_}) {
    for (WireEdge& edge : *edges) {
      for (std::size_t i = 1; i + 1 < edge.size(); ++i) {
        edge[i].number = output.new_vertex();
        output.vertex(edge[i].number, edge[i].point);
        ++vertices_;
      }
    }
  }
}

/// Merges the marks of both sides. Each list is sorted, since a patch's elements along a side arrive in order.
void WireFrame::join(WireEdge& edge, const Marks& first_marks, const Marks& second_marks) {
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < first_marks.size() || k < second_marks.size()) {
    const bool has_one =
        i < first_marks.size() && (k >= second_marks.size() || first_marks[i].place <= second_marks[k].place);
    const bool has_other =
        k < second_marks.size() && (i >= first_marks.size() || second_marks[k].place <= first_marks[i].place);
    const Mark& mark = has_one ? first_marks[i] : second_marks[k];
    edge.push_back({mark.place, 0, mark.point, (has_one && has_other) || first_marks.empty() || second_marks.empty()});
    i += has_one ? 1 : 0;
    k += has_other ? 1 : 0;
  }
  std::size_t start = 0;
  for (std::size_t end = 1; end < edge.size(); ++end) {
    if (!edge[end].is_end) continue;
    const double length = edge[end].place - edge[start].place;
    for (std::size_t between = start + 1; between < end; ++between) {
      edge[between].point =
          glm::mix(edge[start].point, edge[end].point, (edge[between].place - edge[start].place) / length);
      ++snaps_;
    }
    start = end;
  }
}

/// Numbers the corners; each is the end of up to four edges.
void WireFrame::number_corners(Output& output) {
  const auto set = [](WireVertex& end, std::uint32_t number, const glm::dvec3& point) {
    end.number = number;
    end.point = point;
  };
  for (std::size_t row = 0; row < u_joints_; ++row) {
    for (std::size_t column = 0; column < v_joints_; ++column) {
      const std::uint32_t number = output.new_vertex();
      const bool is_last = column == columns_;
      const glm::dvec3 point = is_last ? along_u(column - 1, row).back().point : along_u(column, row).front().point;
      output.vertex(number, point);
      ++vertices_;
      if (!is_last) set(along_u_[u_edge(column, row)].front(), number, point);
      if (column > 0 || v_joints_ == columns_)
        set(along_u_[u_edge(column == 0 ? columns_ - 1 : column - 1, row)].back(), number, point);
      if (row < rows_) set(along_v_[v_edge(column, row)].front(), number, point);
      if (row > 0 || u_joints_ == rows_)
        set(along_v_[v_edge(column, row == 0 ? rows_ - 1 : row - 1)].back(), number, point);
    }
  }
}

std::size_t WireFrame::u_edge(std::size_t column, std::size_t joint) const {
  return (joint % u_joints_) * columns_ + column;
}

std::size_t WireFrame::v_edge(std::size_t joint, std::size_t row) const { return row * v_joints_ + joint % v_joints_; }

const WireEdge& WireFrame::along_u(std::size_t column, std::size_t joint) const {
  return along_u_[u_edge(column, joint)];
}

const WireEdge& WireFrame::along_v(std::size_t joint, std::size_t row) const { return along_v_[v_edge(joint, row)]; }

PatchEdges WireFrame::edges(std::size_t column, std::size_t row) const {
  return {&along_u(column, row), &along_v(column, row), &along_u(column, row + 1), &along_v(column + 1, row)};
}

}  // namespace csgsim::swept
