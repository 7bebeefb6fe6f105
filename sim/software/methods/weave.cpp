#include "sim/software/methods/weave.h"

#include "sim/software/methods/rows.h"
#include "sim/software/methods/whole.h"

namespace csgsim::software {

extern const MethodRow weave_row{
    .name = "weave",
    .help = "intervals are woven into partitions of the ray, which are evaluated from the front",
    .source = "BRL-CAD, src/librt/bool.c",
    .takes = Takes::intervals,
    .make = whole<Weave>};

}  // namespace csgsim::software
