#include "sim/report/picture_html.h"

#include <fmt/format.h>

#include "hw/base/markup.h"
#include "sim/report/codec.h"
#include "sim/report/table_html.h"

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
  return {
      {"width", owners.picture.width}, {"height", owners.picture.height}, {"runs", base64(owner_runs(owners.owner))}};
}

}  // namespace csgsim::report
