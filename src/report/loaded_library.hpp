// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::report {

/// A library of the system that is loaded when something of it is asked for first, by the name under which the loader
/// finds it. What only pictures or another format need, with all that it needs in turn, then takes neither memory nor
/// time of runs (docs/decisions/0146).
class LoadedLibrary {
 public:
  /// `serves`: what cannot be done without it, for the message. Throws std::runtime_error where it is not there.
  LoadedLibrary(const char* name, const char* serves);

  /// A function or a variable of it, or of a library that it needs; throws std::runtime_error where there is none.
  template <class T>
  T* find(const char* symbol) const {
    return reinterpret_cast<T*>(address(symbol));
  }

 private:
  void* address(const char* symbol) const;

  const char* name_;
  void* handle_;  // to the end of the program
};

}  // namespace nugget::report
