#include "sim/judges/quadric_sight.h"

#include <cmath>
#include <limits>

namespace csgsim::judges {

namespace {

/// Bound of the rounding error of six coefficients, each a quotient, and their sum, relative to the sum of magnitudes.
constexpr double quadric_filter_part = 0x1p-48;

using Rows = std::array<Vector, 3>;
using Form = std::array<Dyadic, 6>;

/// The sum of the squares of the rows, with the quadric's signs.
Form make_form(const Rows& rows, const std::array<double, 3>& signs) {
  Form form;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [x, y, z] = rows[i];
    const Dyadic sign(signs[i]);
    const Form square{x * x, y * y, z * z, x * y, x * z, y * z};
    for (std::size_t k = 0; k < form.size(); ++k) form[k] = form[k] + sign * square[k];
  }
  return form;
}

Vector operator*(const Form& form, const Vector& v) {
  const auto& [xx, yy, zz, xy, xz, yz] = form;
  return {xx * v[0] + xy * v[1] + xz * v[2], xy * v[0] + yy * v[1] + yz * v[2], xz * v[0] + yz * v[1] + zz * v[2]};
}

Dyadic twice(const Dyadic& value) { return value + value; }

/// Error bound of v^T form v in units of the rounding of doubles, if u = rows v is computed first.
double rounding_size(const Rows& rows, const Vector& v) {
  double sum = 0;
  for (const Vector& row : rows) {
    double terms = 0;
    for (std::size_t i = 0; i < row.size(); ++i) terms += std::abs(row[i].to_double() * v[i].to_double());
    sum += terms * (2.0 * std::abs(dot(row, v).to_double()) + std::numeric_limits<double>::epsilon() * terms);
  }
  return sum;
}

Parts one(const Part& part) { return {{part, {}}, 1}; }

}  // namespace

Dyadic QuadricSight::ExactQuadratic::at(Place place) const {
  const Dyadic px(static_cast<double>(place.x));
  const Dyadic py(static_cast<double>(place.y));
  return c + px * (x + px * xx + py * xy) + py * (y + py * yy);
}

QuadricSight::QuadricSight(const facet::QuadricTable& quadrics, const ExactCamera& camera)
    : table_(quadrics), camera_(camera), eye_(camera.eye - to_exact(quadrics.centre())) {
  const auto count = static_cast<std::uint32_t>(quadrics.quadrics().size());
  quadrics_.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) quadrics_.push_back(make_filter(i));
}

