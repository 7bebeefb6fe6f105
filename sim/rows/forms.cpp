#include "sim/rows/forms.h"

#include <algorithm>
#include <array>

namespace csgsim::rows {

std::span<const FormRow* const> forms() {
  static constexpr std::array<const FormRow*, 6> rows{&csgsim_form,   &ramulator2_form, &ramulator2_accesses_form,
                                                      &dramsim3_form, &drampower_form,  &drampower4_form};
  return rows;
}

std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const FormRow* row : forms()) names.emplace_back(row->name);
  return names;
}

const FormRow& form_named(std::string_view name) {
  const auto found = std::ranges::find_if(forms(), [&](const FormRow* row) { return row->name == name; });
  return **found;
}

}  // namespace csgsim::rows
