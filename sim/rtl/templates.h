// Embedded Verilog and templates.
// Used by design.cpp and templates.cpp.in.
#pragma once

#include <span>
#include <string_view>

namespace csgsim::rtl {

/// An embedded text file.
struct EmbeddedFile {
  std::string_view name;  ///< without folders
  std::string_view text;
};

/// The Verilog of hw/rtl: one file per module, and their include files.
std::span<const EmbeddedFile> verilog_files();

/// A template of a design, with @NAMES@ for the parts that depend on the design. Throws std::out_of_range for an
/// unknown name.
std::string_view template_text(std::string_view name);

}  // namespace csgsim::rtl
