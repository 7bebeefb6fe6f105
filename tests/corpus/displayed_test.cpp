#include "places.h"
#include "sim/software/display/rows.h"
#include "sim/software/facets/facets.h"
#include "sim/software/space/directory.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tree/tree.h"
#include "tests/corpus/reference.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 40;
constexpr std::uint32_t height = 32;

/// Models with more than 12,000 planes.
const std::set<std::string> take_long{"bolt_and_nut", "vase"};

/// A model drawn by a machine.
struct Drawn {
  testing::Compiled compiled;
  observe::Frame frame;
};

Drawn drawn(const std::string& path, view::Projection projection) {
  testing::Setup setup;
  setup.sampling.width = width;
  setup.sampling.height = height;
  setup.memory_bits = 256;
  Drawn drawn{testing::compile_default_view(path, setup, projection), {}};
  drawn.frame = testing::draw(drawn.compiled.program);
  return drawn;
}

/// Calls `use(name, drawn)` for all models with facets; in short runs for every fourth.
template <class Use>
void for_each_model(const std::map<std::string, std::string>& models, const Use& use) {
  const auto refused = testing::refused_models();
  // One projection per model suffices; it alternates in alphabetical order.
  std::size_t number = 0;
  for (const auto& model : models) {
    const std::string& name = model.first;
    const auto projection = ++number % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective;
    if (refused.contains(name) || take_long.contains(name)) continue;
    if (number % testing::cases<std::size_t>(1, 4) != 0) continue;
    CAPTURE(name);
    const Drawn one = drawn(model.second, projection);
    REQUIRE(one.compiled.scene.is_faceted());
    use(name, one);
  }
}

std::map<std::string, std::string> models_of_pages() {
  std::map<std::string, std::string> models;
  for (const auto& entry : fs::directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / "tests/models")) {
    if (entry.path().extension() == ".csg") models.emplace(entry.path().stem().string(), entry.path().string());
  }
  return models;
}

/// Number of pixels at which a picture differs from the machine's.
template <class SeenAt>
std::uint64_t wrong_pixels(const observe::Frame& frame, const SeenAt& seen_at) {
  std::uint64_t wrong = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const software::VisibleSurface seen = seen_at(i);
    wrong += seen.depth == frame.depth[i] && seen.owner == frame.owner[i] ? 0U : 1U;
  }
  return wrong;
}

/// Checks exact methods, and that list priority reports each pixel that it draws wrong. Returns a line for each of its
/// pictures with wrong pixels.
std::string wrong_pictures(const std::string& name, const Drawn& drawn) {
  const testing::Compiled& model = drawn.compiled;
  const software::Facets facets = software::facets_of(model.tree, model.scene);
  const software::Tree tree = software::make_tree(model.tree, software::Shape::balanced);
  // One directory per model, chosen by the length of its name.
  const std::vector<std::string> directories = software::halving_directories();
  const std::string& directory = directories[name.size() % directories.size()];
  const software::DisplaySubject subject{model.tree, model.scene, model.view, tree, facets, 24, directory};
  std::string lines;
  for (const software::DisplayRow* const row : software::display_methods()) {
    CAPTURE(row->name);
    const software::Displayed displayed = row->run(subject, !row->is_exact);
    const std::uint64_t wrong =
        wrong_pixels(drawn.frame, [&](std::size_t pixel) { return displayed.picture.seen[pixel]; });
    const software::Faults& faults = displayed.faults;
    CHECK(wrong == faults.all());
    if (wrong == 0) continue;
    lines += fmt::format("{} {} {}: {} for depth bits, {} coincident, {} three-way, {} for order\n", name, row->name,
                         subject.directory, faults.depth_bits, faults.coincident, faults.three_way, faults.order);
  }
  return lines;
}

/// The contents of tests/corpus/displayed.txt, in short runs for those models only.
std::string listed(const std::set<std::string>& models) {
  std::ifstream file(fs::path(CSGSIM_SOURCE_DIR) / "tests/corpus/displayed.txt");
  std::string lines;
  for (std::string line; std::getline(file, line);)
    if (!line.starts_with('#') && (testing::draws_usual_cases() || models.contains(line.substr(0, line.find(' ')))))
      lines += line + "\n";
  return lines;
}

void check_traced(const Drawn& drawn) {
  const testing::Compiled& model = drawn.compiled;
  const software::Tree tree = software::make_tree(model.tree, software::Shape::balanced);
  const software::TraceScene scene(model.tree, model.scene, model.view, tree);
  bool has_item_buffer = false;
  for (const software::DirectoryRow* const row : software::directories()) {
    CAPTURE(row->name);
    const std::unique_ptr<software::Directory> directory = row->make(scene.shapes(), {});
    software::TraceOptions options;
    options.item_pass = has_item_buffer ? software::ItemPass::depth_lists : software::ItemPass::none;
    has_item_buffer = !has_item_buffer;
    const software::Traced traced = software::trace(scene, *directory, options, false);
    CHECK(wrong_pixels(drawn.frame, [&](std::size_t pixel) { return traced.pixels[pixel].seen; }) == 0);
  }
}

}  // namespace

TEST_CASE("software facet methods draw models as the machine does except for listed pixels") {
  std::string lines;
  std::set<std::string> displayed;
  for (const auto& models : {testing::corpus_models(), models_of_pages()}) {
    for_each_model(models, [&](const std::string& name, const Drawn& drawn) {
      lines += wrong_pictures(name, drawn);
      displayed.insert(name);
    });
  }
  CHECK(lines == listed(displayed));
}
TEST_CASE("software ray tracing draws the corpus as the machine does") {
  for_each_model(testing::corpus_models(),
                 [&](const std::string& /*name*/, const Drawn& drawn) { check_traced(drawn); });
}
TEST_CASE("software ray tracing draws the models of the pages as the machine does") {
  for_each_model(models_of_pages(), [&](const std::string& /*name*/, const Drawn& drawn) { check_traced(drawn); });
}
