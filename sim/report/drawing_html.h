#pragma once

#include <string>

#include "sim/report/page.h"

namespace csgsim::report {

/// Where page.js puts the drawing's controls, and what is said of it.
std::string drawing_html(const Drawing& drawing);

/// The steps, each as [number, text, serves, clocks, enabled, changes in base 64].
Json drawing_json(const Drawing& drawing);

}  // namespace csgsim::report
