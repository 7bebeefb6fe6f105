#pragma once

#include <memory>
#include <string>

#include "sim/app/model_options.h"
#include "sim/study/sweep_run.h"

namespace csgsim::app {

/// A model of a study of many, or why it cannot be read.
struct ReadSubject {
  std::shared_ptr<const study::Subject> subject;  ///< null where it cannot be read
  std::string reason;                             ///< escaped(); empty where it can
  std::string hash;  ///< of what was read; of a model that cannot be, of its bytes, as far as there are any, and why
};

/// Reads and facets the model. InputErrors are its reason.
ReadSubject read_subject(const ModelOptions& options, const machines::Machine& machine);

}  // namespace csgsim::app
