#include "sim/report/run_page.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "sim/observe/dearest.h"
#include "sim/observe/pictures.h"
#include "sim/report/pictures.h"
#include "sim/report/run_counts.h"
#include "sim/report/stories.h"

namespace csgsim::report {

namespace {

/// Rows of the table of primitives; of more the page says so.
constexpr std::size_t most_rows = 1000;

/// The clocks that accounts to purposes, primitives and effects add up to, with the final latency.
double whole_clocks(const Json& data) {
  double whole = 0;
  for (const Json& purpose : data["by_purpose"]) whole += purpose["clocks"].get<double>();
  return whole;
}

/// Whole counts of keys of the data that are there, a row each.
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
    const std::string here = child(at, name);
    table.rows.push_back({{name},
                          cell(data, here + "/clocks"),
                          share(cost["clocks"], whole),
                          cell(data, here + "/instructions"),
                          cell(data, here + "/pixel_operations/total"),
                          cell(data, here + "/pixel_operations/enabled")});
  }
  return table;
}

/// A row a part of the machine and activity that took any clocks.
Table parts_of_machine(const Json& data) {
  Table table{"Each part of the machine, by what it did", {"part", "activity", "clocks", "share"}, {}};
  for (const auto& [part, activities] : data["account"]["parts"].items()) {
    double whole = 0;
    for (const Json& clocks : activities) whole += clocks.get<double>();
    for (const auto& [activity, clocks] : activities.items()) {
      if (clocks == 0) continue;
      std::string words = activity;
      std::replace(words.begin(), words.end(), '_', ' ');
      table.rows.push_back(
          {{part}, {words}, cell(data, child(child("/account/parts", part), activity)), share(clocks, whole)});
    }
  }
  return table;
}

Section clocks_section(const Json& data) {
  Section section{"Where the clocks go", {}};
  section.parts.emplace_back(account_of(data, "/by_purpose", "Clocks by what instructions were for", "purpose"));
  if (data["by_effect"].size() > 2)
    section.parts.emplace_back(account_of(data, "/by_effect", "Clocks by the effect that called for them", "effect"));
  if (data.contains("account") && data["account"].contains("parts")) section.parts.emplace_back(parts_of_machine(data));
  return section;
}

/// `9:9` of `cylinder@9:9`.
std::pair<std::string, std::string> kind_and_place(const std::string& name) {
  const std::size_t at = name.rfind('@');
  return at == std::string::npos ? std::pair{name, std::string()} : std::pair{name.substr(0, at), name.substr(at + 1)};
}

OwnerPicture owner_picture(const Json& data, const observe::Frame& frame, const isa::Program& program) {
  const observe::Frame of_primitives = observe::of_primitives(frame, *program.facts);
  const Json& primitives = data["by_primitive"];
  OwnerPicture owners{
      picture_of(frame, program, "", "The picture that the machine drew"),
      owners_of(of_primitives, "Whose surface is seen, a colour each",
                "The same view, each primitive in a colour of its own; the table of primitives tells their prices"),
      of_primitives.owner,
      most_expensive_first(data),
      {"Primitives, the dearest first",
       {"primitive", "line", "clocks", "share", "pixels seen", "pieces", "instructions"},
       {}}};
  if (owners.primitive.size() > most_rows) {
    owners.prices.caption = "The " + grouped(most_rows) + " dearest of " + grouped(primitives.size()) + " primitives";
    owners.primitive.resize(most_rows);
  }
  const std::vector<std::uint64_t> pixels = observe::pixels_seen(frame, program);
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

/// The drawing with stories of the background and of the primitives, in the order of their table.
Drawing drawing_with_stories(const OwnerPicture& owners, const story::Subject& subject,
                             const machines::Machine& machine, const Context& context) {
  Drawing drawing = record_drawing(subject.program, machine);
  drawing.explain = context.explain;
  std::vector<std::uint32_t> told{observe::no_owner};
  told.insert(told.end(), owners.primitive.begin(), owners.primitive.end());
  add_stories(subject, machine, central_pixels(owners.owner, owners.picture.width, told), drawing);
  return drawing;
}

/// What the stats say of it in words.
std::vector<Part> in_words(const Json& data) {
  std::vector<Part> parts = sentences(data, "/bound_by");
  for (Part& knob : sentences(data, "/knobs")) parts.push_back(std::move(knob));
  return parts;
}

Table dearest(const Json& data) {
  Table table{"The dearest primitives", {"primitive", "place", "clocks", "share", "pieces", "half-spaces"}, {}};
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
  Section picture{"Picture", in_words(data)};
  OwnerPicture owners = owner_picture(data, frame, program);
  Drawing drawing = drawing_with_stories(owners, {program, model}, machine, context);
  picture.parts.emplace_back(std::move(owners));
  page.sections.push_back(std::move(picture));
  page.sections.push_back({"Drawing", {std::move(drawing)}});
  page.sections.push_back({"Counts", {summary(data)}});
  page.sections.push_back(clocks_section(data));
  if (data.contains("dearest") && data["dearest"].is_array()) page.sections.back().parts.emplace_back(dearest(data));
  page.sections.push_back(configuration_section(data, context));
  return page;
}

}  // namespace csgsim::report
