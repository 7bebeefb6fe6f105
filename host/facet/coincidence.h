// Tolerance and hashing that identify coincident surfaces.
// Used by planes.h, quadric_table.h and sim/software.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace csgsim::facet {

/// Surfaces closer to each other than this are treated as one surface. The tolerance applies to components of normals
/// and axes, and to lengths relative to the model's diagonal. Chains of transforms in double precision have errors of
/// about 1e-15. Walls thinner than the tolerance vanish.
inline constexpr double coincidence_tolerance = 1e-11;

/// Whether the first nonzero component is negative.
inline bool points_backward(const glm::dvec3& direction) {
  constexpr double zero_component = 4.0 * coincidence_tolerance;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) > zero_component) return direction[axis] < 0.0;
  }
  return false;
}

/// The key of a surface. Two surfaces coincide if no component of their keys differs by more than the tolerance.
template <std::size_t size>
using Key = std::array<double, size>;

/// The grid cell of a component. Cells are wide compared with the tolerance, so surfaces that coincide rarely fall into
/// different cells. The number of cells per unit is a power of two, and cells are centred on multiples of their width,
/// so common components such as 0, 1/2 and 1 are far from cell boundaries.
inline double cell_at(double component) {
  constexpr double cells_per_unit = 0x1p31;
  return std::floor(component * cells_per_unit + 0.5);
}

template <std::size_t size>
Key<size> cell_of(const Key<size>& key) {
  Key<size> cell;
  for (std::size_t i = 0; i < size; ++i) cell[i] = cell_at(key[i]);
  return cell;
}

template <std::size_t size>
std::uint64_t hash_of(const Key<size>& cell) {
  std::uint64_t sum = 0;
  for (const double one : cell) {
    // Beyond 2^53 a cell is as wide as the spacing of doubles, so its number is not an integer; hashing only needs
    // distinct numbers.
    sum = (sum ^ std::bit_cast<std::uint64_t>(one + 0.0)) * 0x9e3779b97f4a7c15U;
    sum ^= sum >> 32U;
  }
  return sum;
}

template <std::size_t size>
bool are_near(const Key<size>& first, const Key<size>& second) {
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_near = second[i] >= first[i] - coincidence_tolerance && second[i] <= first[i] + coincidence_tolerance;
    if (!is_near) return false;
  }
  return true;
}

/// Calls visit(cell) for each cell that may hold a surface coincident with the key.
template <std::size_t size, class Visit>
void for_each_near_cell(const Key<size>& key, const Visit& visit) {
  Key<size> cell;
  std::array<std::size_t, size> split;  // components that may be in two cells
  std::array<double, size> others;      // the second cell of each of these components
  std::size_t splits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    cell[i] = cell_at(key[i] - coincidence_tolerance);
    const double high = cell_at(key[i] + coincidence_tolerance);
    if (high == cell[i]) continue;
    split[splits] = i;
    others[splits++] = high;
  }
  for (std::size_t corner = 0; corner < std::size_t{1} << splits; ++corner) {
    Key<size> near = cell;
    for (std::size_t i = 0; i < splits; ++i) {
      if ((corner >> i & 1U) != 0) near[split[i]] = others[i];
    }
    visit(near);
  }
}

}  // namespace csgsim::facet
