#pragma once

#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// The boundary of a model (thesis 5.4.2), of its primitives in facets. Throws InputError, naming the primitive's place
/// in the file, where one cannot be faceted, and WorkError past the limit on work;
/// std::logic_error if it is not closed, which would be a fault of ours. It is the same on any number of threads.
Outlines boundary(const model::Tree& tree, const facet::Faceting& faceting = {}, const Work& work = {},
                  unsigned threads = 1);

}  // namespace csgsim::software::convert
