#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/report/page.h"

/// Parts of a page as HTML, and what page.js needs to know of them as JSON.
namespace csgsim::report {

/// What page.css, page.js and drawing.js hold.
extern const std::string_view page_style;
extern const std::string_view page_script;
extern const std::string_view drawing_script;

/// JSON as the content of a script element that no script runs: nothing in it ends the element or begins a comment.
std::string json_in_html(const Json& json);

/// A word for an element's id: letters, digits and dashes.
std::string html_id(std::string_view text);

/// A table in a box of its own, which scrolls where the window is too narrow. A cell whose value the page's data hold
/// says where, in data-at. `more` are attributes of the rows, one a row, or none.
std::string table_html(const Table& table, const std::vector<std::string>& more = {});

/// A plot as a figure: the picture that its file has too, in a box which scrolls where the window is too narrow, and
/// its values as tables.
std::string plot_html(const plots::Plot& plot);

std::string gallery_html(const Gallery& gallery);

/// The picture, the picture of its owners and the table of primitives; page.js makes one of the three.
std::string owners_html(const OwnerPicture& owners);

/// Whose each pixel is.
Json owners_json(const OwnerPicture& owners);

/// Where drawing.js puts the drawing's controls, and what is said of it. `id`: of its data.
std::string drawing_html(const Drawing& drawing, const std::string& id);

/// The steps, each as [number, text, serves, clocks, enabled, changes in base 64], and the stories, with their texts in
/// parts: an event as [text, step], all else as text.
Json drawing_json(const Drawing& drawing);

}  // namespace csgsim::report
