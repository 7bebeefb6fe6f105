// Table of the text forms of row-command traces.
// Used by sim/rows and the rows command.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/rows/form.h"

namespace csgsim::rows {

struct FormRow {
  std::string_view name;
  std::unique_ptr<Form> (*make)(const Frame& frame) =
      nullptr;  ///< throws InputError if the frame does not fit the form
};

extern const FormRow csgsim_form;
extern const FormRow ramulator2_form;
extern const FormRow ramulator2_accesses_form;
extern const FormRow dramsim3_form;
extern const FormRow drampower_form;
extern const FormRow drampower4_form;

/// All forms; the first is the default.
std::span<const FormRow* const> forms();

std::vector<std::string> form_names();

/// The form of that name, which must be one of form_names().
const FormRow& form_named(std::string_view name);

}  // namespace csgsim::rows
