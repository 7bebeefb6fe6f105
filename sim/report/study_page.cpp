#include <utility>

#include "sim/report/study_pages.h"

namespace csgsim::report {

Page begun_page(const std::string& title, Json data, const StudyContext& study) {
  Page page{title, study.context.command, without_wall_times(std::move(data)), {}};
  if (study.picture) {
    page.sections.push_back({"Picture", {Gallery{{*study.picture}}}});
  } else if (!study.no_picture.empty()) {
    page.sections.push_back({"Picture", {Paragraph{"There is no picture: " + study.no_picture}}});
  }
  return page;
}

void end_page(Page& page, const StudyContext& study) {
  if (std::vector<Part> words = sentences(page.data, "/knobs"); !words.empty())
    page.sections.push_back({"In words", std::move(words)});
  page.sections.push_back(configuration_section(page.data, study.context));
}

}  // namespace csgsim::report
