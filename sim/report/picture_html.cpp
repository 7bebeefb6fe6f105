#include <fmt/format.h>

#include "hw/base/markup.h"
#include "hw/base/text.h"
#include "sim/observe/frame.h"
#include "sim/report/codec.h"
#include "sim/report/parts_html.h"

namespace csgsim::report {

namespace {

std::string figure_html(const Picture& picture, const std::string& attributes) {
  const char* const caption = picture.caption.empty() ? "" : "<figcaption>";
  return fmt::format("<figure{}><img src=\"data:image/png;base64,{}\" width={} height={} alt=\"{}\">{}{}{}</figure>\n",
                     attributes, base64(picture.png), picture.width, picture.height, markup_text(picture.alt), caption,
                     markup_text(picture.caption), picture.caption.empty() ? "" : "</figcaption>");
}

}  // namespace

std::string gallery_html(const Gallery& gallery) {
  std::string html = "<div class=gallery>\n";
  for (const Picture& picture : gallery.pictures) html += figure_html(picture, "");
  return html + "</div>\n";
}

std::string owners_html(const OwnerPicture& owners) {
  std::vector<std::string> rows;
  rows.reserve(owners.primitive.size());
  for (const std::uint32_t primitive : owners.primitive) rows.push_back(fmt::format("data-p={}", primitive));
  return "<div class=owners id=owners-box><div class=stage>\n" + figure_html(owners.picture, " class=shown") +
         figure_html(owners.owners, " class=whose") + "</div>\n<div class=prices>\n" + table_html(owners.prices, rows) +
         "</div></div>\n";
}

Json owners_json(const OwnerPicture& owners) {
  return {{"width", owners.picture.width},
          {"height", owners.picture.height},
          {"runs", base64(encode_owner_runs(owners.owner))}};
}

std::string drawing_html(const Drawing& drawing, const std::string& id) {
  return fmt::format(
      "<p>{}</p>\n<div class=drawing data-of=\"{}\"><noscript><p class=note>Scripts are disabled: the drawing's {} "
      "steps cannot be shown.</p></noscript></div>\n",
      markup_text(drawing.summary), id, drawing.steps.size());
}

namespace {

/// The text of a part; for an event, an array of its text and the first step after it.
Json part_json(const story::TextPart& part, const Drawing& drawing) {
  if (part.end == 0) return part.text;
  return {part.text, step_after(drawing.steps, part.end)};
}

Json stories_json(const Drawing& drawing) {
  Json stories = Json::array();
  for (const PixelStory& story : drawing.stories) {
    Json parts = Json::array();
    for (const story::TextPart& part : story.parts) parts.push_back(part_json(part, drawing));
    Json primitive = story.primitive == observe::no_owner ? Json() : Json(story.primitive);
    stories.push_back(
        {{"x", story.x}, {"y", story.y}, {"primitive", std::move(primitive)}, {"parts", std::move(parts)}});
  }
  return stories;
}

}  // namespace

Json drawing_json(const Drawing& drawing) {
  Json steps = Json::array();
  for (const DrawingStep& step : drawing.steps) {
    steps.push_back(Json::array(
        {step.number, printable(step.text), printable(step.serves), step.clocks, step.enabled, base64(step.changes)}));
  }
  return {{"width", drawing.width},    {"height", drawing.height},         {"every", drawing.every},
          {"steps", std::move(steps)}, {"stories", stories_json(drawing)}, {"explain", printable(drawing.explain)}};
}

}  // namespace csgsim::report
