#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace csgsim::app {

/// One line for people about a command line that could not be read; unknown commands and options name the nearest known
/// one.
std::string explain(CLI::App& app, const CLI::ParseError& error, std::span<char* const> arguments);

}  // namespace csgsim::app
