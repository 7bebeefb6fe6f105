#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "host/solids/check.h"
#include "host/solids/neighbours.h"

namespace csgsim::solids {

namespace {

/// A face across an edge of another face.
struct Beyond {
  std::uint32_t face;
  /// Whether both faces run along the edge in the same direction, which correctly oriented neighbours do not.
  bool runs_same_way;
};

/// The faces beyond each face's edges; only for edges shared by exactly two faces.
std::vector<std::vector<Beyond>> faces_beyond(const Mesh& mesh) {
  std::vector<std::vector<Beyond>> beyond(mesh.faces.size());
  for (const Joint& joint : find_joints(mesh)) {
    if (joint.one == joint.other) continue;
    beyond[joint.one].push_back({joint.other, joint.same_way});
    beyond[joint.other].push_back({joint.one, joint.same_way});
  }
  return beyond;
}

enum class Turn : std::uint8_t { unknown, stays, turns };

Turn opposite(Turn turn) { return turn == Turn::stays ? Turn::turns : Turn::stays; }

/// Decides, for each face that is connected to the first face by edges, whether it must be reversed relative to that
/// face. Returns these faces; empty if the orientation is inconsistent, as on a one-sided band.
std::vector<std::uint32_t> spread(std::uint32_t first, const std::vector<std::vector<Beyond>>& beyond,
                                  std::vector<Turn>& turns) {
  std::vector<std::uint32_t> reached{first};
  bool has_two_sides = true;
  turns[first] = Turn::stays;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Turn here = turns[reached[i]];
    for (const auto [face, runs_same_way] : beyond[reached[i]]) {
      const Turn wanted = runs_same_way ? opposite(here) : here;
      if (turns[face] == Turn::unknown) {
        turns[face] = wanted;
        reached.push_back(face);
      }
      has_two_sides = has_two_sides && turns[face] == wanted;
    }
  }
  if (!has_two_sides) return {};
  return reached;
}

}  // namespace

TurnedFaces turn_faces(NumberedMesh& numbered) {
  Mesh& mesh = numbered.mesh;
  const std::vector<std::vector<Beyond>> beyond = faces_beyond(mesh);
  std::vector<Turn> turns(mesh.faces.size(), Turn::unknown);
  std::set<std::uint32_t> numbers;  // file numbers of reversed faces: one file face may have several parts
  for (std::uint32_t first = 0; first < mesh.faces.size(); ++first) {
    if (turns[first] != Turn::unknown) continue;
    const std::vector<std::uint32_t> reached = spread(first, beyond, turns);
    const auto turning = static_cast<std::size_t>(
        std::ranges::count_if(reached, [&](std::uint32_t face) { return turns[face] == Turn::turns; }));
    if (turning == 0) continue;
    // The minority is considered wrong.
    const Turn wrong = 2 * turning <= reached.size() ? Turn::turns : Turn::stays;
    for (const std::uint32_t face : reached) {
      if (turns[face] != wrong) continue;
      std::ranges::reverse(mesh.faces[face]);
      numbers.insert(numbered.face_numbers[face]);
    }
  }
  if (numbers.empty()) return {};
  return {static_cast<std::uint32_t>(numbers.size()), *numbers.begin()};
}

}  // namespace csgsim::solids
