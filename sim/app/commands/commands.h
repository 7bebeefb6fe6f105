#pragma once

#include <span>
#include <string_view>

#include "sim/shell/command_line.h"

namespace csgsim::app {

using namespace session;  // whose requests commands read,
using namespace shell;    // and show

/// A row of the table of commands, except studies. Each command has its own file.
struct CommandRow {
  std::string_view name;
  void (*add)(CommandLine& line) = nullptr;  ///< describes the command on the line
  bool asks_others = false;                  ///< it runs or describes other commands
};

/// The commands, in the order of help.
std::span<const CommandRow* const> commands();

/// Subjects of commands in help, in its order.
inline constexpr std::string_view drawing = "Models and Programs";
inline constexpr std::string_view looking = "Looking into a run";
inline constexpr std::string_view hardware = "Hardware";
inline constexpr std::string_view studying = "Studies";
inline constexpr std::string_view manuals = "Manual";

}  // namespace csgsim::app