/// Points of a ray are p = base + q along in an orthographic view. In perspective they are p / t with q = -1 / t, which
/// divides the quadric's equation by t^2.
QuadricSight::Exact QuadricSight::make_exact(std::uint32_t index) const {
  const facet::Quadric& quadric = table_.quadrics()[index];
  const Rows rows{to_exact(quadric.to_unit[0]), to_exact(quadric.to_unit[1]), to_exact(quadric.to_unit[2])};
  const Form form = make_form(rows, quadric.signs());
  const Vector from_origin = eye_ - to_exact(quadric.origin);
  const Vector& base = camera_.is_perspective ? camera_.forward : from_origin;
  const Vector& along = camera_.is_perspective ? Vector{} - from_origin : camera_.forward;
  const Vector form_base = form * base;
  const Vector form_along = form * along;
  const Vector form_right = form * camera_.right;
  const Vector form_up = form * camera_.up;
  const Dyadic& right = camera_.right_step;
  const Dyadic down = -camera_.up_step;
  Exact exact;
  exact.a = dot(along, form_along);
  exact.l = {dot(base, form_along), dot(camera_.right, form_along) * right, dot(camera_.up, form_along) * down};
  exact.q = {dot(base, form_base),
             twice(dot(camera_.right, form_base) * right),
             twice(dot(camera_.up, form_base) * down),
             dot(camera_.right, form_right) * right * right,
             twice(dot(camera_.right, form_up) * right * down),
             dot(camera_.up, form_up) * down * down};
  exact.sizes_of_a = rounding_size(rows, along) + (camera_.is_perspective ? std::abs(quadric.level()) : 0.0);
  Dyadic& constant = camera_.is_perspective ? exact.a : exact.q.c;
  constant = constant + Dyadic(quadric.level());
  const ExactLinear& l = exact.l;
  const ExactQuadratic& q = exact.q;
  exact.discriminant = {l.l0 * l.l0 - exact.a * q.c,         twice(l.l0 * l.lx) - exact.a * q.x,
                        twice(l.l0 * l.ly) - exact.a * q.y,  l.lx * l.lx - exact.a * q.xx,
                        twice(l.lx * l.ly) - exact.a * q.xy, l.ly * l.ly - exact.a * q.yy};
  if (quadric.kind != facet::QuadricKind::cone) return exact;
  // Points p and p' relative to the apex are in the same nappe if p^T form p' is negative. The point of the ray midway
  // between its depths is base - L / a along.
  const Vector form_axis = form * to_exact(quadric.axis);
  const Dyadic ahead = dot(along, form_axis);
  exact.ahead = ahead.sign();
  exact.nappe = {dot(base, form_axis), dot(camera_.right, form_axis) * right, dot(camera_.up, form_axis) * down};
  if (exact.a.sign() == 0) return exact;
  ExactLinear& nappe = exact.nappe;
  nappe = {nappe.l0 * exact.a - l.l0 * ahead, nappe.lx * exact.a - l.lx * ahead, nappe.ly * exact.a - l.ly * ahead};
  if (exact.a.sign() < 0) nappe = {-nappe.l0, -nappe.lx, -nappe.ly};
  return exact;
}

const QuadricSight::Exact& QuadricSight::exact(std::uint32_t index) const {
  const auto [kept, is_new] = kept_.try_emplace(index);
  if (is_new) kept->second = make_exact(index);
  return kept->second;
}

double QuadricSight::size_over_picture(const FilterQuadratic& quadratic) const {
  const double width = camera_.width;
  const double height = camera_.height;
  return std::abs(quadratic.c) +
         width * (std::abs(quadratic.x) + std::abs(quadratic.xx) * width + std::abs(quadratic.xy) * height) +
         height * (std::abs(quadratic.y) + std::abs(quadratic.yy) * height);
}

FilterQuadratic QuadricSight::filter(const ExactQuadratic& exact, double divisor) const {
  FilterQuadratic to{exact.c.to_double() / divisor,  exact.x.to_double() / divisor,  exact.y.to_double() / divisor,
                     exact.xx.to_double() / divisor, exact.xy.to_double() / divisor, exact.yy.to_double() / divisor};
  to.error = quadric_filter_part * size_over_picture(to) + std::numeric_limits<double>::min();
  if (std::isfinite(to.error) && std::isfinite(divisor) && std::abs(divisor) >= std::numeric_limits<double>::min())
    return to;
  return {0, 0, 0, 0, 0, 0, infinity};
}

SightQuadric QuadricSight::make_filter(std::uint32_t index) const {
  const Exact exact = make_exact(index);
  const auto linear = [&](const ExactLinear& from, double over) {
    return filter({from.l0, from.lx, from.ly, {}, {}, {}}, over);
  };
  SightQuadric quadric;
  quadric.opening = exact.a.sign();
  quadric.ahead = exact.ahead;
  const double a = quadric.a = exact.a.to_double();
  const bool no_l = exact.l.l0.sign() == 0 && exact.l.lx.sign() == 0 && exact.l.ly.sign() == 0;
  quadric.is_edge = quadric.opening == 0 && no_l;
  quadric.nappe = linear(exact.nappe, 1.0);
  quadric.slope = linear(exact.l, 1.0);
  quadric.value = filter(exact.q, 1.0);
  if (quadric.is_edge) {
    quadric.square = filter(exact.q, -1.0);
    return quadric;
  }
  quadric.condition = exact.sizes_of_a / std::abs(a);
  quadric.middle = linear(exact.l, -a);
  quadric.square = filter(exact.discriminant, a * a);
  const double middle = size_over_picture(quadric.middle);
  quadric.square_terms = middle * middle + size_over_picture(filter(exact.q, a));
  return quadric;
}

