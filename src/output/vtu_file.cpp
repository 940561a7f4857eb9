// SPDX-License-Identifier: Apache-2.0
#include "output/vtu_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "output/result_file.hpp"

namespace nugget::output {
namespace {

/// The part of the file behind the XML: each array with its bytes in front.
class AppendedArrays {
 public:
  template <class T>
  std::string add(const char* type, const std::string& name, int components, const std::vector<T>& values) {
    std::string element = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type,
        name, components, bytes_.size());
    const std::uint64_t size = values.size() * sizeof(T);
    const std::size_t place = bytes_.size();
    bytes_.resize(place + sizeof size + size);
    std::memcpy(bytes_.data() + place, &size, sizeof size);
    if (size > 0) std::memcpy(bytes_.data() + place + sizeof size, values.data(), size);
    return element;
  }
  std::string add(const VtuArray& array) {
    if (const auto* reals = std::get_if<std::vector<float>>(&array.values))
      return add("Float32", array.name, array.components, *reals);
    return add("Int32", array.name, array.components, std::get<std::vector<std::int32_t>>(array.values));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace

void write_vtu(const std::filesystem::path& path, const VtuGrid& grid) {
  AppendedArrays arrays;
  std::vector<float> points;
  points.reserve(3 * grid.points.size());
  for (const Vec3d& p : grid.points)
    for (const double value : {p.x, p.y, p.z}) points.push_back(static_cast<float>(value));
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
      grid.points.size(), grid.types.size());
  text += arrays.add("Float32", "Points", 3, points) + "</Points>\n<Cells>\n";
  text += arrays.add("Int64", "connectivity", 1, grid.corners);
  text += arrays.add("Int64", "offsets", 1, grid.ends);
  text += arrays.add("UInt8", "types", 1, grid.types) + "</Cells>\n<PointData>\n";
  for (const VtuArray& array : grid.of_points) text += arrays.add(array);
  text += "</PointData>\n<CellData>\n";
  for (const VtuArray& array : grid.of_cells) text += arrays.add(array);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  write_whole_file(path, text + arrays.bytes() + "\n</AppendedData>\n</VTKFile>\n");
}

void write_pvd(const std::filesystem::path& path, const std::vector<std::pair<double, std::string>>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const auto& [time, file] : files)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, file);
  write_whole_file(path, text + "</Collection>\n</VTKFile>\n");
}

}  // namespace nugget::output
