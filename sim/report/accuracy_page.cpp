#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/report/points.h"
#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

/// What turning a knob changes.
struct Knob {
  const char* name;
  const char* title;
  const char* wrong;       ///< key of the pixels that are wrong by it
  const char* what_wrong;  ///< what these are
};

constexpr const char* wrong_pixels = "wrong pixels";
constexpr const char* off_the_curve = "pixels that differ from the curved surfaces";

constexpr Knob knobs[] = {
    {"z-bits", "bits of depth", "wrong", wrong_pixels},
    {"fraction-bits", "fraction bits of the coefficients", "wrong", wrong_pixels},
    {"edge-on", "edge-on fraction", "wrong", wrong_pixels},
    {"size", "picture size", "wrong", wrong_pixels},
    {"fn", "fragments of a circle, $fn", "facet_wrong", off_the_curve},
    {"tolerance", "faceting tolerance, model units", "facet_wrong", off_the_curve},
};

std::vector<Json> points_of(const Json& data, const std::string& knob) {
  std::vector<Json> points;
  for (const Json& point : data["points"])
    if (point["knob"] == knob) points.push_back(point);
  return points;
}

/// What is added up over the views of a point.
std::string sum_title(const std::string& what, unsigned views) {
  return views == 1 ? what : fmt::format("{}, sum of {} views", what, views);
}

/// What it costs, and what it spares, against the knob's values in the order of the table.
void add_plots(const Knob& knob, const std::vector<Json>& points, unsigned views, std::vector<Part>& parts) {
  const std::vector<std::string> words = words_of(points, "value");
  const auto plot = [&](const char* key, const char* what, bool logarithmic) {
    Curve curve{place_in(words, "value"), number_at(key), [what](const Json&) { return std::string(what); }};
    return Plot{std::string(what) + " against " + knob.title,
                {knob.title, false, words},
                {sum_title(what, views), logarithmic},
                series_of(points, curve)};
  };
  parts.emplace_back(plot(knob.wrong, knob.what_wrong, true));
  parts.emplace_back(plot("clocks", "clocks", false));
}

Plot front_plot(const std::vector<Json>& together, const std::vector<std::string>& front, unsigned views) {
  const auto point_of = [](const Json& point) {
    return Point{point["clocks"].get<double>(), point["wrong"].get<double>(), point["value"].get<std::string>()};
  };
  Series best{"Pareto front", {}};
  Series others{"other choices of z bits / fraction bits", {}, plots::Trace::marks};
  for (const std::string& value : front) {
    const auto found =
        std::find_if(together.begin(), together.end(), [&](const Json& point) { return point["value"] == value; });
    if (found != together.end()) best.points.push_back(point_of(*found));
  }
  for (const Json& point : together)
    if (std::find(front.begin(), front.end(), point["value"].get<std::string>()) == front.end())
      others.points.push_back(point_of(point));
  return {"What accuracy costs: z bits and fraction bits together",
          {sum_title("clocks", views)},
          {sum_title(wrong_pixels, views), true},
          {std::move(best), std::move(others)}};
}

/// Facets of every number, and curved surfaces without them.
Plot curves_plot(const Json& data, unsigned views) {
  std::vector<Series> series{{"facets, by tolerance", {}}, {"facets, by $fn", {}}};
  const auto add = [&](const Json& point, Series& to) {
    to.points.push_back(
        {point["clocks"].get<double>(), point["facet_wrong"].get<double>(), point["value"].get<std::string>()});
  };
  for (const Json& point : points_of(data, "tolerance")) add(point, series[0]);
  for (const Json& point : points_of(data, "fn")) add(point, series[1]);
  for (const Json& point : points_of(data, "curves"))
    add(point, series.emplace_back(Series{point["value"].get<std::string>(), {}, plots::Trace::marks}));
  for (Series& one : series) std::ranges::sort(one.points, {}, &Point::x);
  std::erase_if(series, [](const Series& one) { return one.points.empty(); });
  return {"What accuracy costs: facets and curved surfaces",
          {sum_title("clocks", views), true},
          {sum_title(off_the_curve, views), true},
          std::move(series)};
}

constexpr PointColumn accuracy_columns[] = {{"knob", "knob"},
                                            {"value", "value"},
                                            {"clocks", "clocks"},
                                            {"halfspaces", "half-spaces"},
                                            {"memory_bits", "memory bits"},
                                            {"wrong", "wrong pixels"},
                                            {"unexplained", "of these unexplained"},
                                            {"depth_p999", "depth error, 99.9th percentile, model units"},
                                            {"depth_p999_steps", "the same in steps"},
                                            {"facet_wrong", "pixels off the curved surfaces"},
                                            {"facet_depth_p999", "depth from these, 99.9th percentile"},
                                            {"picture_difference", "mean colour difference of 255"}};

}  // namespace

Page accuracy_page(const Json& file, const std::vector<std::string>& front, unsigned views, const StudyContext& study) {
  Page page = begun_page("What accuracy costs: " + study.model, file, study);
  Section together{"Pareto front", {}};
  if (const std::vector<Json> points = points_of(page.data, "together"); !points.empty())
    together.parts.emplace_back(front_plot(points, front, views));
  if (!together.parts.empty()) page.sections.push_back(std::move(together));
  if (!points_of(page.data, "curves").empty())
    page.sections.push_back({"Facets and curved surfaces", {curves_plot(page.data, views)}});
  Section turned{"Knobs", {}};
  for (const Knob& knob : knobs) {
    if (const std::vector<Json> points = points_of(page.data, knob.name); !points.empty())
      add_plots(knob, points, views, turned.parts);
  }
  if (!turned.parts.empty()) page.sections.push_back(std::move(turned));
  const std::string caption =
      views == 1
          ? "All that was measured"
          : fmt::format("All that was measured: clocks and pixels are sums of {} views, depths those of the worst",
                        views);
  page.sections.push_back({"Points", {points_table(page.data, "/points", caption, accuracy_columns)}});
  end_page(page, study);
  return page;
}

}  // namespace csgsim::report
