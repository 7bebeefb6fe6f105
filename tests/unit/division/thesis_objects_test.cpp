#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/division/agreement.h"

using namespace csgsim;

namespace {

void check_objects(view::Projection projection, machines::Size square, emit::Colouring colouring) {
  for (const testing::ThesisObject& object : testing::thesis_objects(projection)) {
    CAPTURE(object.name);
    testing::DivisionCase how;
    how.setup = testing::squares_of(object.camera, {}, square, colouring);
    const testing::ForDivider made = testing::compile_file_for_divider(testing::model_path(object.name), how.setup);
    division::Counts done;
    CHECK(testing::difference(made, how, done) == "");
  }
}

}  // namespace

TEST_CASE("the divider matches the host on the thesis's objects in 16 x 16 squares") {
  check_objects(view::Projection::orthographic, {16, 16}, emit::Colouring::rebroadcast);
}

TEST_CASE("the divider matches the host on the thesis's objects in 128 x 128 squares") {
  check_objects(view::Projection::orthographic, {128, 128}, emit::Colouring::rebroadcast);
  check_objects(view::Projection::perspective, {128, 128}, emit::Colouring::field);
}
