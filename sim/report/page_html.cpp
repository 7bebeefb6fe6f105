#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <string_view>

#include "sim/plots/palette.h"
#include "sim/report/drawing_html.h"
#include "sim/report/html.h"
#include "sim/report/page.h"
#include "sim/report/picture_html.h"
#include "sim/report/plot_svg.h"
#include "sim/report/table_html.h"
#include "sim/report/text.h"

namespace csgsim::report {

namespace {

using plots::palette::looks;

/// A mark of plots' points, about 10 pixels wide.
std::string_view shape_of(plots::palette::Mark mark) {
  using enum plots::palette::Mark;
  switch (mark) {
    case disc: return R"(<circle r="4.5"/>)";
    case square: return R"(<path d="M-4.5-4.5h9v9h-9Z"/>)";
    case up: return R"(<path d="M0-6L5.5 4H-5.5Z"/>)";
    case down: return R"(<path d="M0 6L-5.5-4H5.5Z"/>)";
    case diamond: return R"(<path d="M0-6L6 0 0 6-6 0Z"/>)";
    case pentagon: return R"(<path d="M0-5.5L5.2-1.7 3.2 4.5H-3.2L-5.2-1.7Z"/>)";
    case ring: return R"(<circle class="hollow" r="4"/>)";
    case box: return R"(<path class="hollow" d="M-4-4h8v8h-8Z"/>)";
  }
  return {};
}

std::string marks_html() {
  std::string html = "<svg width=0 height=0 aria-hidden=true><defs>\n";
  for (std::size_t i = 0; i < looks.size(); ++i) html += fmt::format("<g id=m{}>{}</g>", i, shape_of(looks[i].mark));
  return html + "\n</defs></svg>\n";
}

/// A look's dash, which is in half pixels, as a style has it.
std::string dash_in_pixels(std::string_view dash) {
  if (dash.empty()) return "none";
  std::string pixels;
  const char* const end = dash.data() + dash.size();
  for (const char* at = dash.data(); at < end; ++at) {
    unsigned halves = 0;
    at = std::from_chars(at, end, halves).ptr;
    pixels += fmt::format("{}{:g}", pixels.empty() ? "" : " ", halves / 2.0);
  }
  return pixels;
}

/// Colours and dashes of series, of which page.css speaks as --s and --dash.
std::string series_style() {
  std::string light;
  std::string dark;
  std::string classes;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    light += fmt::format("--s{}:{};", i, looks[i].colour);
    dark += fmt::format("--s{}:{};", i, plots::palette::colours_on_dark[i]);
    classes +=
        fmt::format(".s{0}{{--s:var(--s{0})}}.d{0} .line{{stroke-dasharray:{1}}}\n", i, dash_in_pixels(looks[i].dash));
  }
  return fmt::format(":root{{{}}}\n@media (prefers-color-scheme:dark){{:root{{{}}}}}\n{}", light, dark, classes);
}

/// The page asks for nothing from elsewhere, whatever the texts in it say.
constexpr const char* policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

std::string json_script(const std::string& id, const Json& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, json_in_html(json));
}

/// Writes parts, and takes down what page.js needs of them.
class Writer {
 public:
  explicit Writer(const Page& page) : looks_(page_looks(page)) {}

  std::string operator()(const Paragraph& paragraph) { return "<p>" + html_text(paragraph.text) + "</p>\n"; }
  std::string operator()(const Table& table) { return table_html(table); }
  std::string operator()(const Plot& plot) { return plot_html(plot, fmt::format("plot-{}", ++plots_), looks_); }
  std::string operator()(const Gallery& gallery) { return gallery_html(gallery); }
  std::string operator()(const OwnerPicture& owners) {
    scripts_ += json_script("owners-data", owners_json(owners));
    return owners_html(owners);
  }
  std::string operator()(const Drawing& drawing) {
    scripts_ += json_script("drawing-data", drawing_json(drawing));
    return drawing_html(drawing);
  }

  [[nodiscard]] const std::string& scripts() const { return scripts_; }

 private:
  plots::Looks looks_;
  std::size_t plots_ = 0;
  std::string scripts_;
};

std::string contents_html(const Page& page) {
  std::string html = "<nav aria-label=\"Contents\"><ul>";
  for (const Section& section : page.sections)
    html += fmt::format("<li><a href=\"#at-{}\">{}</a></li>", html_id(section.title), html_text(section.title));
  return html + "</ul></nav>\n";
}

}  // namespace

std::string to_html(const Page& page) {
  Writer writer(page);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n<meta http-equiv=Content-Security-Policy "
      "content=\"{}\">\n<meta name=viewport content=\"width=device-width, initial-scale=1\">\n<meta name=color-scheme "
      "content=\"light dark\">\n<title>{}</title>\n<link rel=icon "
      "href=\"data:,\">\n<style>\n{}{}</style>\n</head>\n<body>\n",
      policy, html_text(page.title), page_style, series_style());
  html += marks_html();
  html += fmt::format(
      "<header><h1>{}</h1>\n<pre class=command id=command tabindex=0 aria-label=\"The "
      "command\">{}</pre>\n{}</header>\n<main>\n",
      html_text(page.title), html_text(page.command), contents_html(page));
  for (const Section& section : page.sections) {
    html += fmt::format("<section id=at-{0} aria-labelledby=h-{0}><h2 id=h-{0}>{1}</h2>\n", html_id(section.title),
                        html_text(section.title));
    for (const Part& part : section.parts) html += std::visit(writer, part);
    html += "</section>\n";
  }
  html += "</main>\n<div id=told class=told role=status aria-live=polite></div>\n";
  html += json_script("data", page.data) + writer.scripts();
  return html + fmt::format("<script>\n{}</script>\n</body>\n</html>\n", page_script);
}

}  // namespace csgsim::report
