// Options of csgsim advise, and the points that they select.
// Used by csgsim advise.
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

/// Options of csgsim advise. Lists and ranges are checked when the command line is parsed.
struct AdviseOptions {
  session::ModelRequest model;
  std::string z_bits = "10..20";
  std::string fraction_bits = "2,4,6,8,10,12";
  std::string colour_bits = "12,15,18,21,24";
  std::string strategies;  ///< empty: all strategies of the machine
  std::string stack_bits = "3..8";
  std::string colourings = "rebroadcast,field";
  std::string alu_bits;  ///< empty: the machine's own
  std::optional<std::uint32_t> max_bits;
  std::optional<std::uint64_t> max_wrong_pixels;
  std::optional<double> min_fps;
  std::optional<std::uint32_t> min_colour_bits;

  void add_to(session::OptionList& command);

  /// The `csgsim render` request that draws the choice.
  [[nodiscard]] session::ModelRequest design(const DesignPoint& point) const;
};

/// Names of the options for requirements and lists. All others are those of `csgsim render`, except the options without
/// effect on results.
std::vector<std::string> advise_only_options();

/// Points, inputs and requirements of a search.
struct AdviceSearch {
  std::vector<DesignPoint> points;  ///< z bits and fraction bits vary slowest, ALU widths fastest
  std::map<unsigned, Job> jobs;     ///< by ALU width; the point supplies the other settings
  MeasurementSettings measured;
  Requirements requirements;

  [[nodiscard]] Job make_job(const AdviseOptions& options, const DesignPoint& point) const;
};

/// Reads the model and the machine. Throws InputError, or UsageError if the machine does not support the ALU.
AdviceSearch make_search(const AdviseOptions& options);

/// The picture of a choice.
report::Picture picture_of(const AdviseOptions& options, const AdviceRow& row, const std::string& caption);

/// The `csgsim render` command with all options of the choice, on a machine with exactly its memory, and with --check.
/// `picture` is the output file.
std::string render_command(const AdviseOptions& options, const session::OptionList& command, const AdviceRow& row,
                           const std::string& picture);

}  // namespace csgsim::studies
