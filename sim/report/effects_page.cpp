#include <cstddef>
#include <utility>

#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

constexpr PointColumn effects_columns[] = {{"effect", "effect"},
                                           {"clocks", "clocks charged"},
                                           {"instructions", "instructions"},
                                           {"pixel_operations", "pixel operations"},
                                           {"alone_clocks", "clocks that the effect adds alone"},
                                           {"together_clocks", "clocks saved without the effect"},
                                           {"bits", "memory bits saved without the effect"}};

Table frame_table(const Json& data) {
  constexpr std::pair<const char*, const char*> rows[] = {
      {"clocks of the frame", "/clocks"},
      {"clocks of the frame without effects", "/clocks_without_effects"},
      {"clocks of all instructions", "/total/clocks"},
      {"clocks of instructions for the solids", "/solids/clocks"},
      {"memory bits per pixel", "/bits"},
      {"memory bits per pixel without effects", "/bits_without_effects"}};
  Table table{"The frame", {"count", "value"}, {}};
  for (const auto& [name, at] : rows) table.rows.push_back({{name}, cell(data, at)});
  return table;
}

plots::Plot bill_plot(const Json& effects) {
  constexpr std::pair<const char*, const char*> bills[] = {
      {"clocks", "charged"}, {"alone_clocks", "added alone"}, {"together_clocks", "saved without the effect"}};
  plots::Chart chart{"Clocks of each effect",
                     {"effect", plots::Scale::linear, {}, true},
                     {{"clocks", plots::Scale::linear, {}, false, true}},
                     {},
                     "effects.json"};
  for (const Json& effect : effects)
    chart.x.ticks.push_back({static_cast<double>(chart.x.ticks.size()), effect["effect"].get<std::string>()});
  for (const auto& [key, name] : bills) {
    plots::Series series{name, 0, plots::Trace::marks};
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (effects[i].contains(key)) series.points.push_back({static_cast<double>(i), effects[i][key].get<double>()});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return {"bill", std::move(chart)};
}

}  // namespace

Page effects_page(const Json& file, std::vector<Picture> pictures, const StudyContext& study) {
  Page page = begin_page("Cost of effects: " + study.model, file, study);
  page.sections.push_back({"Pictures", {Gallery{std::move(pictures)}}});
  page.sections.push_back({"Costs",
                           {points_table(page.data, "/effects", "Each effect", effects_columns),
                            bill_plot(page.data["effects"]), frame_table(page.data)}});
  end_page(page, study);
  return page;
}

}  // namespace csgsim::report
