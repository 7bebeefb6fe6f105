#include "sim/session/run/explain.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hw/base/output_file.h"
#include "sim/app/commands/commands.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"

namespace csgsim::app {

namespace {

struct Options : session::ExplainRequest {
  std::string json;
};

void run(const Options& options, const OptionList& command) {
  session::refuse_misuse(options, command);
  refuse_clashes(options.model.inputs(), std::to_array<std::filesystem::path>({options.json}));
  std::optional<OutputFile> file;
  if (!options.json.empty()) file.emplace(options.json);
  const story::PixelExplanation answer = session::explain(options, command);
  if (!file) {
    fmt::print("{}", answer.text);
    return;
  }
  file->write(answer.json.dump(2) + "\n");
  file->commit();
}

void add_explain(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("explain", everyday_group, "Explain what a pixel shows: its owner and its history by instruction",
               "Example:\n  csgsim explain traces/thesis_fig_2_3.csgt --pixel 200,300 --why-not p1\n"
               "  csgsim explain thesis_fig_2_3.csg --point 10,0,6 --json story.json");
  options->add_to(command);
  command.option("--json", options->json, "Write the full history as .json instead of text; - prints it")
      .check(not_empty);
  command.set_action([options, &command] { run(*options, command); });
}

}  // namespace

extern const CommandRow explain_row{.name = "explain", .add = add_explain};

}  // namespace csgsim::app
