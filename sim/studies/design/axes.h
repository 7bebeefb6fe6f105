// Options that designs vary.
// Used by sweep, accuracy, advise and explore.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// An option of `csgsim render` that designs vary, in addition to machine parameters.
struct Axis {
  std::string_view key;  ///< name of the option
  const char* title;     ///< title of a plot's axis
  const char* prefix;    ///< precedes the value in the name of a series
  bool is_number;
  std::string_view default_value;  ///< default value, omitted from commands
  /// Parses a list separated by commas. Throws InputError, or UsageError, for an invalid value.
  std::vector<std::string> (*values)(const std::string& list);
  void (*put)(session::ModelRequest& options, const std::string& value);   ///< sets a value returned by `values`
  void (*read)(const session::ModelRequest& options, DesignPoint& point);  ///< sets the point's value
  std::string (*text)(const DesignPoint& point);                           ///< empty if the point has no value
};

/// All axes, in the order of help and of names of designs.
std::span<const Axis> axes();

/// nullptr if no axis has the key.
const Axis* find_axis(std::string_view key);

std::vector<std::string> axis_keys();

/// Sets the option, or the machine parameter, to the value. Throws InputError, or UsageError, if the option does not
/// accept it; parameters are checked when the machine is loaded.
void set_option(session::ModelRequest& request, const std::string& key, const std::string& value);

/// Like set_option(), but does not check the value.
void put(session::ModelRequest& request, const std::string& key, const std::string& value);

/// The point of a design, except its memory bits, which depend on the study.
DesignPoint point_of(const session::ModelRequest& design, const machines::Size& size);

/// Name such as `stack` or `bits 5`.
std::string strategy_name(const DesignPoint& point);

/// Keys and values that distinguish designs: changed machine parameters, and the axes.
std::vector<std::pair<std::string, std::string>> distinguishing_options(const DesignPoint& point);

/// Options of `csgsim render` that draw the point, quoted for a shell and each preceded by a space, without those of
/// the axes `excluded_keys`.
std::string render_options(const DesignPoint& point, std::span<const std::string_view> excluded_keys = {});

/// An option and its value, quoted for a shell and preceded by a space.
std::string shell_option(const std::string& name, const std::string& value);

/// Command-line text of the options given to a study, except `command_options`, which only the study has, and of
/// `--set` with each of `set_values`.
std::string join_given_options(const session::OptionList& command, const std::vector<std::string>& command_options,
                               const std::vector<std::string>& set_values);

}  // namespace csgsim::studies
