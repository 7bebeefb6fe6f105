// The `configuration` section of stats files.
// Used by finished_run.h, frames.cpp and report_option.cpp.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hw/machines/machine.h"
#include "sim/observe/frame.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/story/halfspaces.h"

/// The `configuration` of a stats file: everything that determines a run. docs/settings.md describes every key.
namespace csgsim::session {

/// The subject of a command's run, without its options.
struct RunSubject {
  const machines::Machine& machine;
  const isa::Program& program;
  std::vector<std::filesystem::path> inputs;  ///< the subject's file first
  std::string hash;                           ///< hash of what was compiled or run; if empty, of the subject's file
  const view::Camera* camera = nullptr;       ///< null for a Program
  const std::vector<scene::SectionValues>* scene = nullptr;
  std::function<story::HalfspaceFinder()> halfspaces{};  ///< used by the page of a model's run; empty for a Program
  bool is_in_place = false;  ///< the subject's file is only a name; the hash is that of its replacement
};

/// The configuration of a run of the subject with these options.
nlohmann::ordered_json configuration_of(const OptionList& options, const RunSubject& subject);

/// The machine as used: `name`, `hash`, and `figures` with value, unit and provenance.
nlohmann::ordered_json machine_json(const machines::Machine& machine);

/// Inserts the configuration before the wall time, which is the last key of a stats file.
void insert_configuration(nlohmann::ordered_json& stats, nlohmann::ordered_json configuration,
                          const observe::Frame& picture);

}  // namespace csgsim::session
