#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <tuple>

#include "sim/app/model_options.h"
#include "sim/study/sweep_run.h"

namespace csgsim::app {

/// A model of a study of many, or why it cannot be read.
struct ReadSubject {
  std::shared_ptr<const study::Subject> subject;  ///< null where it cannot be read
  std::string reason;                             ///< escaped(); empty where it can
  std::string hash;  ///< of what was read; of a model that cannot be, of its bytes, as far as there are any, and why
};

/// What a model's facets and quadrics depend on, beside the options of a study that its machines share: of two machines
/// with equal keys they are the same.
using SubjectKey = std::tuple<std::string, std::uint32_t, std::uint32_t, std::string>;

SubjectKey subject_key(const ModelOptions& options, const machines::Machine& machine);

/// Reads and facets the model. InputErrors are its reason.
ReadSubject read_subject(const ModelOptions& options, const machines::Machine& machine);

}  // namespace csgsim::app
