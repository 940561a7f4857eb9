// SPDX-License-Identifier: Apache-2.0
#include "report/loaded_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace nugget::report {

LoadedLibrary::LoadedLibrary(const char* name, const char* serves)
    : name_(name), handle_(::dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr)
    throw std::runtime_error(fmt::format("{} needs {}, which cannot be loaded: {} [install the package that has it]",
                                         serves, name, ::dlerror()));
}

void* LoadedLibrary::address(const char* symbol) const {
  void* const found = ::dlsym(handle_, symbol);
  if (found == nullptr) throw std::runtime_error(fmt::format("{} has no {}: another version is needed", name_, symbol));
  return found;
}

}  // namespace nugget::report
