#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/input_file.h"
#include "hw/base/standard_streams.h"
#include "sim/app/commands/commands.h"
#include "sim/session/model/model_request.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/viewer/door.h"
#include "sim/viewer/knobs.h"
#include "sim/viewer/page.h"
#include "sim/viewer/serve.h"
#include "sim/viewer/session.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelRequest model;
  unsigned port = 0;
  unsigned patience = 10;
  unsigned evaluation_time = 10;
};

bool is_knob(const std::string& name) { return std::ranges::find(viewer::knobs, name) != viewer::knobs.end(); }

/// Options that csgsim render does not have.
bool is_own(const std::string& name) { return name == "port" || name == "patience" || name == "evaluation-time"; }

viewer::StartCommand beginning_of(const Options& options, const OptionList& command) {
  viewer::StartCommand beginning{options.model.model, {}, viewer::Json::object()};
  for (const OptionValue& one : command.values()) {
    if (one.is_operand || one.values.empty() || !command.is_given(one.name)) continue;
    if (is_own(one.name)) continue;
    const bool is_flag = one.takes == Takes::flag;
    if (!is_knob(one.name)) {
      for (const std::string& value : one.values)
        for (std::string& word : option_words(one.name, value)) beginning.words.push_back(std::move(word));
    } else if (one.name == "set") {
      beginning.knobs[one.name] = one.values;
    } else if (is_flag) {
      beginning.knobs[one.name] = true;
    } else {
      beginning.knobs[one.name] = one.values.back();
    }
  }
  return beginning;
}

void run(const Options& options, const OptionList& command) {
  if (options.model.model == standard_stream)
    throw UsageError("MODEL", "must be a file; standard input cannot be read again for each picture");
  if (!is_model(options.model.model))
    throw UsageError("MODEL", fmt::format("{} is a Program; use csgsim debug to step through it", options.model.model));
  // The inputs are read again for each picture, and opening a pipe would block.
  for (const std::filesystem::path& file : options.model.inputs())
    static_cast<void>(open_regular_file(file, {"a regular file", 0, ""}));
  viewer::Session session(beginning_of(options, command),
                          {.evaluation_time = std::chrono::seconds(options.evaluation_time)});
  viewer::Door door{0, viewer::make_token()};
  const auto gate = [&](const viewer::Request& head) -> std::optional<viewer::Reply> {
    viewer::Admission admission = viewer::admit(door, head);
    return admission.is_admitted ? std::nullopt : std::optional(std::move(admission.refusal));
  };
  const auto handler = [&](const viewer::Request& request) -> viewer::Reply {
    const std::string_view path = viewer::admit(door, request).path;
    if (request.method == "GET")
      if (std::optional<viewer::Reply> file = viewer::page_file(path)) return *std::move(file);
    return session.answer(request, path);
  };
  viewer::serve(
      {.port = static_cast<std::uint16_t>(options.port),
       .patience = std::chrono::seconds(options.patience),
       .begun =
           [&](std::uint16_t port) {
             door.port = port;
             fmt::print("{}\nopen this address in a browser; the server stops when the page is closed, or at Ctrl-C\n",
                        door.address());
             std::fflush(stdout);
           },
       .gate = gate,
       .handler = handler,
       .stays = [&](const viewer::Request& request) { return viewer::admit(door, request).path == "alive"; },
       .tick = [&] { session.end_overdue(); },
       .ending = [&] { session.close(); }});
}

void add_view(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("view", everyday_group, "Show a model in a browser, redrawn by the machine as you turn and edit it",
               "Example:\n  csgsim view carburettor.csg\n"
               "  csgsim view carburettor.scad --machine pixel-planes-5 --port 8080");
  options->model.add_to(command, "The model (.csg, .scad or .jan), or a mesh");
  command.option("--port", options->port, "Port of 127.0.0.1 for the page; 0 selects a free one").between(0U, 65'535U);
  command
      .option("--patience", options->patience,
              "Seconds to keep running after the last page is closed; 0 runs until interrupted")
      .between(0U, 86'400U);
  command
      .option("--evaluation-time", options->evaluation_time,
              "Time limit in seconds for evaluating the source before a picture, in OpenSCAD and in csgsim; "
              "--openscad-time can only shorten OpenSCAD's part")
      .between(1U, 86'400U);
  command.set_action([options, &command] { run(*options, command); });
}

}  // namespace

extern const CommandRow view_row{.name = "view", .add = add_view};

}  // namespace csgsim::app
