#pragma once

#include <string_view>

namespace csgsim::shell {

/// Where help has an option, and what it calls its value.
struct OptionSubject {
  std::string_view subject;
  std::string_view option;  ///< its first long name, without dashes
  std::string_view value;   ///< empty: by its type
};

/// The subject of an option, one for all that are not in the table (option_subjects.cpp).
const OptionSubject& subject_of_option(std::string_view option);

/// The place of a subject in help.
int place_of_subject(std::string_view subject);

/// The same for commands.
std::string_view subject_of_command(std::string_view command);

}  // namespace csgsim::shell
