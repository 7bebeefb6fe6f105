#include "host/swept/filter.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "host/swept/held_vertices.h"

namespace csgsim::swept {

namespace {

/// Sides of an element. The vertices between the corners are in the order of their positions.
enum Side : std::uint8_t { south, east, north, west };

struct HeldElement {
  Square square;
  std::array<std::uint32_t, 4> corners{};
  std::array<std::vector<std::uint32_t>, 4> sides;
  std::uint32_t edges = 0;  ///< number of border edges that are its sides or parts of its sides
};

/// Visits the vertices counter-clockwise from the south-west corner.
template <class Visit>
void for_vertices(const HeldElement& element, const Visit& visit) {
  visit(element.corners[sw]);
  std::ranges::for_each(element.sides[south], visit);
  visit(element.corners[se]);
  std::ranges::for_each(element.sides[east], visit);
  visit(element.corners[ne]);
  std::for_each(element.sides[north].rbegin(), element.sides[north].rend(), visit);
  visit(element.corners[nw]);
  std::for_each(element.sides[west].rbegin(), element.sides[west].rend(), visit);
}

/// An edge of the border: a side of a processed element or a part of it, or a part of the patch's own edge.
struct Edge {
  std::uint32_t from = 0;  ///< position along the side of the patch
  std::uint32_t to = 0;
  std::uint32_t start = nothing;  ///< vertex; `nothing` until the first element without a wire frame sets it
  std::uint32_t end = nothing;
  std::uint32_t element = nothing;  ///< element of whose side this is a part
  std::uint32_t next = nothing;
  /// The first vertex of the wire frame after the start; null without a wire frame.
  const WireVertex* between = nullptr;

  [[nodiscard]] std::uint32_t size() const { return to - from; }
};

class Filter {
 public:
  Filter(Stream& stream, const PatchEdges* frame, Output& output, RepairCounts& counts)
      : stream_(stream), frame_(frame), output_(output), counts_(counts), vertices_(output, counts) {}

  void run() {
    std::uint32_t u_edge = first_edges(frame_ == nullptr ? nullptr : frame_->south);
    std::uint32_t v_edge = first_edges(frame_ == nullptr ? nullptr : frame_->west);
    u_first_ = u_edge;
    v_first_ = v_edge;
    if (frame_ != nullptr) {
      north_ = frame_->north->data();
      east_ = frame_->east->data();
    }
    traverse(whole_side, u_edge, v_edge);
    finish(u_first_, north, frame_ == nullptr ? nullptr : frame_->north);
    finish(v_first_, east, frame_ == nullptr ? nullptr : frame_->east);
  }

 private:
  /// The part of the border along one side of a leaf. Each vertex in `between` is held by a removed edge.
  struct Bordering {
    std::uint32_t start = nothing;
    std::uint32_t end = nothing;
    std::vector<std::uint32_t> between;
  };

  std::uint32_t first_edges(const WireEdge* wire);
  void traverse(std::uint32_t size, std::uint32_t& u_edge, std::uint32_t& v_edge);
  void process(const Element& leaf, std::uint32_t u_edge, std::uint32_t v_edge);
  Bordering border_on(std::uint32_t edge, Side side, const Element& leaf);
  std::vector<std::uint32_t> merge(std::uint32_t edge, std::uint32_t size);
  void split(std::uint32_t edge, Side side, std::uint32_t size, const glm::dvec3& point);
  std::uint32_t new_on_edge(const Edge& edge, Side side, std::uint32_t place, const glm::dvec3& point);
  std::vector<std::uint32_t> known_between(const Edge& edge);
  std::uint32_t north_east(const Element& leaf);
  void move(std::uint32_t edge, std::uint32_t element, std::uint32_t start, std::uint32_t end);
  void release(std::uint32_t element);
  void emit(const HeldElement& element);
  void finish(std::uint32_t edge, Side side, const WireEdge* wire);
  void update_peaks();

