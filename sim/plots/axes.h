#pragma once

#include <string>

#include "sim/plots/drawing.h"
#include "sim/plots/extent.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

inline constexpr double title_height = 40;
inline constexpr double side_margin = 10;
inline constexpr double right_margin = 30;

void add_title(Drawing& drawing, const std::string& title);

/// Ticks and title below an area, whose pixels are of that extent. Ticks whose texts would meet their neighbours' stand
/// upright if they are names, and are left out where that is not enough. Returns where the axis ends.
double add_x_axis(Drawing& drawing, const Axis& axis, const Extent& extent, const Box& area);

/// Ticks left of an area, and the title at the left edge of the picture, in two lines where one is too long.
void add_y_axis(Drawing& drawing, const Axis& axis, const Extent& extent, const Box& area);

/// Lines across the area at the ticks of both axes, and its frame.
void add_grid(Drawing& drawing, const std::vector<Tick>& x_ticks, const Extent& x, const std::vector<Tick>& y_ticks,
              const Extent& y, const Box& area);

/// Those of the axis, or those of the extent where the axis has none; for an axis of so many pixels upwards.
std::vector<Tick> ticks_of(const Axis& axis, const Extent& extent, double pixels);

/// The same for an axis below an area.
std::vector<Tick> x_ticks_of(const Axis& axis, const Extent& extent);

/// Pixels left of an area for an axis of so many pixels upwards, with these ticks.
double room_for_y_axis(const Axis& axis, const std::vector<Tick>& ticks, double pixels);

}  // namespace csgsim::plots
