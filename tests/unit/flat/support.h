#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat {

/// What OpenSCAD made of tests/unit/flat/openscad/NAME.scad.
Area openscad(const std::string& name);

/// The bytes of tests/unit/flat/drawings/NAME.
std::string drawing(const std::string& name);

/// Has the reader read each drawing of that extension with some of its bytes changed, left out or doubled, many times.
/// Fails the test if anything else than an InputError of one printable line comes of it.
void check_mutations(const std::string& extension, const std::function<void(const std::string&)>& read);

/// Above 0 if the corners run counter-clockwise.
double signed_area(const Outline& outline);

/// Of the outlines, holes subtracted.
double area_of(const Area& area);

std::size_t corners(const Area& area);

/// What is in one of them but not in both. Each is what an odd number of its outlines hold.
double difference(const Area& a, const Area& b);

/// Fails the test if they differ by more than OpenSCAD rounds what it exports, or in the numbers of their outlines and
/// corners.
void check_as_openscad(const Area& area, const std::string& name);

/// The same without the number of corners, which Clipper 6.2 of OpenSCAD and 6.4 have in a different way where round
/// strokes turn.
void check_area_as_openscad(const Area& area, const std::string& name);

/// Fails the test where an outline breaks what area.h promises of its orientation: outer ones and holes alternate.
void check_orientation(const Area& area);

}  // namespace csgsim::flat
