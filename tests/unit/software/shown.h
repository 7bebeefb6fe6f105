#pragma once

#include <cstddef>
#include <string_view>

#include "sim/software/display/rows.h"
#include "sim/software/facets/facets.h"
#include "sim/software/tree/tree.h"
#include "tests/unit/software/scenes.h"

namespace csgsim::testing {

/// A scene and the inputs of its display methods. Keeps a reference.
struct Shown {
  const Scene& scene;
  software::Tree tree;
  software::Facets facets;

  explicit Shown(const Scene& of)
      : scene(of),
        tree(software::make_tree(of.tree, software::Shape::balanced)),
        facets(software::facets_of(of.tree, of.geometry)) {}

  [[nodiscard]] software::Displayed by(const software::DisplayRow& row, bool counts, std::size_t bucket_size = 24,
                                       std::string_view directory = "excell") const {
    return row.run({scene.tree, scene.geometry, scene.view, tree, facets, bucket_size, directory}, counts);
  }
  [[nodiscard]] software::Displayed by(const char* method, bool counts = true, std::size_t bucket_size = 24,
                                       std::string_view directory = "excell") const {
    return by(software::display_method(method), counts, bucket_size, directory);
  }
};

}  // namespace csgsim::testing
