#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/solids/mesh.h"
#include "host/swept/mesh.h"
#include "host/swept/net.h"

namespace csgsim::swept_test {

/// A B-spline as the sum of its basis functions (Cox and de Boor) at a parameter from 0 to its number of spans.
glm::dvec3 by_basis(const swept::Curve& curve, double parameter);

/// A point of a net's patch, by the same method.
glm::dvec3 by_basis(const swept::Net& net, double u, double v);

/// A net around the origin with random heights.
swept::Net random_net(std::uint32_t rows, std::uint32_t columns, double height);

/// The leaves of a patch in their order.
std::vector<swept::Element> leaves_of(swept::Surface& surface, std::size_t column, std::size_t row,
                                      const swept::Accuracy& accuracy);

/// Records the output of a repair.
class Record : public swept::Output {
 public:
  struct RecordedElement {
    swept::Square square;
    std::vector<std::uint32_t> corners;
  };

  std::uint32_t new_vertex() override { return next_++; }
  void vertex(std::uint32_t number, const glm::dvec3& point) override;
  void element(const swept::Square& square, std::span<const std::uint32_t> corners) override {
    elements.push_back({square, {corners.begin(), corners.end()}});
  }

  std::map<std::uint32_t, glm::dvec3> points;
  std::vector<RecordedElement> elements;
  std::string fault;  ///< description of a repeated vertex

 private:
  std::uint32_t next_ = 0;
};

/// Returns an edge that does not occur once in each direction, so that faces are not closed and oriented; empty if
/// none.
std::string open_edge(const std::vector<std::vector<std::uint32_t>>& faces);

double volume(const solids::Mesh& mesh);

}  // namespace csgsim::swept_test
