#pragma once

#include <span>
#include <vector>

#include "tests/performance/program_work.h"
#include "tests/performance/rounds.h"

namespace csgsim::bench {

/// Seconds until all jobs are done where each, in this order, goes to the thread that is free first (list scheduling).
double makespan(std::span<const double> jobs, unsigned threads);

/// Seconds of all tiles on so many threads, which meet after each stretch.
double by_tiles(const Replay& replay, unsigned threads);

/// The same where each thread takes a whole segment, and they meet at the end.
double by_segments(const Replay& replay, unsigned threads);

}  // namespace csgsim::bench
