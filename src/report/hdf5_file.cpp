// SPDX-License-Identifier: Apache-2.0
#include "report/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace nugget::report {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// What libhdf5 gave, let go at the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error(fmt::format("libhdf5 cannot make {}", what));
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void expect(herr_t result, const std::string& what) {
  if (result < 0) throw std::runtime_error(fmt::format("libhdf5 cannot write {}", what));
}

/// Groups on the way to a name are made with it; names are UTF-8.
Handle with_groups(const std::string& path) {
  Handle list(H5Pcreate(H5P_LINK_CREATE), H5Pclose, path);
  expect(H5Pset_create_intermediate_group(list, 1), path);
  expect(H5Pset_char_encoding(list, H5T_CSET_UTF8), path);
  return list;
}

/// Without times of day, which would give other bytes each time. Large ones packed, in pieces of some 64 kB.
Handle storage_of(const std::string& path, const std::vector<hsize_t>& size, bool packs) {
  constexpr hsize_t piece = 8192, small = 1024;  // numbers
  constexpr unsigned level = 6;
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  expect(H5Pset_obj_track_times(list, false), path);
  hsize_t count = 1;
  for (const hsize_t n : size) count *= n;
  if (!packs || count < small) return list;
  // Whole courses over time of as many columns as fit.
  std::vector<hsize_t> chunk{std::min(size[0], piece)};
  if (size.size() > 1) chunk.push_back(std::clamp(piece / chunk[0], hsize_t{1}, size[1]));
  expect(H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data()), path);
  expect(H5Pset_shuffle(list), path);
  expect(H5Pset_deflate(list, level), path);
  return list;
}

void write(hid_t file, const std::string& path, const std::vector<hsize_t>& size, hid_t stored, hid_t given,
           const void* values) {
  const Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, path),
      links = with_groups(path), storage = storage_of(path, size, H5Tis_variable_str(given) == 0),
      dataset(H5Dcreate2(file, path.c_str(), stored, space, links, storage, H5P_DEFAULT), H5Dclose, path);
  expect(H5Dwrite(dataset, given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
}

/// Text of any length.
Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a type");
  expect(H5Tset_size(type, H5T_VARIABLE), "a type");
  expect(H5Tset_cset(type, H5T_CSET_UTF8), "a type");
  return type;
}

}  // namespace

Hdf5File::Hdf5File() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions
  constexpr std::size_t growth = 1 << 20;       // bytes
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "a file"),
      made(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "a file");
  expect(H5Pset_fapl_core(access, growth, false), "a file");
  expect(H5Pset_obj_track_times(made, false), "a file");
  file_ = H5Fcreate("nugget.h5", H5F_ACC_TRUNC, made, access);  // a name only: it stays in memory
  if (file_ < 0) throw std::runtime_error("libhdf5 cannot make a file in memory");
}

Hdf5File::~Hdf5File() {
  H5Fclose(file_);
}

void Hdf5File::group(const std::string& path) {
  const Handle links = with_groups(path), made(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, path);
  expect(H5Pset_obj_track_times(made, false), path);
  const Handle group(H5Gcreate2(file_, path.c_str(), links, made, H5P_DEFAULT), H5Gclose, path);
}

void Hdf5File::attribute(const std::string& path, const std::string& name, const std::string& text) {
  const Handle type = text_type(), space(H5Screate(H5S_SCALAR), H5Sclose, name),
               attribute(H5Acreate_by_name(file_, path.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT,
                                           H5P_DEFAULT),
                         H5Aclose, path + ' ' + name);
  const char* value = text.c_str();
  expect(H5Awrite(attribute, type, &value), path + ' ' + name);
}

void Hdf5File::numbers(const std::string& path, std::span<const double> values) {
  write(file_, path, {values.size()}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data());
}

void Hdf5File::table(const std::string& path, std::span<const double> values, std::size_t rows, std::size_t columns) {
  if (values.size() != rows * columns) throw std::logic_error(path + ": other than rows times columns");
  write(file_, path, {rows, columns}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data());
}

void Hdf5File::whole_numbers(const std::string& path, std::span<const std::int32_t> values) {
  write(file_, path, {values.size()}, H5T_STD_I32LE, H5T_NATIVE_INT32, values.data());
}

void Hdf5File::texts(const std::string& path, const std::vector<std::string>& values) {
  const Handle type = text_type();
  std::vector<const char*> words;
  words.reserve(values.size());
  for (const std::string& value : values) words.push_back(value.c_str());
  write(file_, path, {words.size()}, type, type, words.data());
}

std::string Hdf5File::bytes() const {
  expect(H5Fflush(file_, H5F_SCOPE_GLOBAL), "the file");
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  if (size < 0) throw std::runtime_error("libhdf5 cannot give the file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_, bytes.data(), bytes.size()) != size)
    throw std::runtime_error("libhdf5 cannot give the file");
  return bytes;
}

}  // namespace nugget::report
