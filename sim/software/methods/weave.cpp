#include "sim/software/methods/weave.h"

#include "sim/software/methods/rows.h"
#include "sim/software/methods/whole.h"

namespace csgsim::software {

extern const MethodRow weave_row{
    .name = "weave",
    .help = "inserts intervals into partitions of the ray and evaluates these from the front",
    .source = "BRL-CAD, src/librt/bool.c",
    .takes = Takes::intervals,
    .make = make_whole<Weave>};

}  // namespace csgsim::software
