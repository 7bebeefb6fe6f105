#include <cstddef>
#include <utility>

#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

constexpr PointColumn effects_columns[] = {{"effect", "effect"},
                                           {"clocks", "clocks billed"},
                                           {"instructions", "instructions"},
                                           {"pixel_operations", "pixel operations"},
                                           {"alone_clocks", "clocks it adds alone"},
                                           {"together_clocks", "clocks spared without it"},
                                           {"bits", "memory bits spared without it"}};

Table frame_table(const Json& data) {
  constexpr std::pair<const char*, const char*> rows[] = {
      {"clocks of the frame", "/clocks"},
      {"clocks without any effect", "/clocks_without_effects"},
      {"clocks of all instructions", "/total/clocks"},
      {"of these for the solids", "/solids/clocks"},
      {"memory bits a pixel", "/bits"},
      {"memory bits a pixel without any effect", "/bits_without_effects"}};
  Table table{"The frame", {"count", "value"}, {}};
  for (const auto& [name, at] : rows) table.rows.push_back({{name}, cell(data, at)});
  return table;
}

Plot bill_plot(const std::vector<Json>& effects) {
  const std::vector<std::string> words = words_of(effects, "effect");
  constexpr std::pair<const char*, const char*> bars[] = {
      {"clocks", "billed"}, {"alone_clocks", "added alone"}, {"together_clocks", "spared without it"}};
  Plot plot{"Clocks of each effect", {"effect", false, words}, {"clocks"}, {}};
  for (const auto& [key, name] : bars) {
    Series series{name, {}, plots::Trace::marks};
    for (const Json& effect : effects) {
      if (effect.contains(key))
        series.points.push_back({place_in(words, "effect")(effect), effect[key].get<double>(), ""});
    }
    if (!series.points.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

Page effects_page(const Json& file, std::vector<Picture> pictures, const StudyContext& study) {
  Page page = begun_page("What effects cost: " + study.model, file, study);
  page.sections.push_back({"Pictures", {Gallery{std::move(pictures)}}});
  const std::vector<Json> effects(page.data["effects"].begin(), page.data["effects"].end());
  page.sections.push_back({"Bill",
                           {points_table(page.data, "/effects", "Each effect", effects_columns), bill_plot(effects),
                            frame_table(page.data)}});
  end_page(page, study);
  return page;
}

}  // namespace csgsim::report
