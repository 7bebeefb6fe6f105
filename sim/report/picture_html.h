#pragma once

#include <string>

#include "sim/report/page.h"

namespace csgsim::report {

std::string gallery_html(const Gallery& gallery);

/// The picture, the picture of its owners and the table of primitives; page.js makes one of the three.
std::string owners_html(const OwnerPicture& owners);

/// What page.js needs to know whose each pixel is.
Json owners_json(const OwnerPicture& owners);

}  // namespace csgsim::report
