#pragma once

#include <span>
#include <string_view>

namespace csgsim::rtl {

/// A text that comes with the program.
struct EmbeddedFile {
  std::string_view name;  ///< without folders
  std::string_view text;
};

/// The Verilog of hw/rtl: one file a module, and what they include.
std::span<const EmbeddedFile> verilog_files();

/// What is written around it for a design, with @NAMES@ in place of what depends on the design.
/// Throws std::out_of_range for a name that there is none of.
std::string_view template_text(std::string_view name);

}  // namespace csgsim::rtl
