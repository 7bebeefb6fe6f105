#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <string>

#include "tests/unit/software/scenes.h"

namespace csgsim::testing {

/// Whether `fault(scene, seed)` is empty for random scenes, eight per case. The tally counts the scenes, and as refused
/// those that are invalid or for which `wanted(scene)` is false.
template <class Tally, class Wanted, class Fault>
bool holds_in_random_scenes(Tally& tally, const Wanted& wanted, const Fault& fault) {
  return rc::check([&] {
    const auto first = *rc::gen::arbitrary<std::uint64_t>();
    for (std::uint64_t seed = first; seed != first + 8; ++seed) {
      const std::optional<Scene> scene = random_scene(seed);
      ++tally.scenes;
      if (!scene || !wanted(*scene)) {
        ++tally.refused;
        continue;
      }
      const std::string found = fault(*scene, seed);
      if (!found.empty()) RC_FAIL(fmt::format("seed {}: {}", seed, found));
    }
  });
}

inline bool is_faceted(const Scene& scene) { return scene.geometry.is_faceted(); }

}  // namespace csgsim::testing
