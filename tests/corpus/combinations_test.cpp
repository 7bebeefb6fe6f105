#include "host/read/read.h"
#include "hw/isa/program.h"
#include "hw/kinds/load.h"
#include "tests/corpus/reference.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Machines that divide the picture themselves, and others that leave it to the host. Squares are so small that each
/// picture has several.
constexpr std::array<std::string_view, 7> drawing_machines{
    "pixel-planes-4",
    "scan-line",
    "pixel-square",
    "pixel-square+divider.kind=host",
    "pixel-planes-5+array.width=32+array.height=32",
    "pixel-planes-5+array.width=32+array.height=32+divider.kind=corners",
    "multi-processor"};

bool divides(std::string_view machine) {
  if (machine.find("divider.kind=") != machine.npos) return machine.ends_with("divider.kind=corners");
  return machine == "pixel-square" || machine == "multi-processor";
}

/// The machine with the maximum of memory, and a divider large enough for large models.
machines::Machine load_large(std::string_view name) {
  const bool has_room = divides(name) && name != "multi-processor";
  constexpr std::string_view room = "+divider.store=4194304+divider.nodes=65536+divider.halfspaces=1048576";
  machines::Machine machine = kinds::load(std::string(name) + std::string(has_room ? room : ""));
  machine.array.memory_bits = isa::max_memory_bits;
  return machine;
}

/// A model as seen by one camera.
struct Seen {
  const model::Tree& tree;
  facet::Geometry scene;
  view::View view;
};

observe::Frame draw_with(const Seen& seen, std::string_view name, emit::Strategy strategy) {
  machines::Machine machine = load_large(name);
  machines::set_picture_size(machine, {seen.view.sampling.width, seen.view.sampling.height});
  emit::Options options;
  options.strategy = strategy;
  options.stack_bits = emit::min_stack_bits + 1;
  return testing::draw_on(machine, emit::compile(seen.tree, seen.scene, seen.view, machine, options));
}

/// Whether a machine supports a strategy: one that divides supports only the stack, which is also its `auto`.
bool supports(std::string_view machine, emit::Strategy strategy) {
  return !divides(machine) || strategy == emit::Strategy::stack || strategy == emit::Strategy::automatic;
}

/// Whether the machine may give that reason with the strategy: it lacks the strategy, or its limits are exceeded.
bool may_reject(std::string_view machine, emit::Strategy strategy, const std::string& said) {
  const auto says = [&](std::string_view words) { return said.find(words) != said.npos; };
  if (!supports(machine, strategy)) return says("divides the model itself");
  if (strategy == emit::Strategy::products) return says("products");
  const bool may_take_much = strategy == emit::Strategy::parallel || strategy == emit::Strategy::stored;
  return may_take_much && says("memory bits a pixel");
}

void compare(const Seen& seen, const observe::Frame& first, std::string_view machine, emit::Strategy strategy) {
  CAPTURE(machine);
  CAPTURE(emit::name_of(strategy));
  try {
    const observe::Frame frame = draw_with(seen, machine, strategy);
    CHECK(frame.depth == first.depth);
    CHECK(frame.owner == first.owner);
    CHECK(frame.colour == first.colour);
    CHECK(supports(machine, strategy));
  } catch (const InputError& error) {
    const std::string said = error.what();
    CHECK_MESSAGE(may_reject(machine, strategy, said), said);
    if (supports(machine, strategy)) MESSAGE("refused: " << said);
  }
}

void compare_all(const std::string& model, const std::string& path) {
  CAPTURE(model);
  const model::Tree tree = read::read_csg_file(path);
  const facet::Geometry scene = facet::make_geometry(tree);
  for (const testing::Reference& reference : testing::read_references(model)) {
    CAPTURE(static_cast<int>(reference.camera.projection));
    view::Sampling sampling;
    sampling.width = reference.size;
    sampling.height = reference.size;
    const Seen seen{tree, scene, view::make_view(scene, tree, reference.camera, sampling)};
    const observe::Frame first = draw_with(seen, drawing_machines.front(), emit::Strategy::stack);
    const auto is_other = [&](std::uint32_t owner) { return owner != first.owner.front(); };
    REQUIRE(std::any_of(first.owner.begin(), first.owner.end(), is_other));
    for (const std::string_view machine : drawing_machines)
      for (const emit::Strategy strategy : emit::strategies) compare(seen, first, machine, strategy);
  }
}

}  // namespace

TEST_CASE("every machine and strategy draws the picture of Pixel-planes 4 with the stack") {
  const auto refused = testing::refused_models();
  const auto models = testing::corpus_models();
  const char* name = std::getenv("CSGSIM_CORPUS_MODEL");  // a single model; all if not set
  if (name != nullptr) REQUIRE(models.contains(name));
  for (const auto& [model, path] : models) {
    if (refused.contains(model) || (name != nullptr && model != name)) continue;
    compare_all(model, path);
  }
}
