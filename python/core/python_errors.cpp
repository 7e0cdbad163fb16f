// SPDX-License-Identifier: Apache-2.0
#include "python/core/python_errors.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <exception>
#include <system_error>
#include <typeinfo>

#include "python/core/calls.hpp"
#include "tools/files/io_error.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace nb = nanobind;

namespace legwright {
namespace {

nb::object type_of(const char* name) {
  return nb::module_::import_("legwright._errors").attr(name);
}

/// The error as an instance of Python's InputError.
nb::object python_error_of(const nb::object& type, const InputError& error) {
  nb::list reasons;
  for (const InputError& reason : error.reasons()) reasons.append(python_error_of(type, reason));
  return type(std::string(error.what()), error.file(), error.line(), error.where(), error.message(),
              nb::tuple(reasons));
}

void raise(const nb::object& type, const nb::object& instance) {
  PyErr_SetObject(type.ptr(), instance.ptr());
}

void translate(const std::exception_ptr& failure, void*) {
  if (interpreter_ends()) {  // what was stopped has a thread to leave
    PyErr_SetNone(PyExc_SystemExit);
    return;
  }
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& error) {
    raise(type_of("InputError"), python_error(error));
  } catch (const IoError& error) {
    raise(type_of("IoError"), type_of("IoError")(std::string(error.what())));
  } catch (const MujocoError& error) {
    raise(type_of("MujocoError"), type_of("MujocoError")(std::string(error.what())));
  } catch (const std::bad_cast&) {
    PyErr_SetString(PyExc_TypeError, "a value is of another kind than is expected there");
  } catch (const std::system_error& error) {  // filesystem_error included
    raise(type_of("IoError"), type_of("IoError")(error.code().value(), std::string(error.what())));
  }
}

}  // namespace

nb::object python_error(const InputError& error) {
  return python_error_of(type_of("InputError"), error);
}

void translate_errors() { nb::register_exception_translator(translate); }

}  // namespace legwright
