// Draws with cairo into a document (SVG or PDF) in memory.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::report {

/// cairo_svg_surface_create_for_stream or its PDF counterpart.
using CreateSurface = cairo_surface_t* (*)(cairo_write_func_t, void*, double, double);

/// @param what for the error: "the figure"
/// @return the document's bytes; width and height are points
[[nodiscard]] Result<std::string> drawDocument(std::string_view what, CreateSurface create, double width, double height,
                                               const std::function<void(cairo_t*, cairo_surface_t*)>& draw);

}  // namespace fyd::report
