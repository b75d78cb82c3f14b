#include "core/calibration/stiffness_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/outliers.h"
#include "core/calibration/fit/student_quantile.h"

namespace fyd::calibration {
namespace {

constexpr double kSameAngle_deg = 1.0;
constexpr double kOffsetCondition = 100.0;
constexpr double kLeastNoise_N = 0.005;
constexpr double kSure = 3.0;

/// Which angle each sample belongs to, and the angles.
struct Groups {
  std::vector<std::size_t> of;
  std::vector<AngleStiffness> angles;
};

Groups groupAngles(const std::vector<double>& angle_deg) {
  const auto firsts = distinctValues(angle_deg, kSameAngle_deg);
  Groups groups{{}, std::vector<AngleStiffness>(firsts.size())};
  for (const double angle : angle_deg) {
    const auto above = std::upper_bound(firsts.begin(), firsts.end(), angle);
    const auto group = static_cast<std::size_t>(above - firsts.begin()) - 1;
    groups.of.push_back(group);
    groups.angles[group].angle_deg += angle;
    groups.angles[group].points += 1;
  }
  for (AngleStiffness& a : groups.angles) a.angle_deg /= static_cast<double>(a.points);
  return groups;
}

struct Presses {
  Eigen::MatrixXd design;
  Eigen::VectorXd force;
};

Presses pressesOf(const StiffnessSamples& s, const Groups& groups, std::span<const std::size_t> rows,
                  bool with_offset) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  const auto angles = static_cast<Eigen::Index>(groups.angles.size());
  Presses out{Eigen::MatrixXd::Zero(count, angles + (with_offset ? 1 : 0)), Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t row = rows[static_cast<std::size_t>(i)];
    out.design(i, static_cast<Eigen::Index>(groups.of[row])) = s.indentation_mm[row];
    if (with_offset) out.design(i, angles) = 1.0;
    out.force[i] = s.force_N[row];
  }
  return out;
}

/// Refuses what cannot make a map. @return true when there is enough
bool enoughPresses(CalibrationResult& result, const StiffnessSamples& s, const Groups& groups,
                   const CalibrationParameters& p) {
  const auto& angles = groups.angles;
  if (angles.size() < static_cast<std::size_t>(p.stiffness_fewest_angles)) {
    std::vector<double> present;
    present.reserve(angles.size());
    for (const AngleStiffness& a : angles) present.push_back(a.angle_deg);
    const Gap gap = widestGap(present, 20.0, 90.0);
    refuseTooFew(result,
                 say("{} different angles; expected at least {}: add presses at an angle "
                     "between {:.3g} and {:.3g} deg",
                     angles.size(), p.stiffness_fewest_angles, gap.from, gap.to),
                 "calibration.stiffness_fewest_angles");
    return false;
  }
  for (std::size_t a = 0; a < angles.size(); ++a) {
    double deepest = 0.0;
    std::size_t presses = 0;  // a point on the untouched cloth is none
    for (std::size_t row = 0; row < groups.of.size(); ++row) {
      if (groups.of[row] != a) continue;
      deepest = std::max(deepest, s.indentation_mm[row]);
      presses += s.indentation_mm[row] >= kLeastPress_mm ? 1 : 0;
    }
    if (presses == 0) {
      refuse(result, say("no press at {:.3g} deg is deeper than {:.3g} mm; expected at least {:g} mm: "
                         "press deeper there",
                         angles[a].angle_deg, deepest, kLeastPress_mm));
      return false;
    }
    if (presses >= static_cast<std::size_t>(p.stiffness_fewest_presses)) continue;
    refuseTooFew(result,
                 say("{} points at {:.3g} deg are at least {:g} mm deep; expected at least {}: press there again, to "
                     "different depths",
                     presses, angles[a].angle_deg, kLeastPress_mm, p.stiffness_fewest_presses),
                 "calibration.stiffness_fewest_presses");
    return false;
  }
  return true;
}

/// Two angles where the stiffness falls beyond doubt; empty when there are none.
Message fallIn(const std::vector<AngleStiffness>& angles) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    for (std::size_t j = i + 1; j < angles.size(); ++j) {
      const double doubt = kSure * std::hypot(angles[i].standard_error, angles[j].standard_error);
      const double fall = angles[i].stiffness_N_per_mm - angles[j].stiffness_N_per_mm;
      if (!(fall > doubt) || !(fall > 1e-9)) continue;
      return say(
          "stiffness falls from {:.3f} N/mm at {:.3g} deg to {:.3f} at {:.3g} deg, though stretching "
          "stiffens the cloth: press at both angles again, and look whether the cloth slips",
          angles[i].stiffness_N_per_mm, angles[i].angle_deg, angles[j].stiffness_N_per_mm, angles[j].angle_deg);
    }
  }
  return {};
}

