#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/session/run/report_option.h"
#include "sim/studies/advise/advice.h"
#include "sim/studies/design/meter.h"

namespace csgsim::studies {

/// Options of csgsim advise. What is searched are lists and ranges, checked when the command line is read.
struct AdviseOptions {
  session::ModelRequest model;
  std::string z_bits = "10..20";
  std::string fraction_bits = "2,4,6,8,10,12";
  std::string colour_bits = "12,15,18,21,24";
  std::string strategies;  ///< empty: all that the machine can draw by
  std::string stack_bits = "3..8";
  std::string colourings = "rebroadcast,field";
  std::string alu_bits;  ///< empty: the machine's own
  std::optional<std::uint32_t> max_bits;
  std::optional<std::uint64_t> max_wrong_pixels;
  std::optional<double> min_fps;
  std::optional<std::uint32_t> min_colour_bits;

  void add_to(session::OptionList& command);

  /// As `csgsim render` draws the choice.
  [[nodiscard]] session::ModelRequest design(const DesignPoint& point) const;
};

/// Names of the options that ask for wishes or lists: all others are those of `csgsim render`, but for those without
/// effect on results.
std::vector<std::string> own_options();

/// All that is asked for.
struct AdviceQuestion {
  std::vector<DesignPoint> points;  ///< z bits and fraction bits vary slowest, ALU widths fastest
  std::map<unsigned, Job> jobs;     ///< by ALU width, but for what else points say
  DesignQuestion measured;
  Wishes wishes;

  [[nodiscard]] Job job_of(const AdviseOptions& options, const DesignPoint& point) const;
};

/// Reads the model and the machine. Throws InputError, or UsageError for an ALU that the machine has not.
AdviceQuestion question_of(const AdviseOptions& options);

/// The model as the choice draws it.
report::Picture picture_of(const AdviseOptions& options, const AdviceRow& row, const std::string& caption);

/// `csgsim render` with all options that draw the choice, on a machine with just its memory, and judge it; its picture
/// is called `picture`.
std::string render_command(const AdviseOptions& options, const session::OptionList& command, const AdviceRow& row,
                           const std::string& picture);

}  // namespace csgsim::studies