int QuadricSight::discriminant_sign(std::uint32_t index, Place place) const {
  const FilterQuadratic& square = quadrics_[index].square;
  const double value = square.at(place);
  if (std::abs(value) > square.error) return value > 0.0 ? 1 : -1;
  return quadrics_[index].is_edge ? -exact(index).q.at(place).sign() : exact(index).discriminant.at(place).sign();
}

bool QuadricSight::is_on_nappe(const facet::QuadricSide& side, Place place) const {
  if (table_.quadrics()[side.quadric].kind != facet::QuadricKind::cone) return true;
  const FilterQuadratic& nappe = quadrics_[side.quadric].nappe;
  const double value = nappe.at(place);
  const bool filtered = std::abs(value) > nappe.error;
  return (filtered ? value < 0.0 : exact(side.quadric).nappe.at(place).sign() < 0) == side.along_axis;
}

Parts QuadricSight::parts(const facet::QuadricSide& side, Place place) const {
  const SightQuadric& quadric = quadrics_[side.quadric];
  const Part everything;
  const Part until{std::nullopt, Sheet{side.quadric, Root::nearer}};
  const Part from{Sheet{side.quadric, Root::farther}, std::nullopt};
  if (quadric.opening == 0 && !quadric.is_edge) return tangent_parts(side, place);
  const int sign = discriminant_sign(side.quadric, place);
  if (quadric.is_edge) return sign >= 0 && is_on_nappe(side, place) ? one(everything) : Parts{};
  if (quadric.opening > 0) {
    return sign > 0 && is_on_nappe(side, place) ? one({until.back, from.front}) : Parts{};
  }
  if (sign < 0) return one(everything);
  if (quadric.ahead == 0) return {{until, from}, 2};
  return one((quadric.ahead < 0) == side.along_axis ? from : until);
}

/// The parts if all rays meet the quadric once or not at all: a = 0.
Parts QuadricSight::tangent_parts(const facet::QuadricSide& side, Place place) const {
  const Exact& numbers = exact(side.quadric);
  const int l = numbers.l.at(place).sign();
  if (l == 0) return numbers.q.at(place).sign() < 0 ? one({}) : Parts{};
  // L > 0: towards the start of the rays. A cone has only one of its nappes there.
  if (numbers.ahead != 0 && (numbers.ahead == l) != side.along_axis) return {};
  return one(l > 0 ? Part{std::nullopt, Sheet{side.quadric, Root::nearer}}
                   : Part{Sheet{side.quadric, Root::farther}, std::nullopt});
}

Estimate QuadricSight::estimate_depth(Sheet sheet, Place place) const {
  const SightQuadric& quadric = quadrics_[sheet.index];
  const double square = quadric.square.at(place);
  const double error = quadric.square.error;
  const double side = static_cast<double>(sheet.root);
  const double middle = quadric.middle.at(place);
  // The error bound follows from sqrt(s) - sqrt(s - e) <= e / sqrt(s).
  if (square > 2.0 * error) {
    const double root = std::sqrt(square);
    return {middle + side * root, 2.0 * (quadric.middle.error + error / root + quadric_filter_part * root)};
  }
  return {middle, 2.0 * (quadric.middle.error + std::sqrt(3.0 * error))};
}

Surd QuadricSight::exact_depth(Sheet sheet, Place place) const {
  const Exact& numbers = exact(sheet.index);
  const Dyadic l = numbers.l.at(place);
  if (numbers.a.sign() == 0) return {-numbers.q.at(place), 0, {}, twice(l)};
  return {-l, static_cast<int>(sheet.root) * numbers.a.sign(), numbers.discriminant.at(place), numbers.a};
}

}  // namespace csgsim::judges
