#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

std::string machine_of(const Json& point) { return point["machine"].get<std::string>(); }
double drawing_ms(const Json& point) { return point["seconds"].get<double>() * 1e3; }
double interval_ms(const Json& point) { return 1e3 / point["frames_per_second"].get<double>(); }
double pixels(const Json& point) { return point["width"].get<double>() * point["height"].get<double>(); }

std::string picture_of(const Json& point) {
  return word_of(point["width"]) + " x " + word_of(point["height"]) + " pixels, " + word_of(point["halfspaces"]) +
         " half-spaces";
}

bool has_interval(const Json& point) {
  return point["frames_per_second"].is_number() && point["frames_per_second"].get<double>() > 0;
}

/// Lines against a number that varies, from its least value up; nothing where it does not.
void add_plots(std::vector<Json> points, const std::string& title, double (*against)(const Json&),
               std::vector<Part>& parts) {
  std::erase_if(points, [](const Json& point) { return !has_interval(point); });
  std::stable_sort(points.begin(), points.end(), [&](const Json& a, const Json& b) { return against(a) < against(b); });
  if (points.empty() || against(points.front()) == against(points.back())) return;
  const auto add = [&](const std::string& what, const std::string& axis, double (*time)(const Json&)) {
    parts.emplace_back(Plot{what + " against " + title,
                            {title, true},
                            {axis, true},
                            series_of(points, {against, time, machine_of, picture_of})});
  };
  add("Time from frame to frame", "from frame to frame, ms", interval_ms);
  add("Time of drawing alone", "drawing alone, ms", drawing_ms);
}

double halfspaces(const Json& point) { return point["halfspaces"].get<double>(); }

/// What each idealisation of a machine is worth, against the machine as it is, which comes before them.
Table worth_table(const Json& data) {
  Table table{"What each idealisation is worth", {"machine", "ideal", "clocks", "seconds", "worth"}, {}};
  double as_it_is = 0;
  for (std::size_t i = 0; i < data["points"].size(); ++i) {
    const Json& point = data["points"][i];
    if (!is_measured(point)) continue;
    const std::string at = "/points/" + std::to_string(i);
    const bool is_plain = point["ideal"].get<std::string>().empty();
    if (is_plain) as_it_is = point["seconds"].get<double>();
    table.rows.push_back(
        {cell(data, at + "/machine"), is_plain ? Cell{"as it is"} : cell(data, at + "/ideal"),
         cell(data, at + "/clocks"), cell(data, at + "/seconds"),
         is_plain || as_it_is == 0 ? Cell{} : share(as_it_is - point["seconds"].get<double>(), as_it_is)});
  }
  return table;
}

constexpr PointColumn compare_columns[] = {{"machine", "machine"},
                                           {"width", "pixels a row"},
                                           {"height", "rows"},
                                           {"fragments", "$fn, 0: the model's own"},
                                           {"ideal", "ideal"},
                                           {"halfspaces", "half-spaces"},
                                           {"clocks", "clocks"},
                                           {"seconds", "seconds of drawing"},
                                           {"frames_per_second", "frames a second"},
                                           {"pixel_operations", "pixel operations"},
                                           {"processors", "processors"},
                                           {"processor_clocks", "processor clocks"},
                                           {"memory_bits", "memory bits"},
                                           {"transistors", "transistors"},
                                           {"utilisation", "used", Show::share}};

}  // namespace

Page compare_page(const Json& file, const StudyContext& study) {
  Page page = begun_page("Machines compared: " + study.model, file, study);
  const Json& data = page.data;
  std::vector<Json> drawn;
  for (const Json& point : data["points"])
    if (is_measured(point)) drawn.push_back(point);
  const bool is_ideal = std::any_of(drawn.begin(), drawn.end(),
                                    [](const Json& point) { return !point["ideal"].get<std::string>().empty(); });
  if (is_ideal) {
    page.sections.push_back({"Idealisations", {worth_table(data)}});
  } else {
    Section growth{"Growth", {}};
    // The first point has the size at which half-spaces vary.
    std::vector<Json> of_base;
    std::vector<Json> own_facets;
    for (const Json& point : drawn) {
      const Json& base = data["points"].front();
      if (point["width"] == base["width"] && point["height"] == base["height"]) of_base.push_back(point);
      if (point["fragments"] == 0) own_facets.push_back(point);
    }
    add_plots(std::move(of_base), "half-spaces of the model", halfspaces, growth.parts);
    add_plots(std::move(own_facets), "pixels of the picture", pixels, growth.parts);
    if (!growth.parts.empty()) page.sections.push_back(std::move(growth));
  }
  page.sections.push_back({"Points", {points_table(data, "/points", "All that was measured", compare_columns)}});
  end_page(page, study);
  return page;
}

}  // namespace csgsim::report
