#include "core/sim/cloth/cloth_table.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace fyd::sim {
namespace {

constexpr std::array<double, 4> kScales{1e-4, 1e-2, 1e-3, 1e-3};  // of the stored whole numbers: N, mm², mm, mm
constexpr double kShapeScale = 1e-4;

Result<std::vector<double>> numbersOf(std::istream& in, const char* what) {
  std::string line, name;
  if (!std::getline(in, line)) return fail("cloth table: ends before \"{}\"", what);
  std::istringstream words(line);
  words >> name;
  if (name != what) return fail("cloth table: \"{}\" where \"{}\" was expected", name, what);
  std::vector<double> out;
  for (double value = 0.0; words >> value;) {
    if (!std::isfinite(value)) return fail("cloth table: {} holds {}, expected finite numbers", what, value);
    out.push_back(value);
  }
  if (!words.eof()) return fail("cloth table: {} holds something that is no number", what);
  return out;
}

Result<std::vector<double>> axisOf(std::istream& in, const char* what, std::size_t most) {
  auto axis = numbersOf(in, what);
  if (!axis) return axis;
  const bool rising = std::is_sorted(axis->begin(), axis->end(), std::less_equal<>());
  if (axis->size() < 2 || axis->size() > most || !rising) {
    return fail("cloth table: {}: expected 2 … {} rising numbers", what, most);
  }
  return axis;
}

Result<void> fill(std::istream& in, const char* what, double scale, double* first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    long value = 0;
    if (!(in >> value)) return fail("cloth table: {}: {} of {} numbers", what, i, count);
    first[i] = static_cast<double>(value) * scale;
  }
  return {};
}

}  // namespace

Result<ClothTable> ClothTable::parse(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string line;
  if (!std::getline(in, line) || line != "fyd-cloth 1") return fail("cloth table: does not begin with \"fyd-cloth 1\"");
  std::getline(in, line);  // a line that names the generator
  ClothTable table;
  if (!std::getline(in, line) || !line.starts_with("finger ")) return fail("cloth table: no line \"finger\"");
  table.whole_at_once_ = line.starts_with("finger disc");
  const auto half = numbersOf(in, "half");
  if (!half) return tl::unexpected(half.error());
  const auto near = numbersOf(in, "near");
  if (!near) return tl::unexpected(near.error());
  const auto reference = axisOf(in, "reference", kStretches);
  if (!reference) return tl::unexpected(reference.error());
  if (half->size() != 2 || near->size() != 1 || reference->size() != kStretches || (*half)[0] <= 0 || (*half)[1] <= 0 ||
      (*near)[0] <= 0) {
    return fail("cloth table: expected two half sides, one distance and two reference stiffnesses, all above 0");
  }
  table.half_width_mm_ = (*half)[0];
  table.half_depth_mm_ = (*half)[1];
  table.near_mm_ = (*near)[0];
  std::copy(reference->begin(), reference->end(), table.reference_.begin());
  for (const auto& [name, axis] : {std::pair{"x", &table.x_}, {"y", &table.y_}, {"depth", &table.depths_}}) {
    auto read = axisOf(in, name, kMostNodes);
    if (!read) return tl::unexpected(read.error());
    *axis = std::move(*read);
  }
  const auto size = numbersOf(in, "shape");
  if (!size) return tl::unexpected(size.error());
  if (size->size() != 1 || (*size)[0] < 3 || (*size)[0] > kMostNodes) {
    return fail("cloth table: shape: expected one number, 3 … {}", kMostNodes);
  }
  if (table.x_.front() != 0.0 || table.depths_.front() <= 0.0) return fail("cloth table: x from 0, depth above 0");
  table.mirrored_y_ = table.y_.front() == 0.0;
  const auto n = static_cast<std::size_t>((*size)[0]);
  for (std::size_t i = 0; i < n; ++i) {
    table.grid_.push_back(2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0);
  }
  const std::size_t places = table.x_.size() * table.y_.size(), depths = table.depths_.size();
  table.pressings_.resize(places * kQuantities * kStretches * depths);
  table.shapes_.resize(places * depths * n * n);
  for (std::size_t place = 0; place < places; ++place) {
    for (std::size_t q = 0; q < kQuantities; ++q) {
      double* first = &table.pressings_[(place * kQuantities + q) * kStretches * depths];
      if (auto read = fill(in, "pressings", kScales[q], first, kStretches * depths); !read) {
        return tl::unexpected(read.error());
      }
    }
    if (auto read = fill(in, "shapes", kShapeScale, &table.shapes_[place * depths * n * n], depths * n * n); !read) {
      return tl::unexpected(read.error());
    }
  }
  return table;
}

