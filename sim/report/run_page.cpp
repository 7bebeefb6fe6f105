#include "sim/report/run_page.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "sim/observe/pictures.h"
#include "sim/observe/primitive_costs.h"
#include "sim/report/pictures.h"
#include "sim/report/run_counts.h"
#include "sim/report/stories.h"

namespace csgsim::report {

namespace {

/// Maximum number of rows in the table of primitives; the caption mentions a cut.
constexpr std::size_t max_rows = 1000;

/// Sum of the clocks in the accounts of purposes, primitives and effects, including the final latency.
double whole_clocks(const Json& data) {
  double whole = 0;
  for (const Json& purpose : data["by_purpose"]) whole += purpose["clocks"].get<double>();
  return whole;
}

/// The counts that the data contain, one row each.
Table summary(const Json& data) {
  Table table{"Counts of the frame", {"count", "value"}, {}};
  for (const auto& [name, at] : run_counts) {
    if (const Cell value = cell(data, at); !value.at.empty()) table.rows.push_back({{name}, value});
  }
  return table;
}

Table account_of(const Json& data, const std::string& at, const char* caption, const char* what) {
  const double whole = whole_clocks(data);
  Table table{caption, {what, "clocks", "share", "instructions", "pixel operations", "of these enabled"}, {}};
  const Json& account = data.at(Json::json_pointer(at));
  for (const auto& [name, cost] : account.items()) {
    const std::string here = child_pointer(at, name);
    table.rows.push_back({{name},
                          cell(data, here + "/clocks"),
                          share(cost["clocks"], whole),
                          cell(data, here + "/instructions"),
                          cell(data, here + "/pixel_operations/total"),
                          cell(data, here + "/pixel_operations/enabled")});
  }
  return table;
}

/// One row per unit of the machine and activity with any clocks.
Table parts_of_machine(const Json& data) {
  Table table{"Units of the machine by activity", {"unit", "activity", "clocks", "share"}, {}};
  for (const auto& [part, activities] : data["account"]["parts"].items()) {
    double whole = 0;
    for (const Json& clocks : activities) whole += clocks.get<double>();
    for (const auto& [activity, clocks] : activities.items()) {
      if (clocks == 0) continue;
      std::string words = activity;
      std::replace(words.begin(), words.end(), '_', ' ');
      table.rows.push_back({{part},
                            {words},
                            cell(data, child_pointer(child_pointer("/account/parts", part), activity)),
                            share(clocks, whole)});
    }
  }
  return table;
}

Section clocks_section(const Json& data) {
  Section section{"Where the clocks go", {}};
  section.parts.emplace_back(account_of(data, "/by_purpose", "Clocks by purpose of instructions", "purpose"));
  if (data["by_effect"].size() > 2)
    section.parts.emplace_back(account_of(data, "/by_effect", "Clocks by effect", "effect"));
  if (data.contains("account") && data["account"].contains("parts")) section.parts.emplace_back(parts_of_machine(data));
  return section;
}

/// Splits `cylinder@9:9` into kind and place.
std::pair<std::string, std::string> kind_and_place(const std::string& name) {
  const std::size_t at = name.rfind('@');
  return at == std::string::npos ? std::pair{name, std::string()} : std::pair{name.substr(0, at), name.substr(at + 1)};
}

OwnerPicture owner_picture(const Json& data, const observe::Frame& frame, const isa::Program& program) {
  const observe::Frame of_primitives = observe::with_primitive_owners(frame, *program.facts);
  const Json& primitives = data["by_primitive"];
  OwnerPicture owners{
      picture_of(frame, program, "", "Picture drawn by the machine"),
      owners_of(of_primitives, "Visible primitives, one colour each",
                "The same view with one colour per primitive; the table of primitives lists their costs"),
      of_primitives.owner,
      primitives_by_cost(data),
      {"Primitives, most expensive first",
       {"primitive", "line:column", "clocks", "share", "pixels seen", "pieces", "instructions"},
       {}}};
  if (owners.primitive.size() > max_rows) {
    owners.prices.caption =
        "The " + grouped(max_rows) + " most expensive of " + grouped(primitives.size()) + " primitives";
    owners.primitive.resize(max_rows);
  }
  const std::vector<std::uint64_t> pixels = observe::visible_pixel_counts(frame, program);
  const double whole = whole_clocks(data);
  for (const std::uint32_t i : owners.primitive) {
    const std::string at = "/by_primitive/" + std::to_string(i);
    const auto [kind, place] = kind_and_place(primitives[i]["name"].get<std::string>());
    owners.prices.rows.push_back({{"p" + std::to_string(i) + " " + kind},
                                  {place},
                                  cell(data, at + "/clocks"),
                                  share(primitives[i]["clocks"], whole),
                                  {pixels[i]},
                                  cell(data, at + "/pieces"),
                                  cell(data, at + "/instructions")});
  }
  return owners;
}

/// The drawing, with histories of the background and of the primitives in the order of their table.
Drawing drawing_with_stories(const OwnerPicture& owners, const story::Subject& subject,
                             const machines::Machine& machine, const Context& context) {
  Drawing drawing = record_drawing(subject.program, machine);
  drawing.explain = context.explain;
  std::vector<std::uint32_t> owners_with_story{observe::no_owner};
  owners_with_story.insert(owners_with_story.end(), owners.primitive.begin(), owners.primitive.end());
  add_stories(subject, machine, central_pixels(owners.owner, owners.picture.width, owners_with_story), drawing);
  return drawing;
}

/// The sentences in the stats: the bound and the advice.
std::vector<Part> sentences_of_stats(const Json& data) {
  std::vector<Part> parts = sentences(data, "/bound_by");
  for (Part& knob : sentences(data, "/knobs")) parts.push_back(std::move(knob));
  return parts;
}

Table most_expensive_table(const Json& data) {
  Table table{
      "Most expensive primitives", {"primitive", "line:column", "clocks", "share", "pieces", "half-spaces"}, {}};
  const Json& rows = data["dearest"];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string at = "/dearest/" + std::to_string(i);
    table.rows.push_back({cell(data, at + "/name"), cell(data, at + "/source"), cell(data, at + "/clocks"),
                          cell(data, at + "/share", Show::share), cell(data, at + "/pieces"),
                          cell(data, at + "/halfspaces")});
  }
  return table;
}

}  // namespace

Page run_page(const Json& stats, const observe::Frame& frame, const isa::Program& program,
              const machines::Machine& machine, const Context& context, const story::HalfspaceFinder* model) {
  Page page;
  page.data = without_wall_times(stats);
  const Json& data = page.data;
  page.command = context.command;
  page.title = std::filesystem::path(program.facts->model.file).filename().native() + " on " + machine.name;
  Section picture{"Picture", sentences_of_stats(data)};
  OwnerPicture owners = owner_picture(data, frame, program);
  Drawing drawing = drawing_with_stories(owners, {program, model}, machine, context);
  picture.parts.emplace_back(std::move(owners));
  page.sections.push_back(std::move(picture));
  page.sections.push_back({"Drawing", {std::move(drawing)}});
  page.sections.push_back({"Counts", {summary(data)}});
  page.sections.push_back(clocks_section(data));
  if (data.contains("dearest") && data["dearest"].is_array())
    page.sections.back().parts.emplace_back(most_expensive_table(data));
  page.sections.push_back(configuration_section(data, context));
  return page;
}

}  // namespace csgsim::report
