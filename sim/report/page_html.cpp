#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "hw/base/markup.h"
#include "sim/plots/palette.h"
#include "sim/report/page.h"
#include "sim/report/parts_html.h"

namespace csgsim::report {

namespace {

namespace palette = plots::palette;

std::string colour_rule(std::string_view colour, const std::string& name) {
  return fmt::format(".plot [fill=\"{0}\"]{{fill:var(--{1})}}.plot [stroke=\"{0}\"]{{stroke:var(--{1})}}\n", colour,
                     name);
}

/// Replaces the colours of plots, which are made for white paper, by the colours of the page.
std::string colours_of_plots() {
  std::string light;
  std::string dark;
  std::string rules =
      colour_rule(palette::paper, "page") + colour_rule(palette::grid, "edge") + colour_rule(palette::leader, "faint");
  for (std::size_t i = 0; i < palette::looks.size(); ++i) {
    light += fmt::format("--s{}:{};", i, palette::looks[i].colour);
    dark += fmt::format("--s{}:{};", i, palette::colours_on_dark[i]);
    rules += colour_rule(palette::looks[i].colour, fmt::format("s{}", i));
  }
  return fmt::format(":root{{{}}}\n@media (prefers-color-scheme:dark){{:root{{{}}}}}\n{}", light, dark, rules);
}

/// The page loads nothing from elsewhere, whatever its texts contain.
constexpr const char* policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

std::string json_script(const std::string& id, const Json& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, json_in_html(json));
}

/// Writes the parts, and collects the data that page.js needs for them.
class Writer {
 public:
  std::string operator()(const Paragraph& paragraph) { return "<p>" + markup_text(paragraph.text) + "</p>\n"; }
  std::string operator()(const Table& table) { return table_html(table); }
  std::string operator()(const plots::Plot& plot) { return plot_html(plot); }
  std::string operator()(const Gallery& gallery) { return gallery_html(gallery); }
  std::string operator()(const OwnerPicture& owners) {
    scripts_ += json_script("owners-data", owners_json(owners));
    return owners_html(owners);
  }
  std::string operator()(const Drawing& drawing) {
    const std::string id = fmt::format("drawing-{}", drawings_++);
    scripts_ += json_script(id, drawing_json(drawing));
    return drawing_html(drawing, id);
  }

  /// The data scripts of the parts; they follow page.js.
  [[nodiscard]] const std::string& scripts() const { return scripts_; }
  [[nodiscard]] bool has_drawings() const { return drawings_ > 0; }

 private:
  std::string scripts_;
  unsigned drawings_ = 0;
};

std::string contents_html(const Page& page) {
  std::string html = "<nav aria-label=\"Contents\"><ul>";
  for (const Section& section : page.sections)
    html += fmt::format("<li><a href=\"#at-{}\">{}</a></li>", html_id(section.title), markup_text(section.title));
  return html + "</ul></nav>\n";
}

}  // namespace

std::string json_in_html(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    // '<' occurs only in strings, where JSON allows the escape.
    c == '<' ? text += "\\u003c" : text += c;
  }
  return text;
}

std::string html_id(std::string_view text) {
  std::string id;
  for (const char c : text) {
    const bool is_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_word) {
      id.push_back(static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c));
    } else if (!id.empty() && id.back() != '-') {
      id.push_back('-');
    }
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id;
}

std::string to_html(const Page& page) {
  Writer writer;
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n<meta http-equiv=Content-Security-Policy "
      "content=\"{}\">\n<meta name=viewport content=\"width=device-width, initial-scale=1\">\n<meta name=color-scheme "
      "content=\"light dark\">\n<title>{}</title>\n<link rel=icon "
      "href=\"data:,\">\n<style>\n{}{}</style>\n</head>\n<body>\n",
      policy, markup_text(page.title), page_style, colours_of_plots());
  html += fmt::format(
      "<header><h1>{}</h1>\n<pre class=command id=command tabindex=0 aria-label=\"The "
      "command\">{}</pre>\n{}</header>\n<main>\n",
      markup_text(page.title), markup_text(page.command), contents_html(page));
  for (const Section& section : page.sections) {
    html += fmt::format("<section id=at-{0} aria-labelledby=h-{0}><h2 id=h-{0}>{1}</h2>\n", html_id(section.title),
                        markup_text(section.title));
    for (const Part& part : section.parts) html += std::visit(writer, part);
    html += "</section>\n";
  }
  html += "</main>\n<div id=told class=told role=status aria-live=polite></div>\n";
  html += json_script("data", page.data) + writer.scripts();
  html += fmt::format("<script>\n{}</script>\n", page_script);
  if (writer.has_drawings()) html += fmt::format("<script>\n{}</script>\n", drawing_script);
  return html + "</body>\n</html>\n";
}

}  // namespace csgsim::report
