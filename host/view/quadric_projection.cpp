#include "host/view/quadric_projection.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>

#include "host/model/hypotenuse.h"
#include "hw/isa/depth_scale.h"

namespace csgsim::view {

namespace {

__extension__ using Wide = __int128;

/// 113 bits, because D is the small difference of much greater products if the eye is far away or the surface is steep.
using Real = boost::multiprecision::cpp_bin_float_quad;
using Vec = std::array<Real, 3>;

constexpr Wide sum_limit = Wide{1} << 61U;
constexpr int max_root_bits = 30;
constexpr int most_shift = 60;

/// a*x + b*y + c; columns and rows are relative to the middle pixel of a rectangle.
struct Linear {
  Real a;
  Real b;
  Real c;
};

/// Coefficients of x^2, x*y, y^2, x, y and 1, relative to the same pixel.
using Quadratic = std::array<Real, 6>;

void add_product(Quadratic& sum, const Linear& f, const Linear& g, const Real& factor) {
  const Real a = factor * f.a;
  const Real b = factor * f.b;
  const Real c = factor * f.c;
  sum[0] += a * g.a;
  sum[1] += a * g.b + b * g.a;
  sum[2] += b * g.b;
  sum[3] += a * g.c + c * g.a;
  sum[4] += b * g.c + c * g.b;
  sum[5] += c * g.c;
}

Real dot(const Vec& a, const glm::dvec3& b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }
Vec to_vec(const glm::dvec3& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }

/// The quadric on the rays of a picture: u = fixed * t + moving(x, y), where t is the distance from the eye in an
/// orthographic view, and its reciprocal in a perspective view. In a perspective view u is divided by the distance, and
/// the quadric's level is multiplied by t^2.
struct OnRays {
  std::array<double, 3> signs{};
  double level = 0;
  bool perspective = false;
  Vec fixed;
  std::array<Linear, 3> moving;

  [[nodiscard]] Real square_coefficient() const {
    Real sum = perspective ? level : 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += signs[i] * fixed[i] * fixed[i];
    return sum;
  }

  /// The sum of signs * fixed * moving: half the coefficient of t.
  [[nodiscard]] Linear half_linear() const {
    Linear sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real factor = signs[i] * fixed[i];
      sum.a += factor * moving[i].a;
      sum.b += factor * moving[i].b;
      sum.c += factor * moving[i].c;
    }
    return sum;
  }

  /// The square of half the coefficient of t minus the product of the other two coefficients, by Lagrange's identity:
  /// products of the ray's distances from the quadric's centre, which avoids cancellation of the distance to the eye.
  [[nodiscard]] Quadratic discriminant() const {
    Quadratic sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (signs[i] * signs[j] != 0.0) {
        const auto cross = [&](Real Linear::*part) { return fixed[i] * moving[j].*part - fixed[j] * moving[i].*part; };
        const Linear missed{cross(&Linear::a), cross(&Linear::b), cross(&Linear::c)};
        add_product(sum, missed, missed, -signs[i] * signs[j]);
      }
      if (perspective) {
        add_product(sum, moving[i], moving[i], -level * signs[i]);
      } else {
        sum[5] -= level * signs[i] * fixed[i] * fixed[i];
      }
    }
    return sum;
  }

  /// The negated value at t; it is not negative inside the quadric.
  [[nodiscard]] Quadratic depth_inside(const Real& t) const {
    Quadratic sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Linear u{moving[i].a, moving[i].b, moving[i].c + fixed[i] * t};
      add_product(sum, u, u, -signs[i]);
    }
    sum[5] -= perspective ? Real(level * t * t) : Real(level);
    return sum;
  }
};

/// The middle pixel of a rectangle, and the maximum distances of its pixels from it.
struct Middle {
  std::int64_t x;
  std::int64_t y;
  double across;
  double down;

  explicit Middle(const PixelRect& rect)
      : x((std::int64_t{rect.x0} + rect.x1) / 2), y((std::int64_t{rect.y0} + rect.y1) / 2) {
    across = static_cast<double>(std::max(x - rect.x0, rect.x1 - x));
    down = static_cast<double>(std::max(y - rect.y0, rect.y1 - y));
  }
};