  void hold(std::uint32_t vertex) { vertices_.hold_by_edge(vertex); }
  void drop(std::uint32_t vertex) {
    if (vertex != nothing) vertices_.release_by_edge(vertex);
  }
  std::uint32_t new_edge();
  std::uint32_t new_element();
  std::uint32_t known(const WireVertex& vertex) { return vertices_.add_known(vertex.number, vertex.point); }

  Stream& stream_;
  const PatchEdges* frame_;
  Output& output_;
  RepairCounts& counts_;
  HeldVertices vertices_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> free_edges_;
  std::vector<HeldElement> elements_;
  std::vector<std::uint32_t> free_elements_;
  std::vector<std::uint32_t> left_;  ///< elements whose border edge has just moved away
  std::vector<std::uint32_t> numbers_;
  std::uint64_t held_edges_ = 0;
  std::uint64_t held_elements_ = 0;
  std::uint32_t u_first_ = nothing;
  std::uint32_t v_first_ = nothing;
  const WireVertex* north_ = nullptr;  ///< position in the wire frame up to which elements have been processed
  const WireVertex* east_ = nullptr;
};

std::uint32_t Filter::new_edge() {
  ++held_edges_;
  if (free_edges_.empty()) {
    edges_.emplace_back();
    return static_cast<std::uint32_t>(edges_.size() - 1);
  }
  const std::uint32_t edge = free_edges_.back();
  free_edges_.pop_back();
  edges_[edge] = {};
  return edge;
}

std::uint32_t Filter::new_element() {
  ++held_elements_;
  if (free_elements_.empty()) {
    elements_.emplace_back();
    return static_cast<std::uint32_t>(elements_.size() - 1);
  }
  const std::uint32_t element = free_elements_.back();
  free_elements_.pop_back();
  elements_[element] = {};
  return element;
}

/// Makes a list with one edge or, with a wire frame, with the segments of its edge.
std::uint32_t Filter::first_edges(const WireEdge* wire) {
  const std::uint32_t first = new_edge();
  edges_[first].to = whole_side;
  if (wire == nullptr) return first;
  std::uint32_t edge = first;
  std::uint32_t start = known(wire->front());
  for (std::size_t i = 1, begin = 0; i < wire->size(); ++i) {
    if (!(*wire)[i].is_end) continue;
    if (begin > 0) {
      const std::uint32_t next = new_edge();
      edges_[edge].next = next;
      edge = next;
    }
    const std::uint32_t end = known((*wire)[i]);
    Edge& one = edges_[edge];
    one.from = (*wire)[begin].place;
    one.to = (*wire)[i].place;
    one.start = start;
    one.end = end;
    one.between = &(*wire)[begin + 1];
    hold(start);
    hold(end);
    start = end;
    begin = i;
  }
  return first;
}

/// Algorithm 3.2. A merge keeps the first of several edges, a split keeps the first part, and neither starts before the
/// current element, so the stored list heads stay valid.
void Filter::traverse(std::uint32_t size, std::uint32_t& u_edge, std::uint32_t& v_edge) {
  const std::optional<Node> node = stream_.next();
  if (!node) throw std::logic_error("a stream of elements has ended before its patch");
  if (node->is_leaf) {
    process(node->element, u_edge, v_edge);
    u_edge = edges_[u_edge].next;
    v_edge = edges_[v_edge].next;
    return;
  }
  std::uint32_t u_start = u_edge;
  std::uint32_t v_start = v_edge;
  traverse(size / 2, u_edge, v_edge);
  traverse(size / 2, u_edge, v_start);
  traverse(size / 2, u_start, v_edge);
  traverse(size / 2, u_start, v_start);
}

void Filter::process(const Element& leaf, std::uint32_t u_edge, std::uint32_t v_edge) {
  ++counts_.elements;
  const Bordering below = border_on(u_edge, south, leaf);
  // Both lists start at the same vertex, which does not exist yet if there is no wire frame.
  if (edges_[v_edge].start == nothing) {
    edges_[v_edge].start = below.start;
    hold(below.start);
  }
  const Bordering beside = border_on(v_edge, west, leaf);
  if (vertices_.number(below.start) != vertices_.number(beside.start))
    throw std::logic_error("the two lists of edges do not meet at an element");
  const std::uint32_t number = new_element();
  HeldElement& element = elements_[number];
  element.square = leaf.square;
  element.corners = {below.start, below.end, beside.end, north_east(leaf)};
  element.sides[south] = below.between;
  element.sides[west] = beside.between;
  for_vertices(element, [&](std::uint32_t vertex) { vertices_.hold_by_element(vertex); });
  // The vertices are held by the element before those of its old border are released.
  move(u_edge, number, element.corners[nw], element.corners[ne]);
  move(v_edge, number, element.corners[se], element.corners[ne]);
  for (const Bordering* const side : {&below, &beside}) {
    for (const std::uint32_t vertex : side->between) drop(vertex);
    drop(side->start);
    drop(side->end);
  }
  for (const std::uint32_t other : left_) release(other);
  left_.clear();
  update_peaks();
}

/// Algorithm 3.3 without the move: makes the edge as long as the element's side.
Filter::Bordering Filter::border_on(std::uint32_t edge, Side side, const Element& leaf) {
  ++counts_.edges_visited;
  const glm::dvec3& end_point = leaf.corners[side == south ? se : nw];
  if (edges_[edge].start == nothing) {
    edges_[edge].start = vertices_.add(leaf.corners[sw]);
    hold(edges_[edge].start);
  }
  Bordering found;
  if (leaf.square.size > edges_[edge].size()) {
    found.between = merge(edge, leaf.square.size);
  } else if (leaf.square.size < edges_[edge].size()) {
    split(edge, side, leaf.square.size, end_point);
  } else {
    found.between = known_between(edges_[edge]);
  }
  if (edges_[edge].end == nothing) {
    edges_[edge].end = vertices_.add(end_point);
    hold(edges_[edge].end);
  }
  found.start = edges_[edge].start;
  found.end = edges_[edge].end;
  return found;
}

/// Merges edges into one, and places the vertices of smaller elements on the side of the larger element.
std::vector<std::uint32_t> Filter::merge(std::uint32_t edge, std::uint32_t size) {
  std::vector<std::uint32_t> between;
  std::vector<std::uint32_t> places;
  while (edges_[edge].size() < size) {
    const std::uint32_t next = edges_[edge].next;
    const Edge gone = edges_[next];
    between.push_back(gone.start);
    places.push_back(gone.from);
    drop(gone.start);  // one of the vertex's two holds
    left_.push_back(gone.element);
    edges_[edge].to = gone.to;
    edges_[edge].end = gone.end;
    edges_[edge].next = gone.next;
    free_edges_.push_back(next);
    --held_edges_;
    ++counts_.edges_visited;
    ++counts_.merges;
  }
  const Edge& whole = edges_[edge];
  for (std::size_t i = 0; i < between.size(); ++i)
    vertices_.place_on_line(between[i], whole.start, whole.end, static_cast<double>(places[i] - whole.from) / size);
  return between;
}

void Filter::split(std::uint32_t edge, Side side, std::uint32_t size, const glm::dvec3& point) {
  ++counts_.splits;
  const std::uint32_t rest = new_edge();
  const std::uint32_t middle = edges_[edge].from + size;
  const std::uint32_t vertex = new_on_edge(edges_[edge], side, middle, point);
  hold(vertex);
  edges_[rest] = edges_[edge];
  edges_[rest].from = middle;
  edges_[rest].start = vertex;
  edges_[edge].to = middle;
  edges_[edge].end = vertex;
  edges_[edge].next = rest;
  if (edges_[rest].element != nothing) ++elements_[edges_[rest].element].edges;
  if (edges_[rest].between != nullptr) ++edges_[rest].between;
  edges_[edge].between = nullptr;
}

/// Makes the vertex at which a smaller element ends, held by an edge. The vertex is at the wire frame's vertex, on the
/// line of the larger element's side, or on the surface.
std::uint32_t Filter::new_on_edge(const Edge& edge, Side side, std::uint32_t place, const glm::dvec3& point) {
  if (edge.between != nullptr) {
    const std::uint32_t vertex = known(*edge.between);
    hold(vertex);
    return vertex;
  }
  const std::uint32_t vertex = vertices_.add(point);
  hold(vertex);
  if (edge.element == nothing) return vertex;
  HeldElement& element = elements_[edge.element];
  element.sides[side == south ? north : east].push_back(vertex);
  vertices_.hold_by_element(vertex);
  const std::uint32_t from = side == south ? element.square.x : element.square.y;
  vertices_.place_on_line(vertex, element.corners[side == south ? nw : se], element.corners[ne],
                          static_cast<double>(place - from) / element.square.size);
  return vertex;
}

/// The vertices inside a segment of the wire frame, made by the patch on its other side.
std::vector<std::uint32_t> Filter::known_between(const Edge& edge) {
  std::vector<std::uint32_t> between;
  if (edge.between == nullptr) return between;
  for (const WireVertex* one = edge.between; one->place < edge.to; ++one) {
    between.push_back(known(*one));
    hold(between.back());
  }
  return between;
}

std::uint32_t Filter::north_east(const Element& leaf) {
  const std::uint32_t x = leaf.square.x + leaf.square.size;
  const std::uint32_t y = leaf.square.y + leaf.square.size;
  if (frame_ == nullptr || (x < whole_side && y < whole_side)) return vertices_.add(leaf.corners[ne]);
  while (y == whole_side && north_->place < x) ++north_;
  while (x == whole_side && east_->place < y) ++east_;
  return known(y == whole_side ? *north_ : *east_);
}

/// Moves the edge to the opposite side of the element.
void Filter::move(std::uint32_t edge, std::uint32_t element, std::uint32_t start, std::uint32_t end) {
  hold(start);
  hold(end);
  left_.push_back(edges_[edge].element);
  ++elements_[element].edges;
  edges_[edge].element = element;
  edges_[edge].start = start;
  edges_[edge].end = end;
  edges_[edge].between = nullptr;
}

void Filter::release(std::uint32_t element) {
  if (element == nothing || --elements_[element].edges > 0) return;
  emit(elements_[element]);
  for_vertices(elements_[element], [&](std::uint32_t vertex) { vertices_.release_by_element(vertex); });
  free_elements_.push_back(element);
  --held_elements_;
}

void Filter::emit(const HeldElement& element) {
  numbers_.clear();
  for_vertices(element, [&](std::uint32_t vertex) { numbers_.push_back(vertices_.number(vertex)); });
  output_.element(element.square, numbers_);
}

/// Completes the elements along the patch's north or east edge.
void Filter::finish(std::uint32_t edge, Side side, const WireEdge* wire) {
  std::size_t at = 0;
  for (std::uint32_t one = edge; one != nothing; one = edges_[one].next) {
    HeldElement& element = elements_[edges_[one].element];
    for (; wire != nullptr && (*wire)[at].place < edges_[one].to; ++at) {
      if ((*wire)[at].place <= edges_[one].from) continue;
      element.sides[side].push_back(known((*wire)[at]));
      vertices_.hold_by_element(element.sides[side].back());
    }
  }
  for (std::uint32_t one = edge; one != nothing; one = edges_[one].next) {
    drop(edges_[one].start);
    drop(edges_[one].end);
  }
  for (std::uint32_t one = edge; one != nothing; one = edges_[one].next) release(edges_[one].element);
}

void Filter::update_peaks() {
  counts_.most_elements = std::max(counts_.most_elements, held_elements_);
  counts_.most_vertices = std::max(counts_.most_vertices, vertices_.held());
  counts_.most_edges = std::max(counts_.most_edges, held_edges_);
}

}  // namespace

void filter(Stream& stream, const PatchEdges* edges, Output& output, RepairCounts& counts) {
  Filter(stream, edges, output, counts).run();
}

}  // namespace csgsim::swept
