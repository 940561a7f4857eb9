// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/shape_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>

namespace nugget::nvh {
namespace {

constexpr double end_mark = -999999.0;

std::size_t index(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// One file as words of 4 or 8 bytes.
class Words {
 public:
  Words(const std::filesystem::path& path, std::size_t bytes_a_word) : width(bytes_a_word) {
    std::ifstream in(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
  }
  std::size_t width;
  std::size_t size() const { return bytes_.size() / width; }
  std::int64_t integer(std::size_t i) const { return width == 4 ? raw<std::int32_t>(i) : raw<std::int64_t>(i); }
  double real(std::size_t i) const { return width == 4 ? raw<float>(i) : raw<double>(i); }

 private:
  template <class T>
  T raw(std::size_t i) const {
    if ((i + 1) * sizeof(T) > bytes_.size()) throw ShapeFile::ReadError("it ends too early");
    T value;
    std::memcpy(&value, bytes_.data() + i * sizeof(T), sizeof(T));
    return value;
  }
  std::string bytes_;
};

/// What the control section says of the sizes; its words by LS-DYNA's names. Source: LS-DYNA Database Binary Output
/// Files (LSTC, 2020).
struct Control {
  std::int64_t nodes, geometry, numbering, state, coordinates;  ///< in words; `coordinates` from the start of a state
  bool numbered;

  explicit Control(const Words& w) {
    const auto word = [&](std::size_t i) { return w.integer(i); };
    nodes = word(16);
    const std::int64_t globals = word(18), temperature = word(19), vectors = word(20) != 0,
                       more = (word(21) != 0) + (word(22) != 0);
    const std::int64_t solids = word(23), beams = word(28), shells = word(31), thick = word(40);
    if (nodes <= 0 || vectors == 0) throw ShapeFile::ReadError("it has no coordinates");
    if (word(37) > 0) throw ShapeFile::ReadError("particles (SPH) in it are not read");
    const std::int64_t bricks = solids < 0 ? -solids : solids;
    std::int64_t first = 64 + (word(57) > 0 ? word(57) : 0);
    std::int64_t rigid_shells = 0;
    if (word(15) > 4) {  // types of materials stand before the mesh; rigid shells have no stresses then
      rigid_shells = word(index(first));
      first += 2 + word(index(first) + 1);
    }
    geometry = first;
    numbering = first + 3 * nodes + bricks * (solids < 0 ? 11 : 9) + 9 * thick + 6 * beams + 5 * shells;
    numbered = word(39) > 0;
    const std::int64_t heat = temperature % 10, heat_words = heat == 2 ? 4 : heat == 3 ? 6 : heat > 0 ? 1 : 0;
    const std::int64_t a_node = heat_words + (temperature / 10 > 0 ? 1 : 0) + 3 * (1 + more);
    const std::int64_t deleted = word(36) <= -10000 ? bricks + beams + shells + thick : word(36) < 0 ? nodes : 0;
    coordinates = 1 + globals + (heat_words + (temperature / 10 > 0 ? 1 : 0)) * nodes;
    state = 1 + globals + a_node * nodes + bricks * word(27) + beams * word(30) + (shells - rigid_shells) * word(33) +
            thick * word(42) + deleted;
  }
};

/// Words are 4 bytes if the number of dimensions reads so.
std::size_t word_width(const std::filesystem::path& path) {
  for (const std::size_t width : {std::size_t{4}, std::size_t{8}}) {
    const Words w(path, width);
    if (w.size() > 64 && w.integer(15) >= 4 && w.integer(15) <= 7) return width;
  }
  throw ShapeFile::ReadError("it is not a d3eigv of 4 or 8 bytes a word in the order of this machine");
}

void read(const std::filesystem::path& first, ShapeFile& into) {
  const Words head(first, word_width(first));
  if (head.integer(11) % 1000 != 11)
    throw ShapeFile::ReadError(fmt::format("its file type is {}, expected 11 (d3eigv)", head.integer(11)));
  const Control control(head);
  const auto place = [&](const Words& w, std::int64_t begin, std::size_t n) {
    const std::size_t i = index(begin) + 3 * n;
    return Vec3d{w.real(i), w.real(i + 1), w.real(i + 2)};
  };
  std::int64_t ids = control.numbering;
  if (control.numbered) ids += head.integer(index(ids)) < 0 ? 16 : 10;
  for (std::size_t n = 0; n < index(control.nodes); ++n) {
    into.node.push_back(control.numbered ? static_cast<int>(head.integer(index(ids) + n)) : static_cast<int>(n) + 1);
    into.x.push_back(place(head, control.geometry, n));
  }
  std::vector<std::size_t> order(into.node.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return into.node[a] < into.node[b]; });

  for (int member = 1;; ++member) {
    const std::filesystem::path path = first.string() + fmt::format("{:02}", member);
    if (!std::filesystem::exists(path)) break;
    const Words w(path, head.width);
    for (std::int64_t begin = 0; index(begin + control.state) <= w.size() && w.real(index(begin)) != end_mark;
         begin += control.state) {
      into.frequency.push_back(w.real(index(begin)));
      for (const std::size_t n : order) {
        const Vec3d u = place(w, begin + control.coordinates, n) - into.x[n];
        into.shape.value.insert(into.shape.value.end(), {u.x, u.y, u.z});
      }
    }
  }
  into.shape.rows = 3 * into.node.size();
  into.shape.count = into.frequency.size();
  const auto sort = [&](auto& values) {
    auto sorted = values;
    for (std::size_t n = 0; n < order.size(); ++n) sorted[n] = values[order[n]];
    values = std::move(sorted);
  };
  sort(into.node);
  sort(into.x);
  if (into.frequency.empty()) throw ShapeFile::ReadError("it has no modes");
}

}  // namespace

ShapeFile::ShapeFile(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / "d3eigv";
  if (!std::filesystem::exists(path))
    throw ReadError(fmt::format("{} is not there; a run of `nugget modes` leaves it", path.string()));
  try {
    read(path, *this);
  } catch (const ReadError& error) {
    throw ReadError(fmt::format("{} cannot be read: {}", path.string(), error.what()));
  }
}

}  // namespace nugget::nvh
