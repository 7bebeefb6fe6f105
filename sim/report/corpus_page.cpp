#include <algorithm>
#include <utility>

#include "sim/report/chart.h"
#include "sim/report/configuration.h"
#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

constexpr PointColumn corpus_columns[] = {{"model", "model"},
                                          {"machine", "machine"},
                                          {"primitives", "primitives"},
                                          {"pieces", "pieces"},
                                          {"halfspaces", "half-spaces"},
                                          {"clocks", "clocks"},
                                          {"frames_per_second", "frames a second"},
                                          {"bound_by", "bound by"},
                                          {"setup", "setup"},
                                          {"render", "render"},
                                          {"classify", "classify"},
                                          {"stack", "stack"},
                                          {"merge", "merge"},
                                          {"shade", "shade"},
                                          {"effect", "effect"},
                                          {"latency", "latency"},
                                          {"pixel_operations", "pixel operations"},
                                          {"enabled", "of these enabled"},
                                          {"used_bits", "memory bits"}};

constexpr std::pair<const char*, const char*> marks[] = {{"minimum", "minimum"}, {"first_quartile", "first quartile"},
                                                         {"median", "median"},   {"third_quartile", "third quartile"},
                                                         {"maximum", "maximum"}, {"total", "total"}};

Table distribution_table(const Json& data, const std::string& machine) {
  Table table{machine + ": how the models that it draws are distributed", {"count", "models"}, {}};
  for (const auto& [key, title] : marks) table.columns.emplace_back(title);
  const std::string at = child("/distributions", machine);
  for (const auto& [name, distribution] : data["distributions"][machine].items()) {
    const std::string here = child(at, name);
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    Row row{{words}, cell(data, here + "/count")};
    for (const auto& [key, title] : marks) row.push_back(cell(data, here + "/" + key));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Page corpus_page(const Json& file, std::span<const plots::Plot> plots, const StudyContext& study) {
  Page page = begun_page("What many models take: " + study.model, file, study);
  page.sections.push_back(plots_section(plots));
  Section distributions{"Distributions", {}};
  for (const auto& [machine, counts] : page.data["distributions"].items())
    distributions.parts.emplace_back(distribution_table(page.data, machine));
  page.sections.push_back(std::move(distributions));
  page.sections.push_back(
      {"Points", {points_table(page.data, "/points", "Each model on each machine", corpus_columns)}});
  end_page(page, study);
  return page;
}

}  // namespace csgsim::report
