// SPDX-License-Identifier: Apache-2.0
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "app/programs/processor_message.hpp"

// The module nugget._processor, which nugget/__init__.py imports before all else. It is compiled for any x86-64
// processor; the rest of the package would end Python by an illegal instruction on one that lacks what it needs, since
// a library has no .preinit_array (docs/decisions/0090).
namespace {

constexpr unsigned long room = 1024;
char told[room];
unsigned long length = 0;

void add(const char* text) {
  while (*text != '\0' && length + 1 < room) told[length++] = *text++;
}

PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_processor", "What this processor lacks.", -1, nullptr, nullptr, nullptr, nullptr, nullptr};

}  // namespace

/// Its one name: `complaint`, what is lacking and what to do; empty where nothing is.
PyMODINIT_FUNC PyInit__processor() {
  PyObject* module = PyModule_Create(&definition);
  if (module == nullptr) return nullptr;
  length = 0;
  nugget::app::tell_what_is_lacking(add);
  while (length > 0 && told[length - 1] == '\n') --length;
  told[length] = '\0';
  if (PyModule_AddStringConstant(module, "complaint", told) < 0) {
    Py_DECREF(module);
    return nullptr;
  }
  return module;
}
