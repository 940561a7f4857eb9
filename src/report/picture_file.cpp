// SPDX-License-Identifier: Apache-2.0
#include "report/picture_file.hpp"

#include <librsvg/rsvg.h>
#include <png.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "output/result_file.hpp"
#include "report/loaded_library.hpp"

namespace nugget::report {
namespace {

#define NUGGET_FUNCTION(name) decltype(::name)* name = library.find<decltype(::name)>(#name)

/// Makes pixels into a PNG: all that a report's picture needs.
struct Png {
  LoadedLibrary library{"libpng16.so.16", "a picture as PNG"};
  NUGGET_FUNCTION(png_image_write_to_memory);
};

/// Draws on pixels.
struct Cairo {
  LoadedLibrary library{"libcairo.so.2", "an SVG as PNG"};
  NUGGET_FUNCTION(cairo_create);
  NUGGET_FUNCTION(cairo_destroy);
  NUGGET_FUNCTION(cairo_image_surface_create);
  NUGGET_FUNCTION(cairo_surface_destroy);
  NUGGET_FUNCTION(cairo_surface_write_to_png_stream);
};

/// Draws an SVG with Cairo.
struct Rsvg {
  LoadedLibrary library{"librsvg-2.so.2", "an SVG as PNG"};
  NUGGET_FUNCTION(rsvg_handle_new_from_data);
  NUGGET_FUNCTION(rsvg_handle_get_intrinsic_size_in_pixels);
  NUGGET_FUNCTION(rsvg_handle_render_document);
  NUGGET_FUNCTION(g_error_free);
  NUGGET_FUNCTION(g_object_unref);
};
#undef NUGGET_FUNCTION

const Cairo& cairo() {
  static const Cairo loaded;
  return loaded;
}
const Rsvg& rsvg() {
  static const Rsvg loaded;
  return loaded;
}

struct Unref {
  void operator()(RsvgHandle* handle) const { rsvg().g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo().cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo().cairo_destroy(context); }
};

[[noreturn]] void throw_drawing_error(GError* error) {
  const std::string reason = error ? error->message : "out of memory";
  if (error) rsvg().g_error_free(error);
  throw std::runtime_error("the picture cannot be drawn: " + reason);
}

std::string png_bytes(cairo_surface_t* surface) {
  std::string png;
  const auto append = [](void* to, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  if (cairo().cairo_surface_write_to_png_stream(surface, append, &png) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("the picture cannot be drawn: out of memory");
  return png;
}

std::string drawn_as_png(const std::string& svg, int width) {
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, Unref> handle(
      rsvg().rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (!handle) throw_drawing_error(error);
  double own_width = 0.0, own_height = 0.0;
  if (!rsvg().rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &own_width, &own_height) || !(own_width > 0.0))
    throw std::runtime_error("the picture cannot be drawn: it has no size in pixels");
  const int height = static_cast<int>(std::lround(width * own_height / own_width));
  const std::unique_ptr<cairo_surface_t, Unref> surface(
      cairo().cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  const std::unique_ptr<cairo_t, Unref> context(cairo().cairo_create(surface.get()));
  const RsvgRectangle all{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
  if (!rsvg().rsvg_handle_render_document(handle.get(), context.get(), &all, &error)) throw_drawing_error(error);
  return png_bytes(surface.get());
}

}  // namespace

bool is_picture_name(const std::filesystem::path& file) {
  return file.extension() == ".svg" || file.extension() == ".png";
}

void write_picture(const std::filesystem::path& file, const std::string& svg, int width) {
  output::write_whole_file(file, file.extension() == ".png" ? drawn_as_png(svg, width) : svg);
}

std::string png_of(const std::vector<std::uint32_t>& pixels, int width) {
  static const Png png;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(pixels.size()) / image.width;
  image.format = PNG_FORMAT_BGRA;     // the bytes of ARGB
  image.flags = PNG_IMAGE_FLAG_FAST;  // a fifth of the time, and hardly larger where colours are flat
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png.png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("the picture cannot be drawn: ") + image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace nugget::report
