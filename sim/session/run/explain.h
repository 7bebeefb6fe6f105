#pragma once

#include <string>
#include <utility>
#include <vector>

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

/// Keys of options, and their texts.
using GivenTexts = std::vector<std::pair<std::string, std::string>>;

/// The command line that tells a pixel's story, all but its --pixel: of that model or Program, with the options of the
/// request `asked` that `explain` takes too, and with those in `instead`, which replace them (lists of texts are
/// appended).
std::string explain_command(const OptionList& asked, const std::string& subject, const GivenTexts& instead);

/// Throws UsageError where it is not said which pixel, or what is said is not for a Program.
void refuse_misuse(const ExplainRequest& request, const OptionList& options, const InPlace& in_place = {});

/// Throws InputError, UsageError.
story::Answer explain(const ExplainRequest& request, const OptionList& options, const InPlace& in_place = {});

}  // namespace csgsim::session
