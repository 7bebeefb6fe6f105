#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/emit/compile.h"
#include "host/emit/display_model.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/division/divide.h"
#include "hw/division/encoding.h"
#include "hw/division/groups.h"
#include "hw/isa/wire.h"
#include "hw/kinds/load.h"
#include "hw/machines/clocks.h"
#include "hw/machines/machine.h"
#include "hw/machines/regions.h"
#include "hw/pixel_square/figures.h"
#include "tests/support/drawing.h"
#include "tests/unit/division/hand_models.h"

// Work of the pixel-square machine's divider for the thesis's objects, at one level and two, and the savings of the
// host's further prunings for its renderer: docs/machines/pixel-square.md.

using namespace csgsim;

namespace {

constexpr std::uint32_t group_side = 2;
constexpr std::uint64_t unlimited = ~std::uint64_t{0};

struct Subject {
  std::string name;
  model::Tree tree;
  facet::Geometry scene;
  view::View view;
  machines::Machine machine;
};

Subject subject(const testing::ThesisObject& object, machines::Size picture, machines::Size square,
                const std::optional<double>& tolerance) {
  model::Tree tree = read::read_csg_file(testing::model_path(object.name));
  facet::Geometry scene = facet::make_geometry(tree, {tolerance, std::nullopt});
  view::Sampling sampling;
  sampling.width = picture.width;
  sampling.height = picture.height;
  view::View view = view::make_view(scene, tree, object.camera, sampling);
  machines::Machine machine = kinds::load("pixel-square");
  machines::set_picture_size(machine, picture);
  machine.array.width = square.width;
  machine.array.height = square.height;
  // Compiles with prunings other than the divider's.
  machines::kind_figures<pixel_square::Figures>(machine).divider = pixel_square::DividerKind::host;
  return {object.name, std::move(tree), std::move(scene), std::move(view), machine};
}

struct Work {
  division::Counts squares;
  division::Counts groups;
  std::uint64_t most_entries = 0;
  std::vector<std::uint64_t> entries;
  division::PeakUsage at_hand;
  std::uint64_t most_words = 0;  ///< 32-bit words of the commands of the largest square

  void take(const isa::Region& region, const division::SquareDivision& square) {
    squares += square.counts();
    const division::PeakUsage most = square.peak_usage();
    at_hand.halfspaces = std::max(at_hand.halfspaces, most.halfspaces);
    at_hand.nodes = std::max(at_hand.nodes, most.nodes);
    constexpr std::uint32_t width = 32;
    std::uint64_t words = isa::wire_words(isa::SegmentStart{region}, width) + isa::wire_words(isa::SegmentEnd{}, width);
    for (const isa::Instruction& instruction : square.instructions) words += isa::wire_words(instruction, width);
    most_words = std::max(most_words, words);
  }

