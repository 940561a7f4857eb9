// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/user_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "weld/failure/function.hpp"

namespace nugget::weld::failure {
namespace {

/// A name without a folder would be looked for in the system's.
std::string in_a_folder(const std::string& path) {
  return path.find('/') == std::string::npos ? "./" + path : path;
}

template <class Function>
Function* function_of(void* library, const char* name) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

/// OPT 2, 12 and 22 by a library.
class UserLibrary final : public Function {
 public:
  UserLibrary(const model::Model& model, const model::WeldLaw& law, const Geometry& weld)
      : library_(model.weld_library) {
    const auto part_id = [&](model::Index part) { return part == model::none ? 0 : model.parts[part].id; };
    weld_.id = weld.id;
    weld_.part = part_id(weld.part);
    weld_.option = law.option;
    for (int k = 0; k < 2; ++k) {
      weld_.sheet[k] = part_id(weld.sheet[k]);
      weld_.thickness[k] = weld.thickness[k];
    }
    weld_.diameter = weld.diameter;
    weld_.length = weld.length;
    weld_.area = weld.area;
    weld_.section_modulus = weld.section_modulus;
    std::copy(law.user_values.begin(), law.user_values.end(), weld_.value);
    if (library_->memory != nullptr)
      memory_.assign(static_cast<std::size_t>(std::max(library_->memory(&weld_), 0)), 0.0);
  }

  Value operator()(const Load& load) override {
    const Resultants& r = load.resultants;
    const nugget_weld_load now{load.time, load.time - time_, r.axial,    r.shear_s, r.shear_t,
                               r.torsion, r.moment_s,        r.moment_t, load.rate, load.plastic_strain};
    time_ = load.time;
    Value f;
    f.add(FailureMode::user, library_->value(&weld_, &now, memory_.data()));
    return f;
  }

  void archive(Archive& a) override {
    a(memory_, time_);
    a.built(library_, weld_);
  }

 private:
  std::shared_ptr<const model::WeldLibrary> library_;
  nugget_weld weld_{};
  std::vector<double> memory_;
  double time_ = 0.0;
};

}  // namespace

std::shared_ptr<const model::WeldLibrary> open_library(const std::string& path, Findings& findings) {
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    findings.error({path, 0, 0}, "--weld-law", why, remedy);
    return nullptr;
  };
  auto library = std::make_shared<model::WeldLibrary>();
  library->path = path;
  void* handle = dlopen(in_a_folder(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    return refuse(fmt::format("the library cannot be opened: {}", dlerror()),
                  "compile it as a shared library: cc -shared -fPIC law.c -o law.so");
  library->handle.reset(handle, dlclose);
  auto* version = function_of<int(void)>(handle, "nugget_weld_law_version");
  library->value = function_of<decltype(nugget_weld_law)>(handle, "nugget_weld_law");
  library->memory = function_of<decltype(nugget_weld_law_memory)>(handle, "nugget_weld_law_memory");
  const std::string header = "include src/model/nugget_weld_law.h, in C++ too";
  if (version == nullptr) return refuse("the library has no function nugget_weld_law_version", header);
  if (library->value == nullptr) return refuse("the library has no function nugget_weld_law", header);
  if (version() != NUGGET_WELD_LAW_VERSION)
    return refuse(fmt::format("the library was compiled for version {} of the interface, expected {}", version(),
                              static_cast<int>(NUGGET_WELD_LAW_VERSION)),
                  "compile it anew with this program's src/model/nugget_weld_law.h");
  return library;
}

std::unique_ptr<Function> user_library(const model::Model& model, const model::WeldLaw& law, const Geometry& weld) {
  return std::make_unique<UserLibrary>(model, law, weld);
}

}  // namespace nugget::weld::failure