void makeLaw(StiffnessMap& out) {
  double widest = 0.0;
  for (const AngleStiffness& a : out.angles) widest = std::max(widest, a.standard_error);
  std::vector<MonotonePoint> points;
  for (const AngleStiffness& a : out.angles) {
    const double error = std::max({a.standard_error, 1e-3 * widest, 1e-12});
    points.push_back({a.angle_deg, a.stiffness_N_per_mm, 1.0 / (error * error)});
  }
  auto law = poolViolators(points);
  const auto alone = [&law](const MonotonePoint& point) {
    return std::ranges::any_of(law, [&](const auto& l) { return l.place == point.place && l.weight == point.weight; });
  };
  if (const auto pooled = points.size() - static_cast<std::size_t>(std::ranges::count_if(points, alone)); pooled > 0) {
    out.result.notes.push_back(say("{} angles are not told apart by their stiffness and were pooled", pooled));
  }
  while (law.size() > kParameterListCapacity) {  // the profile's list holds no more: join the nearest neighbours
    std::size_t nearest = 0;
    for (std::size_t i = 1; i + 1 < law.size(); ++i) {
      if (law[i + 1].place - law[i].place < law[nearest + 1].place - law[nearest].place) nearest = i;
    }
    MonotonePoint &a = law[nearest], &b = law[nearest + 1];
    const double sum = a.weight + b.weight;
    a = {(a.place * a.weight + b.place * b.weight) / sum, (a.level * a.weight + b.level * b.weight) / sum, sum};
    law.erase(law.begin() + static_cast<std::ptrdiff_t>(nearest) + 1);
  }
  for (const MonotonePoint& point : law) {
    out.law_angle_deg.push_back(point.place);
    out.law_stiffness_N_per_mm.push_back(point.level);
  }
}

std::string listOf(const std::vector<double>& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

}  // namespace

std::vector<MonotonePoint> poolViolators(const std::vector<MonotonePoint>& points) {
  std::vector<MonotonePoint> blocks;
  for (const MonotonePoint& point : points) {
    blocks.push_back(point);
    while (blocks.size() > 1 && !(blocks.back().level > blocks[blocks.size() - 2].level)) {
      const MonotonePoint last = blocks.back();
      blocks.pop_back();
      MonotonePoint& joined = blocks.back();
      const double sum = joined.weight + last.weight;
      joined.place = (joined.place * joined.weight + last.place * last.weight) / sum;
      joined.level = (joined.level * joined.weight + last.level * last.weight) / sum;
      joined.weight = sum;
    }
  }
  return blocks;
}

void sayIndentationUnproven(CalibrationResult& result) {
  const Message unproven =
      say("the indentation was never proven on this cloth (fyd calibrate cloth): an indentation from the distance "
          "sensors can be wrong by 15 % and more, and the stiffness with it");
  result.notes.push_back(unproven);
  if (result.verdict.accepted)
    result.verdict.reason = say("{}; WARNING: {}", std::move(result.verdict.reason), unproven);
}