  /// Clocks of a divider that tests a box, a cell or a node per clock and a half-space in four.
  [[nodiscard]] std::uint64_t tests() const {
    division::Counts all = squares;
    all += groups;
    return all.boxes + 4 * all.halfspaces + all.cells + all.nodes;
  }
};

Work one_level(const Subject& subject, testing::ModelDivider& divider) {
  Work work;
  for (const isa::Region& square : machines::regions(subject.machine)) work.take(square, divider.divide(square));
  return work;
}

Work two_levels(const Subject& subject, testing::ModelDivider& divider, std::uint64_t list_entries,
                std::uint32_t side = group_side) {
  Work work;
  const std::vector<isa::Region> squares = machines::regions(subject.machine);
  const machines::Size picture = subject.machine.picture;
  for (const division::Group& group :
       division::group_squares(squares, {picture.width, picture.height, 0}, subject.machine.array, side, side)) {
    std::vector<isa::Region> inside;
    for (const std::size_t square : group.squares) inside.push_back(squares[square]);
    const division::DividedGroup divided = divider.divide_group(group.region, inside, list_entries);
    work.groups += divided.group;
    for (std::size_t i = 0; i < inside.size(); ++i) work.take(inside[i], divided.squares[i]);
    work.entries.push_back(divided.entries);
    work.most_entries = std::max(work.most_entries, divided.entries);
  }
  return work;
}

void print(const char* what, const division::Counts& counts) {
  fmt::print("  {:<22}{:>10}{:>12}{:>10}{:>10}{:>14}\n", what, counts.boxes, counts.halfspaces, counts.cells,
             counts.nodes, counts.instructions);
}

struct Compiled {
  std::uint64_t instructions = 0;
  std::uint64_t clocks = 0;  ///< clocks of the renderers' instructions
};

Compiled compiled(const Subject& subject, const csg::Pruning& pruning) {
  emit::Options options;
  options.pruning = pruning;
  Compiled total;
  const isa::Program program = emit::compile(subject.tree, subject.scene, subject.view, subject.machine, options);
  for (const isa::Segment& segment : program.segments) {
    total.instructions += segment.instructions.size();
    total.clocks += machines::clocks(segment.instructions, subject.machine);
  }
  return total;
}

void print_prunings(const Subject& subject) {
  const Compiled divider = compiled(subject, csg::Pruning::divider());
  const auto row = [&](const char* what, const Compiled& with) {
    fmt::print("  {:<34}{:>10} instructions{:>12} clocks  {:.3f}\n", what, with.instructions, with.clocks,
               static_cast<double>(with.clocks) / static_cast<double>(divider.clocks));
  };
  row("the divider's prunings", divider);
  const auto changed = [&](bool csg::Pruning::*switched, bool on) {
    csg::Pruning pruning = csg::Pruning::divider();
    pruning.*switched = on;
    return compiled(subject, pruning);
  };
  row("with space", changed(&csg::Pruning::space, true));
  row("with separation", changed(&csg::Pruning::separation, true));
  row("with hidden", changed(&csg::Pruning::hidden, true));
  row("with near", changed(&csg::Pruning::near, true));
  row("without cells", changed(&csg::Pruning::pixels, false));
  row("without sets", changed(&csg::Pruning::sets, false));
  row("the host's prunings", compiled(subject, {}));
  csg::Pruning all;
  all.pixels = true;
  row("the host's prunings and cells", compiled(subject, all));
}

/// Primitives by the subtree of unions that contains them, for subtrees with several primitives.
std::vector<std::vector<std::uint32_t>> unions_of(const csg::PositiveTree& tree, bool complemented) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_top;
  const auto is_union = [&](std::uint32_t node) {
    return node != model::no_index && tree.nodes[node].op == csg::PositiveOperator::unite;
  };
  for (std::uint32_t primitive = 0; primitive < tree.leaf_of.size(); ++primitive) {
    std::uint32_t top = tree.leaf_of[primitive];
    if (tree.nodes[top].complemented != complemented || !is_union(tree.nodes[top].parent)) continue;
    while (is_union(tree.nodes[top].parent)) top = tree.nodes[top].parent;
    by_top[top].push_back(primitive);
  }
  std::vector<std::vector<std::uint32_t>> unions;
  for (const auto& [top, members] : by_top) {
    if (members.size() > 1) unions.push_back(members);
  }
  return unions;
}

/// Possible savings of drawing unions as one primitive (thesis 7.3.2).
void print_unions(const Subject& subject) {
  const csg::PositiveTree tree = csg::make_positive_tree(subject.tree);
  const auto plain = unions_of(tree, false);
  std::set<std::uint32_t> members;
  for (const auto& one : plain) members.insert(one.begin(), one.end());
  fmt::print("  unions of complements: {}; of plain solids: {}, with {} primitives\n", unions_of(tree, true).size(),
             plain.size(), members.size());
  std::uint64_t total = 0;
  std::uint64_t merges = 0;  ///< merges of members without any comparison
  const isa::Program program = emit::compile(subject.tree, subject.scene, subject.view, subject.machine);
  for (const isa::Segment& segment : program.segments) {
    std::map<std::uint32_t, std::uint64_t> merging;
    std::set<std::uint32_t> compared;
    for (const isa::Instruction& one : segment.instructions) {
      const std::uint64_t clocks = machines::clocks(one, subject.machine);
      total += clocks;
      if (one.origin.purpose == isa::Purpose::merge) merging[one.origin.primitive] += clocks;
      if (one.origin.purpose == isa::Purpose::classify) compared.insert(one.origin.primitive);
    }
    for (const auto& [primitive, clocks] : merging) {
      if (members.contains(primitive) && !compared.contains(primitive)) merges += clocks;
    }
  }
  fmt::print("  depth tests and merges of these where they need no comparison: {} of {} clocks, {:.1f} %\n", merges,
             total, 100.0 * static_cast<double>(merges) / static_cast<double>(total));
}

