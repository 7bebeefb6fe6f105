#include "sim/studies/processors.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "hw/base/text.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"

namespace csgsim::studies {

std::vector<software::Priced> parse_processors(const std::string& processor_names) {
  std::vector<software::Priced> processors;
  for (const std::string& name : session::parse_words(processor_names))
    processors.push_back(software::load_priced(name));
  return processors;
}

void add_processors_option(session::OptionList& command, std::string& processor_names) {
  command
      .option("--processors", processor_names,
              "Processors for which seconds are computed: names or .toml files, separated by commas; this-computer is "
              "measured")
      .check(session::check_by_parsing(parse_processors));
}

void add_model_options_without_machine(session::ModelRequest& model, session::OptionList& command) {
  model.add_to(command);
  for (const char* const of_machines : {"--memory-bits", "--strategy", "--stack-bits", "--colouring", "--pruning"})
    command.remove(of_machines);
}

std::string seconds_text(double seconds) {
  constexpr double grouped_from = 1000;
  return seconds < grouped_from ? fmt::format("{:.4g}", seconds)
                                : grouped(static_cast<std::uint64_t>(std::llround(seconds)));
}

std::vector<std::filesystem::path> model_and_processor_files(const session::ModelRequest& model,
                                                             const std::string& processor_names) {
  std::vector<std::filesystem::path> files = model.inputs();
  const std::vector<std::filesystem::path> more = session::input_files({}, session::parse_words(processor_names));
  files.insert(files.end(), more.begin(), more.end());
  return files;
}

}  // namespace csgsim::studies
