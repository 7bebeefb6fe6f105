#include "host/convex/carver.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "host/convex/clip.h"

namespace csgsim::convex {

Carver::Carver(Polytope polytope, const facet::PlaneTable& planes)
    : planes_(planes), index_(polytope.empty() ? facet::Box{} : box_of(polytope)) {
  for (const glm::dvec3& vertex : polytope.vertices) add_vertex(vertex, glm::dvec3(0));
  for (std::uint32_t face = 0; face < polytope.faces.size(); ++face)
    for (const std::uint32_t corner : polytope.faces[face].corners) at_[corner].push_back(face);
  polytope_.faces = std::move(polytope.faces);
  faces_ = static_cast<std::uint32_t>(polytope_.faces.size());
}

void Carver::add_vertex(const glm::dvec3& position, const glm::dvec3& normal) {
  index_.insert(static_cast<std::uint32_t>(polytope_.vertices.size()), position, normal);
  polytope_.vertices.push_back(position);
  at_.emplace_back();
  is_alive_.push_back(true);
  sides_.push_back(VertexSide::in);
}

std::uint64_t Carver::steps() const { return clip_steps(visited_); }

bool Carver::has_vertex_behind(const facet::Plane& plane, double tolerance) {
  const auto is_deep = [&](std::uint32_t vertex) {
    return is_alive_[vertex] && plane.height(polytope_.vertices[vertex]) < -tolerance;
  };
  if (is_deep(deep_)) return true;
  while (first_alive_ < at_.size() && !is_alive_[first_alive_]) ++first_alive_;
  for (deep_ = first_alive_; deep_ < at_.size(); ++deep_) {
    ++visited_;
    if (is_deep(deep_)) return true;
  }
  deep_ = 0;
  return false;
}

bool Carver::find_sides(const facet::Plane& plane, double tolerance) {
  for (const std::uint32_t vertex : found_) sides_[vertex] = VertexSide::in;
  found_.clear();
  visited_ += index_.find(plane, tolerance, found_);
  bool is_one_out = false;
  for (const std::uint32_t vertex : found_) {
    const bool is_out = plane.height(polytope_.vertices[vertex]) > tolerance;
    sides_[vertex] = is_out ? VertexSide::out : VertexSide::on;
    is_one_out = is_one_out || is_out;
  }
  return is_one_out;
}

std::vector<std::uint32_t> Carver::faces_at_found_vertices() {
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t vertex : found_) faces.insert(faces.end(), at_[vertex].begin(), at_[vertex].end());
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::uint64_t corners = 0;
  for (const std::uint32_t face : faces) corners += polytope_.faces[face].corners.size();
  // Divides by 3, because each vertex is a corner of at least three faces.
  visited_ = std::max(visited_, corners / 3);
  return faces;
}

void Carver::clip(facet::Halfspace halfspace) {
  if (empty()) return;
  visited_ = 0;
  const facet::Plane plane = outward_plane(halfspace, planes_);
  // The loop terminates: once the tolerance exceeds all distances, no vertex is inside.
  for (double times = 1.0;; times = next_tolerance_factor(times)) {
    const double near = times * tolerance(planes_);
    if (!has_vertex_behind(plane, near)) return clear();
    if (!find_sides(plane, near)) return;
    if (std::optional<Cut> made = cut_faces(polytope_, faces_at_found_vertices(), plane, sides_))
      return apply_cut(std::move(*made), halfspace);
  }
}

void Carver::drop_vertex(std::uint32_t vertex) {
  at_[vertex] = FacesAt();
  is_alive_[vertex] = false;
  index_.remove(vertex, polytope_.vertices[vertex]);
}

void Carver::drop_face(std::uint32_t face, std::vector<std::uint32_t>& doubtful) {
  std::vector<std::uint32_t> corners;
  std::swap(corners, polytope_.faces[face].corners);
  for (const std::uint32_t corner : corners) {
    FacesAt& faces = at_[corner];
    faces.erase(std::remove(faces.begin(), faces.end(), face), faces.end());
  }
  doubtful.insert(doubtful.end(), corners.begin(), corners.end());
  --faces_;
}

void Carver::apply_cut(Cut cut, facet::Halfspace halfspace) {
  std::vector<std::uint32_t> doubtful = cut.cap;
  for (const std::uint32_t vertex : found_) {
    if (sides_[vertex] == VertexSide::out) {
      drop_vertex(vertex);
    } else {
      doubtful.push_back(vertex);
    }
  }
  const std::size_t old = polytope_.vertices.size();
  const glm::dvec3 normal = outward_plane(halfspace, planes_).normal;
  for (const glm::dvec3& place : cut.added) add_vertex(place, normal);
  for (CutFace& one : cut.faces) {
    for (const std::uint32_t corner : one.corners)
      if (corner >= old) at_[corner].push_back(one.face);
    if (one.corners.size() < 3) {
      drop_face(one.face, doubtful);
    } else {
      polytope_.faces[one.face].corners = std::move(one.corners);
    }
  }
  const auto cap = static_cast<std::uint32_t>(polytope_.faces.size());
  for (const std::uint32_t corner : cut.cap) at_[corner].push_back(cap);
  polytope_.faces.push_back({halfspace, std::move(cut.cap)});
  ++faces_;
  for (std::size_t vertex = old; vertex < polytope_.vertices.size(); ++vertex)
    doubtful.push_back(static_cast<std::uint32_t>(vertex));
  remove_flat_parts(std::move(doubtful));
  if (faces_ < 4) clear();
}

void Carver::remove_flat_parts(std::vector<std::uint32_t> doubtful) {
  while (!doubtful.empty()) {
    const std::uint32_t vertex = doubtful.back();
    doubtful.pop_back();
    if (!is_alive_[vertex] || at_[vertex].size() >= 3) continue;
    const FacesAt faces = at_[vertex];
    drop_vertex(vertex);
    for (const std::uint32_t face : faces) {
      std::vector<std::uint32_t>& corners = polytope_.faces[face].corners;
      std::erase(corners, vertex);
      if (!corners.empty() && corners.size() < 3) drop_face(face, doubtful);
    }
  }
}

void Carver::clear() {
  polytope_ = {};
  faces_ = 0;
}

Polytope Carver::take() {
  std::erase_if(polytope_.faces, [](const Face& face) { return face.corners.empty(); });
  drop_unused_vertices(polytope_);
  return std::move(polytope_);
}

}  // namespace csgsim::convex
