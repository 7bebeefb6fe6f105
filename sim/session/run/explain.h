// The request behind csgsim explain.
// Used by sim/session, sim/app and sim/python.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/session/run/in_place.h"
#include "sim/story/answer.h"

namespace csgsim::session {

/// Options of a pixel's history.
struct ExplainRequest {
  ModelRequest model;
  std::string pixel;
  std::string point;
  std::string why_not;

  void add_to(OptionList& options);
};

/// Keys of options with their texts.
using GivenTexts = std::vector<std::pair<std::string, std::string>>;

/// The `csgsim explain` command line, without --pixel, for that model or Program. It has those options of the request
/// `options` that explain also accepts, and those in `replacements`, which replace them (lists of texts are appended).
std::string explain_command(const OptionList& options, const std::string& subject, const GivenTexts& replacements);

/// Throws UsageError if no pixel is given, or if an option does not apply to a Program.
void refuse_misuse(const ExplainRequest& request, const OptionList& options, const ContentReplacement& in_place = {});

/// Explains the requested pixel. Throws InputError, UsageError.
story::PixelExplanation explain(const ExplainRequest& request, const OptionList& options,
                                const ContentReplacement& in_place = {});

}  // namespace csgsim::session
