#include <algorithm>
#include <utility>
#include <variant>

#include "sim/report/study_pages.h"

namespace csgsim::report {

namespace {

bool has_content(const plots::Chart& chart) {
  return std::ranges::any_of(chart.series, [](const plots::Series& series) { return !series.points.empty(); });
}

bool has_content(const plots::Bars& plot) { return !plot.bars.empty(); }

}  // namespace

Page begin_page(const std::string& title, Json data, const StudyContext& study) {
  Page page{title, study.context.command, without_wall_times(std::move(data)), {}};
  if (study.picture) {
    page.sections.push_back({"Picture", {Gallery{{*study.picture}}}});
  } else if (!study.no_picture.empty()) {
    page.sections.push_back({"Picture", {Paragraph{"No picture: " + study.no_picture}}});
  }
  return page;
}

Section plots_section(std::span<const plots::Plot> plots) {
  Section section{"Plots", {}};
  for (const plots::Plot& plot : plots) {
    if (std::visit([](const auto& content) { return has_content(content); }, plot.content))
      section.parts.emplace_back(plot);
  }
  return section;
}

void end_page(Page& page, const StudyContext& study) {
  if (std::vector<Part> words = sentences(page.data, "/knobs"); !words.empty())
    page.sections.push_back({"Summary", std::move(words)});
  page.sections.push_back(configuration_section(page.data, study.context));
}

}  // namespace csgsim::report
