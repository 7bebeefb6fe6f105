// HTML of the parts of a page.
// Used by sim/report and sim/viewer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/report/page.h"

/// Parts of a page as HTML, and their data for page.js as JSON.
namespace csgsim::report {

/// Contents of page.css, page.js and drawing.js.
extern const std::string_view page_style;
extern const std::string_view page_script;
extern const std::string_view drawing_script;

/// JSON as the content of a data script element: nothing in it can end the element or start a comment.
std::string json_in_html(const Json& json);

/// Converts a text to an element id: letters, digits and dashes.
std::string html_id(std::string_view text);

/// A table in its own box, which scrolls in narrow windows. A cell whose value is in the page's data has its JSON
/// pointer in data-at. `row_attributes` has the HTML attributes of each row, or is empty.
std::string table_html(const Table& table, const std::vector<std::string>& row_attributes = {});

/// A plot as a figure: the same picture as in its file, in a box which scrolls in narrow windows, and its values as
/// tables.
std::string plot_html(const plots::Plot& plot);

std::string gallery_html(const Gallery& gallery);

/// The picture, the picture of its owners and the table of primitives; page.js combines them.
std::string owners_html(const OwnerPicture& owners);

/// The owner of each pixel.
Json owners_json(const OwnerPicture& owners);

/// Container for the controls of drawing.js, with the summary of the drawing. `id` is the id of its data.
std::string drawing_html(const Drawing& drawing, const std::string& id);

/// The steps, each as [number, text, serves, clocks, enabled, changes in base 64], and the stories, with their texts in
/// parts: events as [text, step], all others as text.
Json drawing_json(const Drawing& drawing);

}  // namespace csgsim::report