OnRays on_rays(const EyeSpace& space, const facet::Quadric& quadric, const glm::dvec3& centre, const Middle& middle) {
  OnRays rays;
  rays.signs = quadric.signs();
  rays.level = quadric.level();
  rays.perspective = space.perspective;
  Vec eye = to_vec(space.eye);
  for (int i = 0; i < 3; ++i) {
    eye[static_cast<std::size_t>(i)] -= centre[i];
    eye[static_cast<std::size_t>(i)] -= quadric.origin[i];
  }
  const Real pixel = space.pixel;
  const Real right = (Real(middle.x) - space.middle_x) * pixel;
  const Real up = (space.middle_y - Real(middle.y)) * pixel;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec row = to_vec(quadric.to_unit[i]);
    const Real along_right = dot(row, space.axes.right);
    const Real along_up = dot(row, space.axes.up);
    const Real along_forward = dot(row, space.axes.forward);
    const Real at_eye = row[0] * eye[0] + row[1] * eye[1] + row[2] * eye[2];
    rays.fixed[i] = space.perspective ? at_eye : along_forward;
    rays.moving[i] = {along_right * pixel, -along_up * pixel,
                      along_right * right + along_up * up + (space.perspective ? along_forward : at_eye)};
  }
  return rays;
}

/// Depth in steps: at_zero + factor * t.
struct DepthLine {
  Real at_zero;
  Real factor;

  DepthLine(const isa::DepthScale& scale, unsigned z_bits) {
    const Real near = scale.near;
    const Real far = scale.far;
    const Real steps = isa::depth_steps(z_bits);
    factor = scale.perspective ? Real(-steps / (1 / near - 1 / far)) : Real(steps / (far - near));
    at_zero = 1 - factor * (scale.perspective ? Real(1 / near) : near);
  }
};

/// The coefficients in double precision, for decisions and bounds.
using Plain = std::array<double, 6>;

Plain plain(const Quadratic& f) {
  Plain out;
  for (std::size_t i = 0; i < f.size(); ++i) out[i] = f[i].convert_to<double>();
  return out;
}

double value_at(const Plain& f, double x, double y) {
  return (f[0] * x + f[1] * y + f[3]) * x + (f[2] * y + f[4]) * y + f[5];
}

/// The maximum over the rectangle, in double precision.
double max_over(const Plain& f, const Middle& middle) {
  double most = -std::numeric_limits<double>::infinity();
  const auto visit = [&](double x, double y) {
    if (std::abs(x) <= middle.across && std::abs(y) <= middle.down) most = std::max(most, value_at(f, x, y));
  };
  for (const double x : {-middle.across, middle.across}) {
    for (const double y : {-middle.down, middle.down}) visit(x, y);
    visit(x, -(f[1] * x + f[4]) / (2 * f[2]));
  }
  for (const double y : {-middle.down, middle.down}) visit(-(f[1] * y + f[3]) / (2 * f[0]), y);
  const double determinant = 4 * f[0] * f[2] - f[1] * f[1];
  visit((f[1] * f[4] - 2 * f[2] * f[3]) / determinant, (f[1] * f[3] - 2 * f[0] * f[4]) / determinant);
  return most;
}

std::optional<Wide> rounded(const Real& value, int fraction_bits) {
  const Real scaled = floor(ldexp(value, fraction_bits) + Real(0.5));
  if (!(abs(scaled) < ldexp(Real(1), 61))) return std::nullopt;
  return scaled.convert_to<std::int64_t>();
}

Wide size(Wide value) { return value < 0 ? -value : value; }

/// Rounds each coefficient once, and then shifts the function exactly to the picture's first pixel. Empty if sums over
/// the picture may reach 2^61.
std::optional<FixedQuadratic> to_fixed(const Quadratic& f, int fraction_bits, const Middle& middle,
                                       const Sampling& sampling) {
  std::array<Wide, 6> k{};
  for (std::size_t i = 0; i < k.size(); ++i) {
    const std::optional<Wide> one = rounded(f[i], fraction_bits);
    if (!one) return std::nullopt;
    k[i] = *one;
  }
  const Wide x = k[3] - 2 * k[0] * middle.x - k[1] * middle.y;
  const Wide y = k[4] - 2 * k[2] * middle.y - k[1] * middle.x;
  const Wide c = k[5] - k[3] * middle.x - k[4] * middle.y + k[0] * middle.x * middle.x + k[1] * middle.x * middle.y +
                 k[2] * middle.y * middle.y;
  const Wide w = sampling.width;
  const Wide h = sampling.height;
  const Wide sum = size(k[0]) * w * w + size(k[1]) * w * h + size(k[2]) * h * h + size(x) * w + size(y) * h + size(c);
  if (sum >= sum_limit) return std::nullopt;
  const auto narrow = [](Wide value) { return static_cast<std::int64_t>(value); };
  return FixedQuadratic{narrow(k[0]), narrow(k[1]), narrow(k[2]), {narrow(x), narrow(y), narrow(c)}};
}

std::optional<FixedLinear> to_fixed(const Linear& f, unsigned fraction_bits, const Middle& middle,
                                    const Sampling& sampling) {
  const auto fixed = to_fixed({0, 0, 0, f.a, f.b, f.c}, static_cast<int>(fraction_bits), middle, sampling);
  if (!fixed) return std::nullopt;
  return fixed->linear;
}

