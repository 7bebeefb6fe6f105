#include <fmt/format.h>

#include <cstddef>

#include "hw/base/markup.h"
#include "hw/base/text.h"
#include "sim/plots/number_text.h"
#include "sim/report/parts_html.h"

namespace csgsim::report {

namespace {

bool is_number(const Json& value) { return value.is_number(); }

/// The displayed text of a value.
std::string text_of(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_unsigned()) return grouped(value.get<std::uint64_t>());
  if (value.is_number()) return plots::number_text(value.get<double>());
  if (value.is_array()) {
    std::string text;
    for (const Json& one : value) text += (text.empty() ? "" : ", ") + text_of(one);
    return text;
  }
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string share_html(double share) {
  return fmt::format("<span class=bar style=\"--of:{:.4f}\"></span>{:.1f} %", share, 100.0 * share);
}

std::string cell_html(const Cell& cell, bool is_header) {
  std::string attributes = is_header ? " scope=row" : "";
  if (is_number(cell.value)) attributes += " class=n";
  constexpr std::size_t long_text = 32;  // bytes; longer texts are wrapped
  if (cell.value.is_string() && cell.value.get_ref<const std::string&>().size() > long_text) attributes += " class=w";
  if (!cell.at.empty()) attributes += " data-at=\"" + markup_text(cell.at) + "\"";
  const std::string text = cell.show == Show::share && is_number(cell.value) ? "" : text_of(cell.value);
  if (cell.value.is_number_float() && text != cell.value.dump())
    attributes += " title=\"" + markup_text(cell.value.dump()) + "\"";
  const std::string content =
      cell.show == Show::share && is_number(cell.value) ? share_html(cell.value.get<double>()) : markup_text(text);
  const char* const name = is_header ? "th" : "td";
  return fmt::format("<{}{}>{}</{}>", name, attributes, content, name);
}

/// Whether a column has numbers; its title is then aligned with them.
bool is_column_of_numbers(const Table& table, std::size_t column) {
  for (const Row& row : table.rows)
    if (column < row.size() && is_number(row[column].value)) return true;
  return false;
}

}  // namespace

std::string table_html(const Table& table, const std::vector<std::string>& row_attributes) {
  constexpr std::size_t long_table = 30;  // rows; longer tables scroll
  std::string html =
      fmt::format("<div class=\"scroll{}\" tabindex=0 role=region aria-label=\"{}\"><table{}>",
                  table.rows.size() > long_table ? " long" : "",
                  markup_text(table.caption.empty() ? "table" : table.caption), table.is_list ? " class=list" : "");
  if (!table.caption.empty()) html += "<caption>" + markup_text(table.caption) + "</caption>";
  html += "<thead><tr>";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].empty()) {
      html += "<td></td>";
      continue;
    }
    html += fmt::format("<th scope=col{}>{}</th>", is_column_of_numbers(table, i) ? " class=n" : "",
                        markup_text(table.columns[i]));
  }
  html += "</tr></thead>\n<tbody>";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    html += "<tr" + (row_attributes.empty() ? "" : " " + row_attributes[i]) + ">";
    for (const Cell& cell : table.rows[i]) html += cell_html(cell, &cell == &table.rows[i].front());
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace csgsim::report
