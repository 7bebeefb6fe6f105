// Boundaries of models.
// Used by sim/app.
#pragma once

#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// The boundary of a model with faceted primitives (thesis 5.4.2). Throws InputError, with the primitive's place in the
/// file, if it cannot be faceted, WorkError beyond the work limit, and std::logic_error if the boundary is not closed,
/// which would be an error in csgsim. The result does not depend on the number of threads.
Outlines boundary(const model::Tree& tree, const facet::Faceting& faceting = {}, const Work& work = {},
                  unsigned threads = 1);

}  // namespace csgsim::software::convert