ClothTable::Taps ClothTable::tapsAt(const std::vector<double>& axis, double at, bool mirrored) {
  const auto last = static_cast<std::ptrdiff_t>(axis.size()) - 1;
  at = std::clamp(at, axis.front(), axis.back());
  std::ptrdiff_t cell = std::upper_bound(axis.begin(), axis.end(), at) - axis.begin() - 1;
  cell = std::clamp<std::ptrdiff_t>(cell, 0, last - 1);
  // Node −1 is node 1 on the other side where the cloth is mirrored; where an end has no neighbour, its slope is the
  // chord's.
  const auto node = [&](std::ptrdiff_t i) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(std::abs(i), 0, last));
  };
  const auto place = [&](std::ptrdiff_t i) { return i < 0 ? -axis[1] : axis[static_cast<std::size_t>(i)]; };
  Taps out;
  for (std::ptrdiff_t i = 0; i < 4; ++i) out.node[static_cast<std::size_t>(i)] = node(cell - 1 + i);
  const double a = place(cell), b = place(cell + 1), h = b - a, t = (at - a) / h;
  const double from_a = (1 + 2 * t) * (1 - t) * (1 - t), slope_a = t * (1 - t) * (1 - t) * h;
  const double from_b = t * t * (3 - 2 * t), slope_b = -t * t * (1 - t) * h;
  out.weight = {0.0, from_a, from_b, 0.0};
  // A slope from three points: the two chords, each weighted by the other's length.
  const auto slope = [&](double share, std::size_t middle, double before, double after) {
    const double left = after / (before + after) / before, right = before / (before + after) / after;
    out.weight[middle - 1] -= share * left;
    out.weight[middle] += share * (left - right);
    out.weight[middle + 1] += share * right;
  };
  if (cell > 0 || mirrored) {
    slope(slope_a, 1, a - place(cell - 1), h);
  } else {
    out.weight[1] -= slope_a / h;
    out.weight[2] += slope_a / h;
  }
  if (cell + 1 < last) {
    slope(slope_b, 2, h, place(cell + 2) - b);
  } else {
    out.weight[1] -= slope_b / h;
    out.weight[2] += slope_b / h;
  }
  return out;
}

double ClothTable::overDepth(const Depths& values, bool from_nothing, double depth_mm) const {
  // Node 0 is the surface: the value is 0 there, or that of the shallowest node.
  const auto depth = [&](std::size_t i) { return i == 0 ? 0.0 : depths_[i - 1]; };
  const auto value = [&](std::size_t i) { return i == 0 ? (from_nothing ? 0.0 : values[0]) : values[i - 1]; };
  const std::size_t last = depths_.size();
  depth_mm = std::min(depth_mm, depths_.back());
  std::size_t cell = 0;
  while (cell + 1 < last && depth(cell + 1) < depth_mm) ++cell;
  const auto chord = [&](std::size_t i) { return (value(i + 1) - value(i)) / (depth(i + 1) - depth(i)); };
  const auto slope = [&](std::size_t i) {
    if (i == 0 || i == last) return chord(i == 0 ? 0 : last - 1);
    const double before = chord(i - 1), after = chord(i);
    if (before * after <= 0.0) return 0.0;
    const double h0 = depth(i) - depth(i - 1), h1 = depth(i + 1) - depth(i);
    return 3 * (h0 + h1) / ((2 * h1 + h0) / before + (h1 + 2 * h0) / after);
  };
  const double h = depth(cell + 1) - depth(cell), t = (depth_mm - depth(cell)) / h;
  return (1 + 2 * t) * (1 - t) * (1 - t) * value(cell) + t * (1 - t) * (1 - t) * h * slope(cell) +
         t * t * (3 - 2 * t) * value(cell + 1) - t * t * (1 - t) * h * slope(cell + 1);
}

