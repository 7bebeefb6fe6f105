#pragma once

#include "hw/base/hash.h"

namespace csgsim::study {

using csgsim::Hash;

}  // namespace csgsim::study
