#pragma once

#include <string>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/session/run/in_place.h"
#include "sim/story/answer.h"

namespace csgsim::session {

/// Options of a pixel's story.
struct ExplainRequest {
  ModelRequest model;
  std::string pixel;
  std::string point;
  std::string why_not;

  void add_to(OptionList& options);
};

/// Throws UsageError where it is not said which pixel, or what is said is not for a Program.
void refuse_misuse(const ExplainRequest& request, const OptionList& options, const InPlace& in_place = {});

/// Throws InputError, UsageError.
story::Answer explain(const ExplainRequest& request, const OptionList& options, const InPlace& in_place = {});

}  // namespace csgsim::session