/// The allowed error of D. In the middle of a surface it is an eighth of a step at the default width; at the outline it
/// causes no more sideways error than edge-on planes have. There D falls by at least 2 D / R per pixel, if it falls
/// from D to 0 over R pixels.
double allowed_error(double most, const Middle& middle, const Sampling& sampling) {
  constexpr double least = 0x1p-20;
  const double d = most > 0 ? std::max(most, least) : 1.0;
  const double in_depth = std::sqrt(d) * std::ldexp(1.0, 9 - static_cast<int>(sampling.fraction_bits));
  const double sideways = 2.0 * d / (1.0 + model::hypotenuse(middle.across, middle.down)) * sampling.edge_on_fraction;
  return std::min(in_depth, sideways);
}

/// Converts the discriminant to integers. Returns false if it does not fit.
bool set_discriminant(ScreenQuadric& screen, const Quadratic& f, double most, const Middle& middle,
                      const Sampling& sampling) {
  const double terms = 1.0 + middle.across + middle.down + middle.across * middle.across + middle.across * middle.down +
                       middle.down * middle.down;
  const double needed = std::ceil(std::log2(terms / 2.0 / allowed_error(most, middle, sampling)));
  if (!(needed <= most_shift)) return false;
  const int shift = std::max(0, static_cast<int>(needed));
  const auto fixed = to_fixed(f, shift, middle, sampling);
  if (!fixed) return false;
  screen.discriminant = *fixed;
  screen.discriminant_shift = static_cast<unsigned>(shift);
  screen.discriminant_error = std::ldexp(terms, -shift - 1);
  return true;
}

/// Maximum number of pixels by which the quadric moves sideways while a ray passes through the depth range; infinite if
/// no whole ray can be inside it.
double sideways(const EyeSpace& space, const isa::DepthScale& scale, const Sampling& sampling, const OnRays& rays,
                const facet::Quadric& quadric, const glm::dvec3& centre) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (quadric.kind == facet::QuadricKind::ellipsoid) return never;
  if (space.perspective) {
    if (quadric.kind == facet::QuadricKind::cylinder) return never;
    const glm::dvec3 apex = space.to_eye(quadric.origin + centre);
    const double tangent = space.pixel * model::hypotenuse(sampling.width + 4.0, sampling.height + 4.0);
    return (model::hypotenuse(apex.x, apex.y) + std::abs(apex.z) * tangent) * (1.0 / scale.near - 1.0 / scale.far) /
           space.pixel;
  }
  // The cross-section one unit of length beyond the place where the section is centred at the origin: a conic in
  // pixels.
  std::array<double, 3> right{};
  std::array<double, 3> down{};
  std::array<double, 3> forward{};
  for (std::size_t i = 0; i < 3; ++i) {
    right[i] = rays.moving[i].a.convert_to<double>();
    down[i] = rays.moving[i].b.convert_to<double>();
    forward[i] = rays.fixed[i].convert_to<double>();
  }
  const auto product = [&](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return rays.signs[0] * a[0] * b[0] + rays.signs[1] * a[1] * b[1] + rays.signs[2] * a[2] * b[2];
  };
  const double xx = product(right, right);
  const double xy = product(right, down);
  const double yy = product(down, down);
  const double determinant = xx * yy - xy * xy;
  // Seen from the side, the cross-section is not an ellipse, though rounding could make it one.
  constexpr double least_part = 0x1p-46;
  if (!(xx > 0.0 && determinant > least_part * xx * yy)) return never;
  const double fx = product(forward, right);
  const double fy = product(forward, down);
  const double x = (xy * fy - yy * fx) / determinant;
  const double y = (xy * fx - xx * fy) / determinant;
  const double moved = model::hypotenuse(x, y);
  double widened = 0;
  if (quadric.kind == facet::QuadricKind::cone) {
    const double depth = -(product(forward, forward) + fx * x + fy * y);
    const double least = (xx + yy - model::hypotenuse(xx - yy, 2.0 * xy)) / 2.0;
    widened = std::sqrt(std::max(0.0, depth) / least);
  }
  return (moved + widened) * (scale.far - scale.near);
}

