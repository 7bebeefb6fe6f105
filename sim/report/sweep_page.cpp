#include <cstddef>
#include <filesystem>
#include <utility>

#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

/// What a sweep varies besides the strategy, and as what it stands on an axis.
constexpr std::pair<const char*, const char*> dimensions[] = {
    {"machine", "machine"},      {"memory_bits", "memory bits a pixel"},
    {"z_bits", "bits of depth"}, {"pruning", "pruning"},
    {"colouring", "colouring"},  {"curves", "curves"}};

std::string strategy_of(const Json& point) {
  const std::string name = point["strategy"].get<std::string>();
  return point["stack_bits"] == 0 ? name : name + " " + word_of(point["stack_bits"]);
}

std::vector<std::pair<const char*, const char*>> varied(std::span<const Json> points) {
  std::vector<std::pair<const char*, const char*>> all;
  for (const auto& dimension : dimensions)
    if (words_of(points, dimension.first).size() > 1) all.push_back(dimension);
  return all;
}

/// Names of lines: `named`, and what else varies, but for the key on the axis.
auto line_name(std::span<const Json> points, std::string (*named)(const Json&), const std::string& axis) {
  return [keys = varied(points), named, axis](const Json& point) {
    std::string name = named(point);
    for (const auto& [key, title] : keys) {
      if (key == axis) continue;
      const bool is_number = point[key].is_number();
      name += ", " + (is_number ? std::string(title) + " " : "") + word_of(point[key]);
    }
    return name;
  };
}

std::string family_of(const Json& point) { return point["strategy"].get<std::string>(); }

/// Bits given to strategy bits, or used by the others.
double classification_bits(const Json& point) {
  return point[point["stack_bits"] == 0 ? "classification_bits" : "stack_bits"].get<double>();
}

void add_plots(const std::string& model, const std::vector<Json>& points, std::vector<Part>& parts) {
  const auto add = [&](Plot plot) {
    if (!plot.series.empty()) parts.emplace_back(std::move(plot));
  };
  add({model + ": what memory buys",
       {"bits of pixel memory that the classification uses"},
       {"clocks"},
       series_of(points, {number_at("classification_bits"), number_at("clocks"), line_name(points, family_of, ""),
                          [](const Json& point) { return strategy_of(point); }})});
  for (const char* const key : {"rendered", "classified"}) {
    add({model + ": scan-conversions of primitives, " + key,
         {"bits for the classification: given (bits), used (others)"},
         {std::string("scan-conversions, ") + key},
         series_of(points, {classification_bits, number_at(key), line_name(points, family_of, ""),
                            [](const Json& point) { return strategy_of(point); }})});
  }
  for (const auto& [key, title] : varied(points)) {
    const std::vector<std::string> words = words_of(points, key);
    add({model + ": clocks against " + title,
         {title, false, words},
         {"clocks"},
         series_of(points, {place_in(words, key), number_at("clocks"), line_name(points, strategy_of, key)})});
  }
}

constexpr PointColumn sweep_columns[] = {{"strategy", "strategy"},
                                         {"stack_bits", "stack bits"},
                                         {"machine", "machine"},
                                         {"memory_bits", "memory bits"},
                                         {"z_bits", "z bits"},
                                         {"pruning", "pruning"},
                                         {"colouring", "colouring"},
                                         {"curves", "curves"},
                                         {"clocks", "clocks"},
                                         {"rendered", "rendered"},
                                         {"classified", "classified"},
                                         {"depth_tests", "depth tests"},
                                         {"classification_bits", "bits for the classification"},
                                         {"used_bits", "bits in all"},
                                         {"pixel_transistors", "transistors a pixel"},
                                         {"model", "model"}};

}  // namespace

Page sweep_page(const Json& file, const StudyContext& study) {
  Page page = begun_page("What memory bits buy: " + study.model, file, study);
  std::vector<Json> all(page.data["points"].begin(), page.data["points"].end());
  Section plots{"Plots", {}};
  const std::vector<std::string> models = words_of(all, "model");
  for (const std::string& model : models) {
    std::vector<Json> points;
    for (const Json& point : all)
      if (word_of(point["model"]) == model) points.push_back(point);
    add_plots(std::filesystem::path(model).filename().native(), points, plots.parts);
  }
  page.sections.push_back(std::move(plots));
  // The name of the only model is the page's title.
  const std::span shown = std::span(sweep_columns).first(std::size(sweep_columns) - (models.size() == 1 ? 1 : 0));
  page.sections.push_back({"Points", {points_table(page.data, "/points", "All that was measured", shown)}});
  end_page(page, study);
  return page;
}

}  // namespace csgsim::report
