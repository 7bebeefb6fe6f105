#include "tests/scenes/scene_file.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("every scene gives the same picture with the strategies stack and bits and stored") {
  const std::vector<testing::SceneFile> files = testing::scene_files();
  const auto step = testing::cases<std::size_t>(1, 4);
  for (std::size_t at = 0; at < files.size(); at += step) {
    const testing::SceneFile& file = files[at];
    CAPTURE(file.name);
    const observe::Frame first = testing::draw(testing::compile_scene(file, 32, 32).compiled.program);
    for (const emit::Strategy strategy : {emit::Strategy::bits, emit::Strategy::stored}) {
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
