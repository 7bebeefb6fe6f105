// Counts of a run on pages.
// Used by run_page.cpp and two_page.cpp.
#pragma once

#include <array>
#include <utility>

namespace csgsim::report {

/// Counts of a run on pages: name and JSON pointer into the stats. Not every run has all of them.
inline constexpr auto run_counts = std::to_array<std::pair<const char*, const char*>>({
    {"primitives", "/model/primitives"},
    {"half-spaces", "/model/halfspaces"},
    {"clocks until drawn", "/clocks"},
    {"clocks until shown", "/shown_clocks"},
    {"clocks from one frame to the next", "/interval_clocks"},
    {"seconds until drawn", "/simulated_seconds"},
    {"seconds until shown", "/frame_seconds"},
    {"frames per second", "/frames_per_second"},
    {"frames per second with the host", "/hosted_frames_per_second"},
    {"clocks of the host per frame", "/host_clocks"},
    {"clocks of the host for the model", "/host_model_clocks"},
    {"instructions executed", "/instructions/total"},
    {"instructions skipped", "/instructions/skipped"},
    {"scan-conversions, rendered", "/scan_conversions/rendered"},
    {"scan-conversions, classified", "/scan_conversions/classified"},
    {"depth tests", "/depth_tests"},
    {"pixel operations", "/pixel_operations/total"},
    {"pixel operations at enabled pixels", "/pixel_operations/enabled"},
    {"memory bits per pixel, used", "/memory/used_bits"},
    {"memory bits per pixel, available", "/memory/memory_bits"},
    {"wrong pixels", "/accuracy/wrong"},
});

}  // namespace csgsim::report
