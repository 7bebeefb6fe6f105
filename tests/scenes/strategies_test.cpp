#include <doctest/doctest.h>

#include "tests/scenes/scene_file.h"

using namespace csgsim;

TEST_CASE("every scene is the same picture by every strategy, with all its effects") {
  for (const testing::SceneFile& file : testing::scene_files()) {
    CAPTURE(file.name);
    const observe::Frame first = testing::draw(testing::compile_scene(file, 32, 32).compiled.program);
    for (const emit::Strategy strategy : emit::strategies) {
      if (strategy == emit::Strategy::automatic) continue;
      CAPTURE(emit::name_of(strategy));
      emit::Options options;
      options.strategy = strategy;
      const observe::Frame frame = testing::draw(testing::compile_scene(file, 32, 32, {}, options).compiled.program);
      CHECK(frame.depth == first.depth);
      CHECK(frame.owner == first.owner);
      CHECK(frame.colour == first.colour);
    }
  }
}