/// Whether the rays of all pixels are on one side of the plane across the axis. If so, they meet only one nappe of a
/// cone whose apex is the eye.
bool meets_one_nappe(const EyeSpace& space, const facet::Quadric& quadric, const PixelRect& pixels) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::int32_t x : {pixels.x0, pixels.x1}) {
    for (const std::int32_t y : {pixels.y0, pixels.y1}) {
      const glm::dvec3 ray = space.from_picture({x, y, 1.0});
      const double along =
          glm::dot(quadric.axis, space.axes.right * ray.x + space.axes.up * ray.y + space.axes.forward);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
  return low > 0.0 || high < 0.0;
}

ScreenQuadric make_edge(const EyeSpace& space, const View& view, const OnRays& rays, const facet::Quadric& quadric,
                        ScreenQuadric screen) {
  const Middle middle(screen.pixels);
  const Real near = view.depth.near;
  const Real far = view.depth.far;
  Quadratic inside = rays.depth_inside(space.perspective ? Real((1 / near + 1 / far) / 2) : Real((near + far) / 2));
  // The value has no unit, so it is scaled until bits below 1 are negligible.
  constexpr double wanted = 0x1p20;
  double most = max_over(plain(inside), middle);
  double greatest = std::abs(most);
  for (const double one : plain(inside)) greatest = std::max(greatest, most > 0.0 ? most : std::abs(one));
  if (!(greatest > 0.0)) greatest = 1.0;
  for (Real& one : inside) one *= wanted / greatest;
  most *= wanted / greatest;
  const bool is_one = !space.perspective || meets_one_nappe(space, quadric, screen.pixels);
  screen.kind = is_one && set_discriminant(screen, inside, most, middle, view.sampling) ? ScreenQuadricKind::edge
                                                                                        : ScreenQuadricKind::unfit;
  return screen;
}

/// Bits of the depth unit of a cylinder whose root has too many bits. In an orthographic view, its depth changes
/// everywhere by at least the slope of its axis, in steps per pixel.
unsigned depth_unit_bits(const facet::Quadric& quadric, const Linear& middle, int root_bits, const Sampling& sampling) {
  const int beyond = root_bits - static_cast<int>(sampling.z_bits) - 2;
  if (beyond <= 0 || quadric.kind != facet::QuadricKind::cylinder) return 0;
  const double slope = model::hypotenuse(middle.a.convert_to<double>(), middle.b.convert_to<double>());
  const double allowed = std::floor(std::log2(slope * sampling.edge_on_fraction));
  return static_cast<unsigned>(std::clamp(allowed, 0.0, static_cast<double>(beyond)));
}

}  // namespace

ScreenQuadric make_screen_quadric(const EyeSpace& space, const View& view, const facet::Quadric& quadric,
                                  const glm::dvec3& centre, const PixelRect& pixels) {
  const Sampling& sampling = view.sampling;
  ScreenQuadric screen;
  screen.pixels = pixels;
  if (pixels.empty()) {
    // The quadric touches no pixel of the picture, so no ray is inside it.
    screen.discriminant.linear.c = -1;
    return screen;
  }
  const Middle at(pixels);
  const OnRays rays = on_rays(space, quadric, centre, at);
  if (sideways(space, view.depth, sampling, rays, quadric, centre) < sampling.edge_on_fraction)
    return make_edge(space, view, rays, quadric, screen);
  screen.kind = ScreenQuadricKind::unfit;
  const Real square = rays.square_coefficient();
  if (square == 0) return screen;
  const DepthLine depth(view.depth, sampling.z_bits);
  Linear middle = rays.half_linear();
  const Real factor = -depth.factor / square;
  middle = {middle.a * factor, middle.b * factor, middle.c * factor + depth.at_zero};
  Quadratic discriminant = rays.discriminant();
  const Real factor_squared = factor * factor;
  for (Real& one : discriminant) one *= factor_squared;
  double most = max_over(plain(discriminant), at);
  if (!std::isfinite(most)) return screen;
  const auto bits_of_root = [&] { return most >= 1.0 ? std::ilogb(std::sqrt(most)) + 1 : 0; };
  if (!space.perspective) screen.unit = depth_unit_bits(quadric, middle, bits_of_root(), sampling);
  const int down = -2 * static_cast<int>(screen.unit);
  for (Real& one : discriminant) one = ldexp(one, down);
  most = std::ldexp(most, down);
  const auto fixed = to_fixed(middle, sampling.fraction_bits, at, sampling);
  if (bits_of_root() > max_root_bits || !fixed || !set_discriminant(screen, discriminant, most, at, sampling))
    return screen;
  screen.middle = *fixed;
  screen.middle_error = std::ldexp(1.0 + at.across + at.down, -static_cast<int>(sampling.fraction_bits) - 1);
  screen.eye_inside = square < 0;
  if (quadric.kind == facet::QuadricKind::cone) {
    const glm::dvec3 to_eye = space.perspective ? space.eye - centre - quadric.origin : -space.axes.forward;
    screen.eye_on_axis_nappe = glm::dot(to_eye, quadric.axis) > 0.0;
  }
  screen.kind = ScreenQuadricKind::roots;
  return screen;
}

}  // namespace csgsim::view
