#include "host/setup/faceting.h"

#include "host/effects/rows.h"
#include "host/read/read.h"
#include "hw/base/messages.h"
#include "hw/kinds/load.h"
#include "tests/support/error_of.h"
#include "tests/support/test.h"

using namespace csgsim;
using emit::Curves;

namespace {

const model::Tree tree = read::read_csg_text("sphere(r = 5); cylinder(h = 4, r1 = 3, r2 = 2);", "m.csg");

setup::Choices choices_of(Curves curves) {
  setup::Choices choices;
  choices.sampling.width = 64;
  choices.sampling.height = 48;
  choices.camera.given = view::Camera{{0, -50, 0}, {0, 0, 0}};
  choices.faceting.curves = curves;
  choices.options.effects = effects::all();
  return choices;
}

machines::Machine machine_named(const std::string& name) {
  machines::Machine machine = kinds::load(name);
  machines::set_picture_size(machine, {64, 48});
  return machine;
}

}  // namespace

TEST_CASE("auto draws facets on a machine that evaluates linear expressions, else curves") {
  const setup::Choices choices = choices_of(Curves::automatic);
  CHECK(setup::faceting_for(choices, machine_named("pixel-planes-4"), tree) == facet::Faceting{});
  CHECK(setup::faceting_for(choices, machine_named("pixel-powers"), tree).exact_curves);
}

TEST_CASE("exact curves are refused on a machine that evaluates linear expressions") {
  const machines::Machine linear = machine_named("pixel-planes-4");
  const std::string error =
      testing::error_of([&] { static_cast<void>(setup::faceting_for(choices_of(Curves::exact), linear, tree)); });
  CHECK(error.ends_with(", or allow facets with --curves auto"));
}

TEST_CASE("fast spheres warn and name the first solid that is drawn as facets") {
  const CollectedLines messages;
  const facet::Faceting faceting = setup::faceting_for(choices_of(Curves::fast), machine_named("pixel-planes-4"), tree);
  CHECK(faceting.fast_spheres);
  REQUIRE(messages.lines().size() == 1);
  CHECK(messages.lines().front().starts_with("m.csg:1:16: warning: --curves fast draws spheres"));
  CHECK(messages.lines().front().ends_with("this solid is not a sphere and is drawn as facets"));
}

TEST_CASE("a tolerance in model units does not depend on the camera, one in pixels does") {
  const machines::Machine linear = machine_named("pixel-planes-4");
  setup::Choices choices = choices_of(Curves::facets);
  choices.faceting.tolerance = setup::Tolerance{0.25, false};
  CHECK_FALSE(setup::depends_on_camera(choices.faceting, linear));
  CHECK(setup::faceting_for(choices, linear, tree).tolerance == 0.25);
  choices.faceting.tolerance = setup::Tolerance{0.5, true};
  CHECK(setup::depends_on_camera(choices.faceting, linear));
  const view::Camera near{{0, -50, 0}, {0, 0, 0}};
  const view::Camera far{{0, -100, 0}, {0, 0, 0}};
  const double ratio = *setup::faceting_at(far, choices, linear, tree).tolerance /
                       *setup::faceting_at(near, choices, linear, tree).tolerance;
  CHECK(ratio == doctest::Approx(2));
}
