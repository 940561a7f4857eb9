// SPDX-License-Identifier: Apache-2.0
#include "report/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "report/loaded_library.hpp"

// In its macros calls of the library, which is not linked.
#undef H5CHECK
#define H5CHECK
#undef H5OPEN
#define H5OPEN

namespace nugget::report {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// libhdf5. Its kinds of lists and types are variables, which it fills as it begins.
struct Hdf5 {
  LoadedLibrary library{"libhdf5_serial.so.103", "HDF5"};
#define NUGGET_FUNCTION(name) decltype(::name)* name = library.find<decltype(::name)>(#name)
  NUGGET_FUNCTION(H5open);
  NUGGET_FUNCTION(H5check_version);
  NUGGET_FUNCTION(H5Aclose);
  NUGGET_FUNCTION(H5Acreate_by_name);
  NUGGET_FUNCTION(H5Awrite);
  NUGGET_FUNCTION(H5Dclose);
  NUGGET_FUNCTION(H5Dcreate2);
  NUGGET_FUNCTION(H5Dwrite);
  NUGGET_FUNCTION(H5Eset_auto2);
  NUGGET_FUNCTION(H5Fclose);
  NUGGET_FUNCTION(H5Fcreate);
  NUGGET_FUNCTION(H5Fflush);
  NUGGET_FUNCTION(H5Fget_file_image);
  NUGGET_FUNCTION(H5Gclose);
  NUGGET_FUNCTION(H5Gcreate2);
  NUGGET_FUNCTION(H5Pclose);
  NUGGET_FUNCTION(H5Pcreate);
  NUGGET_FUNCTION(H5Pset_char_encoding);
  NUGGET_FUNCTION(H5Pset_chunk);
  NUGGET_FUNCTION(H5Pset_create_intermediate_group);
  NUGGET_FUNCTION(H5Pset_deflate);
  NUGGET_FUNCTION(H5Pset_fapl_core);
  NUGGET_FUNCTION(H5Pset_obj_track_times);
  NUGGET_FUNCTION(H5Pset_shuffle);
  NUGGET_FUNCTION(H5Sclose);
  NUGGET_FUNCTION(H5Screate);
  NUGGET_FUNCTION(H5Screate_simple);
  NUGGET_FUNCTION(H5Tclose);
  NUGGET_FUNCTION(H5Tcopy);
  NUGGET_FUNCTION(H5Tis_variable_str);
  NUGGET_FUNCTION(H5Tset_cset);
  NUGGET_FUNCTION(H5Tset_size);
#undef NUGGET_FUNCTION
  Hdf5() {
    H5check_version(H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);  // as its headers have every program do
    H5open();
  }
  hid_t id(const char* variable) const {
    return *library.find<const hid_t>(variable);
  }
};

const Hdf5& hdf5() {
  static const Hdf5 loaded;
  return loaded;
}

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
  Handle list(hdf5().H5Pcreate(hdf5().id("H5P_CLS_LINK_CREATE_ID_g")), hdf5().H5Pclose, path);
  expect(hdf5().H5Pset_create_intermediate_group(list, 1), path);
  expect(hdf5().H5Pset_char_encoding(list, H5T_CSET_UTF8), path);
  return list;
}

/// Without times of day, which would give other bytes each time. Large ones packed, in pieces of some 64 kB.
Handle storage_of(const std::string& path, const std::vector<hsize_t>& size, bool packs) {
  constexpr hsize_t piece = 8192, small = 1024;  // numbers
  constexpr unsigned level = 6;
  Handle list(hdf5().H5Pcreate(hdf5().id("H5P_CLS_DATASET_CREATE_ID_g")), hdf5().H5Pclose, path);
  expect(hdf5().H5Pset_obj_track_times(list, false), path);
  hsize_t count = 1;
  for (const hsize_t n : size) count *= n;
  if (!packs || count < small) return list;
  // Whole courses over time of as many columns as fit.
  std::vector<hsize_t> chunk{std::min(size[0], piece)};
  if (size.size() > 1) chunk.push_back(std::clamp(piece / chunk[0], hsize_t{1}, size[1]));
  expect(hdf5().H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data()), path);
  expect(hdf5().H5Pset_shuffle(list), path);
  expect(hdf5().H5Pset_deflate(list, level), path);
  return list;
}

