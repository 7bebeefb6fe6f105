#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat {

/// Area exported by OpenSCAD from tests/unit/flat/openscad/NAME.scad.
Area openscad(const std::string& name);

/// Contents of tests/unit/flat/drawings/NAME.
std::string drawing(const std::string& name);

/// Reads each drawing with the extension many times, with some bytes changed, removed or duplicated. Fails the test for
/// any result other than success or an InputError of one printable line.
void check_mutations(const std::string& extension, const std::function<void(const std::string&)>& read);

/// Positive if the corners run counter-clockwise.
double signed_area(const Outline& outline);

/// Area of the outlines minus holes.
double area_of(const Area& area);

std::size_t corners(const Area& area);

/// Area of the symmetric difference; each operand follows the even-odd rule.
double difference(const Area& a, const Area& b);

/// Fails the test if the area and OpenSCAD's export `name` differ by more than the rounding of the export, or in the
/// numbers of outlines and corners.
void check_matches_openscad(const Area& area, const std::string& name);

/// Same check without the number of corners, which differs between OpenSCAD's Clipper 6.2 and version 6.4 where round
/// strokes turn.
void check_area_matches_openscad(const Area& area, const std::string& name);

/// Fails the test if an outline violates the orientation guaranteed by area.h: outer outlines and holes alternate.
void check_orientation(const Area& area);

}  // namespace csgsim::flat
