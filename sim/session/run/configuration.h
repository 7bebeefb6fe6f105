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

/// The `configuration` of a stats file: all that a run follows from. docs/settings.md describes every key.
namespace csgsim::session {

/// What a command runs, beside its options.
struct RunSubject {
  const machines::Machine& machine;
  const isa::Program& program;
  std::vector<std::filesystem::path> inputs;  ///< the subject's file first
  std::string hash;                           ///< of what was compiled or run; if empty, of the subject's file
  const view::Camera* camera = nullptr;       ///< none of a Program
  const std::vector<scene::SectionValues>* scene = nullptr;
  std::function<story::HalfspaceFinder()> halfspaces{};  ///< of a model, for the page of a run
  bool is_in_place = false;  ///< the subject's file is a name alone; what stands in its place has the hash
};

nlohmann::ordered_json configuration_of(const OptionList& options, const RunSubject& subject);

/// The machine as it was used: `name`, `hash`, and `figures` with value, unit and provenance.
nlohmann::ordered_json machine_json(const machines::Machine& machine);

/// Puts the configuration before the time that the run took, the last key of a stats file.
void put_configuration(nlohmann::ordered_json& stats, nlohmann::ordered_json configuration,
                       const observe::Frame& picture);

}  // namespace csgsim::session
