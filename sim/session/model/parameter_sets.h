// Files of parameter sets, as OpenSCAD's customizer saves them.
// Used by sim/session.
#pragma once

#include <string>

namespace csgsim::session {

/// Throws InputError if the file is not one of parameter sets or lacks the set; OpenSCAD 2021.01 would use the
/// source's own values without a message.
void require_parameter_set(const std::string& file, const std::string& set);

}  // namespace csgsim::session