void report(const Subject& subject, bool unions) {
  std::uint64_t halfspaces = 0;
  for (const facet::Convex& solid : subject.scene.solids) halfspaces += solid.halfspaces.size();
  const division::Bits sent = division::encode(
      emit::make_display_model(subject.tree, subject.scene, subject.view, {}, subject.machine.array.memory_bits));
  testing::ModelDivider divider(division::decode(sent));
  const division::DisplayModel& model = divider.model;
  const division::Widths widths = division::widths_of(model);
  const std::vector<isa::Region> squares = machines::regions(subject.machine);
  fmt::print("{}, {} primitives, {} half-spaces, picture {}x{}, squares {}x{}\n", subject.name, model.primitives.size(),
             halfspaces, model.width, model.height, subject.machine.array.width, subject.machine.array.height);
  fmt::print("  model: {} bits, {} words of 32; {} planes of {}, primitives of {}, half-spaces of {}\n", sent.count,
             division::link_words(sent.count, 32), model.planes.size(), widths.plane_record(),
             widths.primitive_record(), widths.halfspace_record());
  fmt::print("  {:<22}{:>10}{:>12}{:>10}{:>10}{:>14}\n", "", "boxes", "half-spaces", "cells", "nodes", "instructions");
  const Work one = one_level(subject, divider);
  print("one level", one.squares);
  Work two = two_levels(subject, divider, unlimited);
  print("two: groups", two.groups);
  print("two: squares", two.squares);
  fmt::print("  tests: {} clocks at one level, {} at two, {:.3f}\n", one.tests(), two.tests(),
             static_cast<double>(two.tests()) / static_cast<double>(one.tests()));
  fmt::print("  tests in groups of 4: {} clocks\n", two_levels(subject, divider, unlimited, 4).tests());
  fmt::print("  at hand: {} half-spaces and {} nodes at one level, {} and {} at two; {} words of commands\n",
             one.at_hand.halfspaces, one.at_hand.nodes, two.at_hand.halfspaces, two.at_hand.nodes, one.most_words);
  std::sort(two.entries.begin(), two.entries.end());
  fmt::print("  a group's list: {} entries in the middle, {} at most\n", two.entries[two.entries.size() / 2],
             two.most_entries);
  for (const std::uint64_t entries : {64U, 256U, 1024U, 4096U}) {
    fmt::print("  with a list of {}: {} clocks\n", entries, two_levels(subject, divider, entries).tests());
  }
  print_prunings(subject);
  if (unions) print_unions(subject);
  fmt::print("\n");
}

}  // namespace

int main() {
  const std::vector<testing::ThesisObject> objects = testing::thesis_objects(view::Projection::orthographic);
  for (std::size_t i = 1; i < objects.size(); ++i) {
    report(subject(objects[i], {512, 512}, {16, 16}, std::nullopt), true);
  }
  for (std::size_t i = 1; i < objects.size(); ++i) {
    report(subject(objects[i], {512, 512}, {128, 128}, std::nullopt), false);
  }
  // Table 7.3 of the thesis: three tolerances, 64 segments of 16 subsegments each.
  for (const double tolerance : {0.11, 0.06, 0.0278}) report(subject(objects[1], {256, 256}, {8, 8}, tolerance), false);
}
