// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nugget::report {

/// Whether a file's name ends as those that write_picture() writes: .svg or .png.
bool is_picture_name(const std::filesystem::path& file);

/// Writes a picture, which is an SVG document, as it is (.svg) or drawn by librsvg (.png), `width` pixels wide. Throws
/// output::WriteError, and std::runtime_error where librsvg cannot draw it.
void write_picture(const std::filesystem::path& file, const std::string& svg, int width);

/// Pixels (ARGB, see Raster::halved), row by row, as the bytes of a PNG.
std::string png_of(const std::vector<std::uint32_t>& pixels, int width);

}  // namespace nugget::report
