#pragma once

#include <string>

namespace csgsim::app {

/// Tells a model's file from what it was before.
std::string hash_of_file(const std::string& path);

}  // namespace csgsim::app
