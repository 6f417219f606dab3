// The extension module behind the package mwt: arrays in and out, errors as Python's.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <exception>
#include <future>
#include <thread>

#include "mwt/mwt.h"

namespace py = pybind11;
namespace api = mwt::v1;

namespace {

using Coordinates = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Corners = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

// The array's own memory where it has the right form: it stays alive, for the caller holds it.
std::span<const api::Point> points_in(const Coordinates& array) {
  static_assert(sizeof(api::Point) == 2 * sizeof(double));
  if (array.ndim() != 2 || array.shape(1) != 2) throw api::InputError("points must be an array of shape (n, 2)");
  return {reinterpret_cast<const api::Point*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

std::span<const api::Triangle> triangles_in(const Corners& array) {
  static_assert(sizeof(api::Triangle) == 3 * sizeof(std::uint32_t));
  if (array.ndim() != 2 || array.shape(1) != 3) throw api::InputError("triangles must be an array of shape (m, 3)");
  return {reinterpret_cast<const api::Triangle*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

// An array that owns the vector's memory, without a copy.
template <class Number, std::size_t columns, class Row>
py::array_t<Number> array_of(std::vector<Row>&& rows) {
  auto* const owned = new std::vector<Row>(std::move(rows));
  const py::capsule owner(owned, [](void* memory) { delete static_cast<std::vector<Row>*>(memory); });
  return py::array_t<Number>({owned->size(), columns}, reinterpret_cast<const Number*>(owned->data()), owner);
}

py::tuple pair_of(const api::Interval& interval) { return py::make_tuple(interval.lower, interval.upper); }

py::dict dictionary_of(api::Result&& result) {
  py::dict answer;
  answer["weight"] = pair_of(result.weight);
  answer["optimum"] = result.optimum ? py::object(pair_of(*result.optimum)) : py::none();
  answer["is_proved"] = result.is_proved;
  answer["stop_reason"] = result.stop_reason.empty() ? py::object(py::none()) : py::str(result.stop_reason);
  answer["counters"] = result.counters;
  answer["time_s"] = result.time_s;
  answer["triangles"] = array_of<std::uint32_t, 3>(std::move(result.triangles));
  return answer;
}

// What another thread may set to stop a computation.
class Interrupt {
 public:
  void set() { is_set_ = true; }
  [[nodiscard]] const std::atomic<bool>& flag() const { return is_set_; }

 private:
  std::atomic<bool> is_set_ = false;
};

// Runs without the interpreter's lock.
template <class Work>
auto unlocked(const Work& work) {
  const py::gil_scoped_release release;
  return work();
}

py::list entries_of(const std::vector<api::Entry>& entries) {
  py::list all;
  for (const api::Entry& entry : entries) {
    py::list parameters;
    for (const api::Parameter& parameter : entry.parameters)
      parameters.append(py::make_tuple(parameter.name, parameter.default_value, parameter.summary));
    all.append(py::make_tuple(entry.name, entry.summary, parameters));
  }
  return all;
}

}  // namespace

PYBIND11_MODULE(_mwt, module) {
  py::register_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const api::InternalError& error) {
      PyErr_SetString(PyExc_RuntimeError, error.what());
    } catch (const api::Error& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
  module.def("version", &api::version);
  py::class_<Interrupt>(module, "Interrupt").def(py::init<>()).def("set", &Interrupt::set);
  module.def("triangulate", [](const Coordinates& points, const std::string& algorithm,
                               const std::map<std::string, std::string>& parameters, std::uint64_t seed, int threads,
                               std::optional<double> time_limit, const Interrupt& interrupt) {
    const auto own = points_in(points);
    const api::Options options{algorithm, parameters, seed, threads, time_limit, &interrupt.flag()};
    return dictionary_of(unlocked([&] { return api::triangulate(own, options); }));
  });
  module.def("solve", [](const Coordinates& points, int threads, std::optional<double> time_limit,
                         const std::string& proof, const Interrupt& interrupt) {
    const auto own = points_in(points);
    return dictionary_of(unlocked([&] {
      return api::minimum_weight_triangulation(own, {threads, time_limit, proof, &interrupt.flag()});
    }));
  });
  module.def("broken_rule", [](const Coordinates& points, const Corners& triangles) {
    const auto own = points_in(points);
    const auto given = triangles_in(triangles);
    return unlocked([&] { return api::broken_rule(own, given); });
  });
  module.def("weight", [](const Coordinates& points, const Corners& triangles) {
    const auto own = points_in(points);
    const auto given = triangles_in(triangles);
    return pair_of(unlocked([&] { return api::weight(own, given); }));
  });
  module.def("alpha", [](std::pair<double, double> weight, std::pair<double, double> optimum) {
    return pair_of(api::alpha({weight.first, weight.second}, {optimum.first, optimum.second}));
  });
  module.def("generate", [](const std::string& family, std::uint32_t n, std::uint64_t seed,
                            const std::map<std::string, std::string>& parameters) {
    return array_of<double, 2>(unlocked([&] { return api::generate(family, n, seed, parameters); }));
  });
  module.def("read_points", [](const std::string& file, const std::optional<std::string>& columns) {
    return array_of<double, 2>(unlocked([&] { return api::read_points(file, columns); }));
  });
  module.def("verify_proof", [](const std::string& file, const Coordinates& points) {
    const auto own = points_in(points);
    const api::Verdict verdict = unlocked([&] { return api::verify_proof(file, own); });
    return py::make_tuple(pair_of(verdict.optimum), verdict.is_optimal);
  });
  module.def("algorithms", [] { return entries_of(api::algorithms()); });
  module.def("families", [] { return entries_of(api::families()); });
}
