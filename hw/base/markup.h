#pragma once

#include <string>
#include <string_view>

namespace csgsim {

/// Bytes from outside as text of an element of HTML or XML, or of an attribute in quotes: printable (hw/base/text.h),
/// and no markup.
std::string markup_text(std::string_view bytes);

}  // namespace csgsim
