// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// numpy's arrays as placode.h takes them, and its statuses as exceptions.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>

#include "interface/placode.h"

namespace placode::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Raises what placode/errors.py has for this status.
[[noreturn]] inline void raise(placode_status status, const std::string& words) {
    const py::object error =
        py::module_::import("placode.errors").attr("of_status")(static_cast<int>(status), words);
    PyErr_SetObject(py::reinterpret_borrow<py::object>(error.get_type()).ptr(), error.ptr());
    throw py::error_already_set();
}

/// An array that something is written into: of this type, without gaps, of this size.
template <class T>
T* room(py::array& array, size_t size, const char* what) {
    if (!py::isinstance<py::array_t<T>>(array) || (array.flags() & py::array::c_style) == 0 ||
        !array.writeable() || static_cast<size_t>(array.size()) != size)
        raise(PLACODE_BAD_ARGUMENT,
              std::string(what) + ": expected a writable array of " + std::to_string(size) + " " +
                  std::string(py::str(py::dtype::of<T>())) + " without gaps, found " +
                  std::string(py::str(array.dtype())) + " of " + std::to_string(array.size()));
    return static_cast<T*>(array.mutable_data());
}

}  // namespace placode::python
