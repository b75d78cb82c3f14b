#include "core/scene/mesh_text.h"

#include <algorithm>
#include <cctype>
#include <istream>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

namespace fyd::scene {

double millimetresPer(LengthUnit unit) {
  constexpr std::array<double, kLengthUnits.size()> kMillimetres = {1.0, 10.0, 1000.0, 25.4};
  return kMillimetres[static_cast<std::size_t>(unit)];
}

Result<MeshFormat> meshFormatOf(std::string_view file_name) {
  std::string ending(file_name.substr(std::min(file_name.rfind('.'), file_name.size() - 1) + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  for (std::size_t i = 0; i < kMeshFormats.size(); ++i) {
    if (ending == kMeshFormats[i]) return static_cast<MeshFormat>(i);
  }
  return fail("{}: no mesh by its name; expected .obj, .stl or .ply", file_name);
}

Result<TriangleSoup> parseMesh(std::string_view bytes, MeshFormat format, LengthUnit unit) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  bool read = false;
  try {
    boost::iostreams::stream<boost::iostreams::array_source> in(bytes.data(), bytes.size());
    switch (format) {
      case MeshFormat::obj: read = CGAL::IO::read_OBJ(in, points, polygons); break;
      case MeshFormat::stl: read = CGAL::IO::read_STL(in, points, polygons); break;
      case MeshFormat::ply: read = CGAL::IO::read_PLY(in, points, polygons); break;
    }
  } catch (const std::exception&) {
    read = false;
  }
  const std::string_view name = kMeshFormats[static_cast<std::size_t>(format)];
  if (!read) return fail("the {} bytes are no whole {} file", bytes.size(), name);
  if (points.size() >= kNoTriangle)
    return fail("{} vertices; at most {} can be counted", points.size(), kNoTriangle - 1);
  TriangleSoup out;
  const double scale = millimetresPer(unit);
  out.vertices.reserve(points.size());
  for (const Point& p : points) out.vertices.push_back({scale * p.x(), scale * p.y(), scale * p.z()});
  out.triangles.reserve(polygons.size());
  for (const auto& polygon : polygons) {
    for (const std::size_t vertex : polygon) {
      if (vertex >= points.size()) {
        return fail("a polygon has vertex {}; expected one of the {} of this {} file", vertex + 1, points.size(), name);
      }
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const auto corner = [&](std::size_t k) { return static_cast<std::uint32_t>(polygon[k]); };
      out.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
  }
  if (out.triangles.empty()) return fail("there is no triangle in the {} bytes of this {} file", bytes.size(), name);
  return out;
}

}  // namespace fyd::scene
