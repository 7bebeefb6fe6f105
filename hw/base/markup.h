// Escapes text for HTML and XML.
// Used by sim/report and sim/plots.
#pragma once

#include <string>
#include <string_view>

namespace csgsim {

/// Escapes untrusted bytes for the text of an HTML or XML element or a quoted attribute. The result is printable
/// (hw/base/text.h) and contains no markup.
std::string markup_text(std::string_view bytes);

}  // namespace csgsim