Pressing ClothTable::press(double x_mm, double y_mm, double depth_mm, double reference_N_per_mm) const {
  Pressing out;
  if (!(depth_mm > 0.0)) return out;
  const double flip_x = x_mm < 0 ? -1.0 : 1.0, flip_y = mirrored_y_ && y_mm < 0 ? -1.0 : 1.0;
  const Taps across = tapsAt(x_, x_mm * flip_x, true), along = tapsAt(y_, y_mm * flip_y, mirrored_y_);
  const double share = (reference_N_per_mm - reference_[0]) / (reference_[1] - reference_[0]);
  const std::array<double, kStretches> stretch{1 - share, share};
  const std::size_t depths = depths_.size();
  std::array<double, kQuantities> found{};
  Depths values{};
  for (std::size_t q = 0; q < kQuantities; ++q) {
    values.fill(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const double weight = across.weight[i] * along.weight[j];
        const std::size_t place = across.node[i] * y_.size() + along.node[j];
        const double* column = &pressings_[(place * kQuantities + q) * kStretches * depths];
        for (std::size_t d = 0; d < depths; ++d) {
          values[d] += weight * (stretch[0] * column[d] + stretch[1] * column[depths + d]);
        }
      }
    }
    found[q] = overDepth(values, q == 0 || (q == 1 && !whole_at_once_), depth_mm);
  }
  out.force_N = std::max(0.0, found[0]);
  out.area_mm2 = std::max(0.0, found[1]);
  out.centre_x_mm = flip_x * found[2];
  out.centre_y_mm = flip_y * found[3];
  return out;
}

double ClothTable::morphed(double distance_mm, double finger_mm, double edge_mm) const {
  const double side = distance_mm < 0 ? -1.0 : 1.0;
  const double room = std::max(1.0, edge_mm - side * finger_mm), near = std::min(near_mm_, room);
  const double distance = std::abs(distance_mm);
  if (distance >= room) return side;
  double low = 0.0, high = 1.0;  // near·t + (room − near)·t³ rises
  for (int i = 0; i < 40; ++i) {
    const double t = 0.5 * (low + high);
    (near * t + (room - near) * t * t * t < distance ? low : high) = t;
  }
  return side * 0.5 * (low + high);
}

double ClothTable::shape(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm, double depth_mm) const {
  if (!(depth_mm > 0.0)) return 0.0;
  const double flip_x = finger_x_mm < 0 ? -1.0 : 1.0, flip_y = mirrored_y_ && finger_y_mm < 0 ? -1.0 : 1.0;
  const double at_x = finger_x_mm * flip_x, at_y = finger_y_mm * flip_y;
  const Taps across = tapsAt(x_, at_x, true), along = tapsAt(y_, at_y, mirrored_y_);
  const Taps grid_x = tapsAt(grid_, morphed(x_mm * flip_x - at_x, at_x, half_width_mm_), false);
  const Taps grid_y = tapsAt(grid_, morphed(y_mm * flip_y - at_y, at_y, half_depth_mm_), false);
  const std::size_t depths = depths_.size(), n = grid_.size();
  Depths values{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double weight = across.weight[i] * along.weight[j];
      if (weight == 0.0) continue;
      const double* place = &shapes_[(across.node[i] * y_.size() + along.node[j]) * depths * n * n];
      for (std::size_t d = 0; d < depths; ++d) {
        double sum = 0.0;
        for (std::size_t u = 0; u < 4; ++u) {
          const double* row = place + (d * n + grid_x.node[u]) * n;
          for (std::size_t v = 0; v < 4; ++v) sum += grid_x.weight[u] * grid_y.weight[v] * row[grid_y.node[v]];
        }
        values[d] += weight * sum;
      }
    }
  }
  return std::clamp(overDepth(values, false, depth_mm), 0.0, 1.0);
}

}  // namespace fyd::sim
