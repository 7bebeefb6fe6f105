#include "sim/report/two_page.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <utility>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "sim/observe/pictures.h"
#include "sim/report/drawing.h"
#include "sim/report/run_counts.h"
#include "sim/report/stories.h"

namespace csgsim::report {

namespace {

/// The ratio of B to A, if both exist and A is not 0.
Cell ratio(const Cell& a, const Cell& b) {
  if (!a.value.is_number() || !b.value.is_number() || a.value.get<double>() == 0) return {};
  return {b.value.get<double>() / a.value.get<double>()};
}

Row row_of(const std::string& name, const Json& data, const std::string& at) {
  Cell a = cell(data, "/a" + at);
  Cell b = cell(data, "/b" + at);
  Cell of_both = ratio(a, b);
  return {{name}, std::move(a), std::move(b), std::move(of_both)};
}

Table counts(const Json& data) {
  Table table{"Counts of both frames", {"count", "A", "B", "B / A"}, {}};
  for (const auto& [name, at] : run_counts) {
    Row row = row_of(name, data, at);
    if (!row[1].value.is_null() || !row[2].value.is_null()) table.rows.push_back(std::move(row));
  }
  return table;
}

/// One row per key of the accounts: the keys of A, then those that only B has.
Table account(const Json& data, const std::string& at, const char* caption, const char* what) {
  Table table{caption, {what, "A, clocks", "B, clocks", "B / A"}, {}};
  const auto add = [&](const char* side, const char* other, bool only) {
    const Json::json_pointer pointer(side + at);
    if (!data.contains(pointer)) return;
    for (const auto& [name, cost] : data.at(pointer).items()) {
      const std::string key = child_pointer(at, name);
      if (!only || !data.contains(Json::json_pointer(other + key)))
        table.rows.push_back(row_of(name, data, key + "/clocks"));
    }
  };
  add("/a", "/b", false);
  add("/b", "/a", true);
  return table;
}

Section pictures_section(const ShownRun& a, const ShownRun& b, Difference difference,
                         const std::vector<std::string>& sentences) {
  Section section{"Pictures", {}};
  section.parts.emplace_back(Paragraph{"A: " + a.name});
  section.parts.emplace_back(Paragraph{"B: " + b.name});
  for (const std::string& sentence : sentences) section.parts.emplace_back(Paragraph{sentence});
  section.parts.emplace_back(
      Gallery{{picture_of(a.drawn.frame, a.drawn.program, "A", "Picture drawn by A"),
               picture_of(b.drawn.frame, b.drawn.program, "B", "Picture drawn by B"), std::move(difference.picture)}});
  return section;
}

std::string title(const isa::Program& a, const isa::Program& b) {
  const auto file = [](const isa::Program& program) {
    return std::filesystem::path(program.facts->model.file).filename().native();
  };
  return file(a) == file(b) ? "Two runs of " + file(a) : "Runs of " + file(a) + " and " + file(b);
}

std::vector<std::size_t> pixels_of_stories(const ShownRun& a, const FirstDifference& first,
                                           const Difference& difference) {
  std::vector<std::size_t> pixels;
  const auto add_central = [&](std::span<const std::uint32_t> owner, std::span<const std::uint32_t> owners) {
    const std::vector<std::size_t> central = central_pixels(owner, a.drawn.frame.width, owners);
    pixels.insert(pixels.end(), central.begin(), central.end());
  };
  if (first.pixel) pixels.push_back(*first.pixel);
  if (difference.pixels > 0) pixels.push_back(difference.first);
  add_central(difference.differs, std::array{std::uint32_t{1}});
  std::vector<std::uint32_t> owners = primitives_by_cost(a.stats);
  owners.insert(owners.begin(), observe::no_owner);
  add_central(observe::with_primitive_owners(a.drawn.frame, *a.drawn.program.facts).owner, owners);
  return pixels;
}

Drawing drawing_of(const ShownRun& run, std::span<const std::size_t> pixels) {
  Drawing drawing = record_drawing(run.drawn.program, run.machine);
  drawing.explain = run.explain;
  add_stories({run.drawn.program}, run.machine, pixels, drawing);
  return drawing;
}

}  // namespace

Page two_page(const ShownRun& a, const ShownRun& b, const FirstDifference& first, const Context& context) {
  Difference difference =
      difference_of(a.drawn, b.drawn, "Pixels that differ in colour or primitive, over A in grey", "");
  difference.picture.alt =
      grouped(difference.pixels) + (difference.pixels == 1 ? " pixel differs" : " pixels differ") + " between A and B";
  Page page;
  page.data = {{"a", without_wall_times(a.stats)}, {"b", without_wall_times(b.stats)}};
  page.data["difference"] = {{"pixels", difference.pixels}, {"first", nullptr}};
  const std::size_t width = a.drawn.frame.width;
  if (difference.pixels > 0) page.data["difference"]["first"] = {difference.first % width, difference.first / width};
  page.command = context.command;
  page.title = title(a.drawn.program, b.drawn.program);
  const std::vector<std::size_t> pixels = pixels_of_stories(a, first, difference);
  page.sections.push_back(pictures_section(a, b, std::move(difference), first.sentences));
  page.sections.push_back({"Counts", {counts(page.data)}});
  page.sections.push_back({"Where the clocks go",
                           {account(page.data, "/by_purpose", "Clocks by purpose of instructions", "purpose"),
                            account(page.data, "/by_effect", "Clocks by effect", "effect")}});
  page.sections.push_back({"Drawing of A", {drawing_of(a, pixels)}});
  page.sections.push_back({"Drawing of B", {drawing_of(b, pixels)}});
  page.sections.push_back(configuration_section(page.data, context));
  return page;
}

}  // namespace csgsim::report
