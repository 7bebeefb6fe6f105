// Options that the studies of software share.
// Used by trace, classify, display, mesh and subdivide.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/software/work.h"

namespace csgsim::studies {

/// Parses names and files separated by commas. Throws as software::load_priced does.
std::vector<software::Priced> parse_processors(const std::string& processor_names);

/// Adds the option --processors.
void add_processors_option(session::OptionList& command, std::string& processor_names);

/// Adds the model options except those that only affect machines.
void add_model_options_without_machine(session::ModelRequest& model, session::OptionList& command);

/// Seconds with four significant digits; from 1,000 on rounded to an integer with grouped digits.
std::string seconds_text(double seconds);

/// The files of a model and of the listed processors.
std::vector<std::filesystem::path> model_and_processor_files(const session::ModelRequest& model,
                                                             const std::string& processor_names);

}  // namespace csgsim::studies
