#include "core/report/cairo_document.h"

namespace fyd::report {
namespace {

cairo_status_t appendTo(void* text, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Result<std::string> drawDocument(std::string_view what, CreateSurface create, double width, double height,
                                 const std::function<void(cairo_t*, cairo_surface_t*)>& draw) {
  std::string document;
  cairo_surface_t* surface = create(appendTo, &document, width, height);
  cairo_t* cairo = cairo_create(surface);
  draw(cairo, surface);
  const cairo_status_t drawn = cairo_status(cairo);
  cairo_destroy(cairo);
  cairo_surface_finish(surface);
  const cairo_status_t finished = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  for (const cairo_status_t status : {drawn, finished}) {
    if (status != CAIRO_STATUS_SUCCESS) return fail("{} cannot be drawn: {}", what, cairo_status_to_string(status));
  }
  return document;
}

}  // namespace fyd::report
