#include "sim/report/drawing_html.h"

#include <fmt/format.h>

#include "hw/base/markup.h"
#include "hw/base/text.h"
#include "sim/report/codec.h"

namespace csgsim::report {

std::string drawing_html(const Drawing& drawing) {
  return fmt::format(
      "<p>{}</p>\n<div id=drawing-box class=drawing><noscript><p class=note>Scripts are off: the drawing's {} steps "
      "cannot "
      "be shown.</p></noscript></div>\n",
      markup_text(drawing.told), drawing.steps.size());
}

Json drawing_json(const Drawing& drawing) {
  Json steps = Json::array();
  for (const DrawingStep& step : drawing.steps) {
    steps.push_back(Json::array(
        {step.number, printable(step.text), printable(step.serves), step.clocks, step.enabled, base64(step.changes)}));
  }
  return {{"width", drawing.width}, {"height", drawing.height}, {"steps", std::move(steps)}};
}

}  // namespace csgsim::report
