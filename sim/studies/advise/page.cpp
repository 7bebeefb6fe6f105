#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "hw/base/text.h"
#include "sim/report/chart.h"
#include "sim/report/number_text.h"
#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::studies {

namespace {

constexpr PointColumn advise_columns[] = {{"memory_bits", "memory bits"},
                                          {"z_bits", "z bits"},
                                          {"fraction_bits", "fraction bits"},
                                          {"colour_bits", "colour bits"},
                                          {"colour_error", "colour error of 255"},
                                          {"strategy", "strategy"},
                                          {"stack_bits", "stack bits"},
                                          {"colouring", "colouring"},
                                          {"alu_bits", "ALU bits"},
                                          {"clocks", "clocks"},
                                          {"frames_per_second", "frames a second"},
                                          {"wrong", "wrong pixels"}};

Table wishes_table(const Json& data) {
  constexpr std::pair<const char*, const char*> rows[] = {{"memory bits a pixel, at most", "/wishes/max_bits"},
                                                          {"wrong pixels, at most", "/wishes/max_wrong_pixels"},
                                                          {"frames a second, at least", "/wishes/min_fps"},
                                                          {"bits of colour, at least", "/wishes/min_colour_bits"}};
  Table table{"Wishes", {"wish", "value"}, {}};
  for (const auto& [name, at] : rows) table.rows.push_back({{name}, cell(data, at)});
  return table;
}

/// Pointers of what is recommended, and of the nearest choice where there is one.
std::vector<std::string> recommended(const Json& data) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < data["recommendations"].size(); ++i)
    all.push_back("/recommendations/" + std::to_string(i));
  if (data.contains("nearest")) all.emplace_back("/nearest");
  return all;
}

Cell name_of(const Json& data, const std::string& at) {
  const Cell what = cell(data, at + "/what");
  return what.at.empty() ? Cell{"nearest to all wishes"} : what;
}

Table recommendations_table(const Json& data) {
  Table table{"The best by each wish", {"best by", "meets all wishes", "misses its own by"}, {}};
  for (const PointColumn& column : advise_columns) table.columns.emplace_back(column.title);
  for (const std::string& at : recommended(data)) {
    const bool is_nearest = at == "/nearest";
    Row row{name_of(data, at), is_nearest ? cell(data, "/meets_all") : cell(data, at + "/meets_all"),
            is_nearest ? Cell{} : cell(data, at + "/missed_by")};
    for (const PointColumn& column : advise_columns) row.push_back(cell(data, at + "/point/" + column.key));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table commands_table(const Json& data) {
  Table table{"Commands that render them", {"best by", "command"}, {}, true};
  for (const std::string& at : recommended(data))
    table.rows.push_back({name_of(data, at), cell(data, at + "/command")});
  return table;
}

std::string searched(const Json& points) {
  const auto refused = std::count_if(points.begin(), points.end(), [](const Json& one) { return !is_measured(one); });
  return fmt::format("{} choices were searched; {} of them cannot be drawn.", grouped(points.size()),
                     grouped(static_cast<std::uint64_t>(refused)));
}

}  // namespace

Page advise_page(const Json& file, const plots::Plot& front, std::vector<Picture> pictures, const StudyContext& study) {
  Json without_points = file;
  without_points.erase("points");
  Page page = begun_page("The cheapest memory: " + study.model, std::move(without_points), study);
  const Json& data = page.data;
  const char* const outcome =
      data["meets_all"].get<bool>()
          ? "Each of these is the best by one wish of the choices that meet the others."
          : "No choice meets all wishes. Each of these is the best by one wish of the choices that meet the others; "
            "what it misses its own wish by is what is in the way.";
  Section advice{"Recommendations", {Paragraph{searched(file["points"])}, Paragraph{outcome}}};
  if (!pictures.empty()) advice.parts.emplace_back(Gallery{std::move(pictures)});
  advice.parts.emplace_back(recommendations_table(data));
  advice.parts.emplace_back(commands_table(data));
  advice.parts.emplace_back(wishes_table(data));
  page.sections.push_back(std::move(advice));
  Section chosen = plots_section({&front, 1});
  chosen.title = "Front";
  chosen.parts.emplace_back(
      points_table(data, "/front", "Choices that no other beats, fewest memory bits first", advise_columns));
  page.sections.push_back(std::move(chosen));
  end_page(page, study);
  return page;
}

}  // namespace csgsim::studies
