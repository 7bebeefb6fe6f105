#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/software/work.h"

/// What studies of software have in common.
namespace csgsim::studies {

/// Names and files with commas between them. Throws as software::priced does.
std::vector<software::Priced> processors_in(const std::string& list);

/// --processors, this-computer among them.
void add_processors(session::OptionList& command, std::string& list);

/// The options of a model without those that only machines have a use for.
void add_model_without_machine(session::ModelRequest& model, session::OptionList& command);

/// Four digits; of 1000 seconds and more those before the point, in groups.
std::string seconds_text(double seconds);

/// The files of a model, and those of processors.
std::vector<std::filesystem::path> inputs_with_processors(const session::ModelRequest& model, const std::string& list);

}  // namespace csgsim::studies
