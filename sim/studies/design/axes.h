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

/// An option of `csgsim render` that designs vary, beside figures of the machine.
struct Axis {
  std::string_view key;  ///< the option's name
  const char* title;     ///< of a plot's axis
  const char* prefix;    ///< before its value in the name of a line
  bool is_number;
  std::string_view unsaid;  ///< the value that a command leaves out
  /// Those of a list with commas. Throws InputError, or UsageError, for one that it does not take.
  std::vector<std::string> (*values)(const std::string& list);
  void (*put)(session::ModelRequest& options, const std::string& value);  ///< of a value as `values` returns it
  void (*read)(const session::ModelRequest& options, DesignPoint& point);
  std::string (*text)(const DesignPoint& point);  ///< empty where the point has no value
};

/// All, in the order of help and of names of designs.
std::span<const Axis> axes();

/// Null, if no axis has the key.
const Axis* find_axis(std::string_view key);

std::vector<std::string> axis_keys();

/// Sets the option, or the figure of the machine, to that value. Throws InputError, or UsageError, for a value that the
/// option does not take; figures are checked when the machine is loaded.
void vary(session::ModelRequest& options, const std::string& key, const std::string& value);

/// The same without a check.
void put(session::ModelRequest& options, const std::string& key, const std::string& value);

/// The design as a point, but for its memory bits, which depend on the study.
DesignPoint point_of(const session::ModelRequest& design, const machines::Size& size);

/// As `stack`, or `bits 5`.
std::string strategy_name(const DesignPoint& point);

/// Keys and values that tell designs apart: the figures that were changed, and the axes.
std::vector<std::pair<std::string, std::string>> texts_of(const DesignPoint& point);

/// Options of `csgsim render` that draw the point, for a shell; with a blank before each.
std::string axis_words(const DesignPoint& point, std::span<const std::string_view> but = {});

/// An option and its value for a shell, behind a blank.
std::string shell_words(const std::string& name, const std::string& value);

/// Options that were given to a study and that `csgsim render` has too, and what was set: all but `own` ones.
std::string given_words(const session::OptionList& command, const std::vector<std::string>& own,
                        const std::vector<std::string>& sets);

}  // namespace csgsim::studies