void write(hid_t file, const std::string& path, const std::vector<hsize_t>& size, hid_t stored, hid_t given,
           const void* values) {
  const Handle space(hdf5().H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), hdf5().H5Sclose,
                     path),
      links = with_groups(path), storage = storage_of(path, size, hdf5().H5Tis_variable_str(given) == 0),
      dataset(hdf5().H5Dcreate2(file, path.c_str(), stored, space, links, storage, H5P_DEFAULT), hdf5().H5Dclose, path);
  expect(hdf5().H5Dwrite(dataset, given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
}

/// Text of any length.
Handle text_type() {
  Handle type(hdf5().H5Tcopy(hdf5().id("H5T_C_S1_g")), hdf5().H5Tclose, "a type");
  expect(hdf5().H5Tset_size(type, H5T_VARIABLE), "a type");
  expect(hdf5().H5Tset_cset(type, H5T_CSET_UTF8), "a type");
  return type;
}

}  // namespace

Hdf5File::Hdf5File() {
  hdf5().H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by exceptions
  constexpr std::size_t growth = 1 << 20;              // bytes
  const Handle access(hdf5().H5Pcreate(hdf5().id("H5P_CLS_FILE_ACCESS_ID_g")), hdf5().H5Pclose, "a file"),
      made(hdf5().H5Pcreate(hdf5().id("H5P_CLS_FILE_CREATE_ID_g")), hdf5().H5Pclose, "a file");
  expect(hdf5().H5Pset_fapl_core(access, growth, false), "a file");
  expect(hdf5().H5Pset_obj_track_times(made, false), "a file");
  file_ = hdf5().H5Fcreate("nugget.h5", H5F_ACC_TRUNC, made, access);  // a name only: it stays in memory
  if (file_ < 0) throw std::runtime_error("libhdf5 cannot make a file in memory");
}

Hdf5File::~Hdf5File() {
  hdf5().H5Fclose(file_);
}

void Hdf5File::group(const std::string& path) {
  const Handle links = with_groups(path),
               made(hdf5().H5Pcreate(hdf5().id("H5P_CLS_GROUP_CREATE_ID_g")), hdf5().H5Pclose, path);
  expect(hdf5().H5Pset_obj_track_times(made, false), path);
  const Handle group(hdf5().H5Gcreate2(file_, path.c_str(), links, made, H5P_DEFAULT), hdf5().H5Gclose, path);
}

void Hdf5File::attribute(const std::string& path, const std::string& name, const std::string& text) {
  const Handle type = text_type(), space(hdf5().H5Screate(H5S_SCALAR), hdf5().H5Sclose, name),
               attribute(hdf5().H5Acreate_by_name(file_, path.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                                  H5P_DEFAULT, H5P_DEFAULT),
                         hdf5().H5Aclose, path + ' ' + name);
  const char* value = text.c_str();
  expect(hdf5().H5Awrite(attribute, type, &value), path + ' ' + name);
}

void Hdf5File::numbers(const std::string& path, std::span<const double> values) {
  write(file_, path, {values.size()}, hdf5().id("H5T_IEEE_F64LE_g"), hdf5().id("H5T_NATIVE_DOUBLE_g"), values.data());
}

void Hdf5File::table(const std::string& path, std::span<const double> values, std::size_t rows, std::size_t columns) {
  if (values.size() != rows * columns) throw std::logic_error(path + ": other than rows times columns");
  write(file_, path, {rows, columns}, hdf5().id("H5T_IEEE_F64LE_g"), hdf5().id("H5T_NATIVE_DOUBLE_g"), values.data());
}

void Hdf5File::whole_numbers(const std::string& path, std::span<const std::int32_t> values) {
  write(file_, path, {values.size()}, hdf5().id("H5T_STD_I32LE_g"), hdf5().id("H5T_NATIVE_INT32_g"), values.data());
}

void Hdf5File::texts(const std::string& path, const std::vector<std::string>& values) {
  const Handle type = text_type();
  std::vector<const char*> words;
  words.reserve(values.size());
  for (const std::string& value : values) words.push_back(value.c_str());
  write(file_, path, {words.size()}, type, type, words.data());
}

std::string Hdf5File::bytes() const {
  expect(hdf5().H5Fflush(file_, H5F_SCOPE_GLOBAL), "the file");
  const ssize_t size = hdf5().H5Fget_file_image(file_, nullptr, 0);
  if (size < 0) throw std::runtime_error("libhdf5 cannot give the file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (hdf5().H5Fget_file_image(file_, bytes.data(), bytes.size()) != size)
    throw std::runtime_error("libhdf5 cannot give the file");
  return bytes;
}

}  // namespace nugget::report
