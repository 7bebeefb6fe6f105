#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace csgsim::testing {

// Models in the format that OpenSCAD prints, with 17 digits.

/// A box from one corner to the other.
std::string box(const glm::dvec3& low, const glm::dvec3& high);

/// $fn of round shapes.
inline constexpr unsigned round_fragments = 64;

std::string ball(const glm::dvec3& centre, double radius, unsigned fragments = round_fragments);

/// An upright cylinder; `foot` is the centre of its lower end.
std::string cylinder(const glm::dvec3& foot, double height, double low_radius, double high_radius,
                     unsigned fragments = round_fragments);

/// A cylinder with a single radius.
std::string rod(const glm::dvec3& foot, double height, double radius);

/// A tetrahedron with four arbitrary corners.
std::string tetrahedron(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

std::string unite(std::initializer_list<std::string> parts);
std::string subtract(std::initializer_list<std::string> parts);
std::string intersect(std::initializer_list<std::string> parts);
std::string unite(std::span<const std::string> parts);
std::string subtract(std::span<const std::string> parts);
std::string intersect(std::span<const std::string> parts);

/// The model `csg` under a matrix in the form that OpenSCAD prints, "[[1,0,0,0],...]".
std::string with_transform(const std::string& matrix, const std::string& csg);

/// A rotation about x, then about z, by degrees.
std::string rotation(double about_x, double about_z);
std::string translation(const glm::dvec3& by);
std::string scaling(const glm::dvec3& by);

/// Rotations applied to the hard cases.
namespace turns {
inline constexpr std::string_view none = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
inline constexpr std::string_view right_angle = "[[0,-1,0,0],[1,0,0,0],[0,0,1,0],[0,0,0,1]]";
/// 17.3 degrees about x, then 41.9 about z, with all digits.
inline constexpr std::string_view arbitrary =
    "[[0.744311546231154,-0.6376203445955327,0.19859662208824852,0],"
    "[0.6678325554710466,0.7106394869588201,-0.22133955233513164,0],[0,0.297374874077786,0.9547607995027975,0],[0,0,0,"
    "1]]";
/// 1e-7 degrees about z.
inline constexpr std::string_view hair =
    "[[0.999999999999995,-9.99999999999998e-8,0,0],[9.99999999999998e-8,0.999999999999995,0,0],[0,0,1,0],[0,0,0,1]]";
}  // namespace turns

}  // namespace csgsim::testing
