// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "src/python/convert.hpp"
#include "src/run/failure.hpp"
#include "src/run/platform.hpp"

namespace sphk::python {

namespace {

/// Python's own classes of errors take the engine's sentences.
void translate_errors(const nb::module_& m) {
  struct Types {
    nb::object input, numerics, device;
  };
  const auto new_type = [&](const char* name, PyObject* base, const char* doc) {
    const std::string full = nb::cast<std::string>(m.attr("__name__")) + "." + name;
    nb::object type = nb::steal(PyErr_NewExceptionWithDoc(full.c_str(), doc, base, nullptr));
    nb::setattr(m, name, type);
    return type;
  };
  auto* const types = new Types{
      new_type("InputError", PyExc_ValueError, "What is asked for cannot be done; the message says how to mend it."),
      new_type("NumericsError", PyExc_ArithmeticError,
               "The numbers of a run went wrong: NaN, no energy, no time-step."),
      new_type("DeviceError", PyExc_RuntimeError, "The machine failed, or has too little memory.")};
  nb::register_exception_translator(
      [](const std::exception_ptr& thrown, void* data) {
        const auto& of = *static_cast<const Types*>(data);
        try {
          std::rethrow_exception(thrown);
        } catch (const nb::python_error&) {
          throw;
        } catch (const nb::builtin_exception&) {
          throw;
        } catch (const std::exception&) {
          const Failure failure = current_failure();
          const nb::object& type = failure.exit_code == ExitCode::bad_input  ? of.input
                                   : failure.exit_code == ExitCode::numerics ? of.numerics
                                                                             : of.device;
          PyErr_SetString(type.ptr(), failure.message.c_str());
        }
      },
      types);
}

}  // namespace

NB_MODULE(_sphk, m) {
  m.doc() = "The engine of sphk. Use the package sphk, which this is the compiled part of.";
  translate_errors(m);
  m.attr("__version__") = build().version;
  m.def("version_text", &version_text, "Version, revision, compiler and Kokkos.");
  bind_simulation(m);
  bind_arrangements(m);
  bind_maps(m);
  nb::module_::import_("atexit").attr("register")(nb::cpp_function([] { computing(end_engine); }));
}

}  // namespace sphk::python