StiffnessMap calibrateStiffness(const StiffnessSamples& s, const CalibrationParameters& p) {
  StiffnessMap out;
  CalibrationResult& result = out.result;
  result = {.procedure = "stiffness",
            .curve = say("slope per angle, monotone law"),
            .unit = "N",
            .points = s.force_N.size(),
            .samples = {{"angle_deg", "deg", s.angle_deg},
                        {"indentation_mm", "mm", s.indentation_mm},
                        {"force_N", "N", s.force_N}},
            .valid_unit = "deg"};
  if (s.angle_deg.size() != s.force_N.size() || s.indentation_mm.size() != s.force_N.size()) {
    refuse(result, say("angles, indentations and forces differ in number"));
    return out;
  }
  const bool angles_good = checkColumn(result, "angle_deg", s.angle_deg, -180, 180);
  const bool depths_good = checkColumn(result, "indentation_mm", s.indentation_mm, 0, 200);
  if (!checkColumn(result, "force_N", s.force_N, -1000, 1000) || !angles_good || !depths_good) return out;
  Groups groups = groupAngles(s.angle_deg);
  if (!enoughPresses(result, s, groups, p)) return out;

  std::vector<std::size_t> rows(s.force_N.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  Presses presses = pressesOf(s, groups, rows, true);
  auto fit = fitLinear(presses.design, presses.force);
  const bool with_offset = fit && fit->condition_number <= kOffsetCondition;
  if (!with_offset) {
    presses = pressesOf(s, groups, rows, false);
    fit = fitLinear(presses.design, presses.force);
    result.notes.push_back(
        say("all presses are about equally deep, so a wrong tare cannot be told from stiffness: press to different "
            "depths"));
  }
  if (!fit) {
    refuse(result, fit.error().message);
    return out;
  }
  const double t = studentQuantile(0.95, fit->degrees_of_freedom);
  for (std::size_t a = 0; a < groups.angles.size(); ++a) {
    AngleStiffness& angle = groups.angles[a];
    const auto column = static_cast<Eigen::Index>(a);
    angle.stiffness_N_per_mm = fit->coefficients[column];
    angle.standard_error = fit->standardError(column);
    angle.low_95 = angle.stiffness_N_per_mm - t * angle.standard_error;
    angle.high_95 = angle.stiffness_N_per_mm + t * angle.standard_error;
    result.coefficients.push_back(
        {fmt::format("k at {:.4g} deg", angle.angle_deg), "N/mm", angle.stiffness_N_per_mm, angle.standard_error});
  }
  out.angles = groups.angles;
  if (with_offset) {
    out.force_offset_N = fit->coefficients[fit->coefficients.size() - 1];
    out.force_offset_error_N = fit->standardError(fit->coefficients.size() - 1);
  }
  result.rmse = fit->rmse;
  result.max_residual = fit->max_residual;
  result.condition_number = fit->condition_number;
  result.residuals.assign(fit->residuals.begin(), fit->residuals.end());
  result.outliers = findOutliers(presses.design, presses.force, {.least_sigma = kLeastNoise_N});

  const auto predicted = predictHeldOut(
      foldsByGroup(groups.of),
      [&](const std::vector<std::size_t>& learn) {
        const Presses part = pressesOf(s, groups, learn, with_offset);
        return fitLinear(part.design, part.force);
      },
      [&](const LinearFit& part, std::size_t row) {
        return presses.design.row(static_cast<Eigen::Index>(row)).dot(part.coefficients);
      });
  for (const std::size_t row : rows) {
    if (std::isfinite(predicted[row])) continue;
    refuse(result, say("the points at {:.3g} deg cannot be predicted from the others: press there again, to different "
                       "depths",
                       s.angle_deg[row]));
    return out;
  }
  std::vector<double> held_out;
  held_out.reserve(rows.size());
  for (const std::size_t row : rows) held_out.push_back(s.force_N[row] - predicted[row]);
  result.held_out_rmse = rootMeanSquare(held_out);

  if (!(result.held_out_rmse <= p.stiffness_held_out_N)) {
    refuse(result,
           say("held-out error {}; expected at most {:g} N: {}", errorWithUnit(result.held_out_rmse, "N"),
               p.stiffness_held_out_N,
               !hasFewOutliers(result) ? say("press slower, and hold each depth") : say("measure the outliers again")),
           "calibration.stiffness_held_out_N");
    return out;
  }
  for (const AngleStiffness& a : out.angles) {
    const double half = 100.0 * (a.high_95 - a.low_95) / 2 / std::abs(a.stiffness_N_per_mm);
    if (a.stiffness_N_per_mm > 0 && half <= p.stiffness_interval_percent) continue;
    refuse(result,
           say("{:.3f} N/mm at {:.3g} deg is known only to {:.0f} %; expected at most {:g} %: press there "
               "more often and deeper",
               a.stiffness_N_per_mm, a.angle_deg, half, p.stiffness_interval_percent),
           "calibration.stiffness_interval_percent");
    return out;
  }
  if (Message fall = fallIn(out.angles); !fall.empty()) {
    refuse(result, fall);
    return out;
  }
  makeLaw(out);
  if (out.law_angle_deg.size() < 2) {
    refuse(result, say("the stiffness does not change with the angle: check that the motors stretch the cloth"));
    return out;
  }
  result.valid_from = out.law_angle_deg.front();
  result.valid_to = out.law_angle_deg.back();
  result.changes = {{"control.law", "interpolated"},
                    {"control.law_angle_deg", listOf(out.law_angle_deg)},
                    {"control.law_stiffness_N_per_mm", listOf(out.law_stiffness_N_per_mm)}};
  result.verdict = {.accepted = true,
                    .reason = say("held-out error {} of at most {:g} N; stiffness rises from {:.3f} to {:.3f} N/mm",
                                  errorWithUnit(result.held_out_rmse, "N"), p.stiffness_held_out_N,
                                  out.law_stiffness_N_per_mm.front(), out.law_stiffness_N_per_mm.back()),
                    .threshold = "calibration.stiffness_held_out_N"};
  return out;
}

}  // namespace fyd::calibration
