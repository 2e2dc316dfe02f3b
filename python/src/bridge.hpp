#pragma once
// What every binding needs: Outcomes as exceptions, points as NumPy arrays, long work watched from Python.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline::python {

namespace py = pybind11;

/// What an Outcome's Error is thrown as; Python sees strandline.InputError (add_errors).
struct Refused {
    Error error;
};
template <class T>
T value(Outcome<T> outcome) {
    if (!outcome) throw Refused{std::move(outcome.error())};
    if constexpr (!std::is_void_v<T>) return std::move(*outcome);
}
/// Teaches the module to raise Refused as strandline.InputError. Places that name an option of the command
/// line ("--keep-out") name the argument then ("keep_out").
void add_errors();

/// (N, 2), float64.
py::array_t<double> array_of(std::span<const Point> points);
std::vector<py::array_t<double>> arrays_of(const std::vector<std::vector<Point>>& lines);
/// A column of anything: column<double>(samples, [](const Sample& s) { return s.t; }).
template <class Number, class Row, class Get>
py::array_t<Number> column(const std::vector<Row>& rows, Get get) {
    py::array_t<Number> array(static_cast<py::ssize_t>(rows.size()));
    Number* out = array.mutable_data();
    for (const Row& row : rows) *out++ = get(row);
    return array;
}

/// C order, float64; other numbers are converted.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// Rows of `columns` finite numbers. Refused by `place` otherwise.
void need_rows(const Numbers& numbers, py::ssize_t columns, const std::string& place);
/// (N, 2) -> points. Refused by `place`: another shape, fewer than `least`, numbers that are not finite.
std::vector<Point> points_of(const Numbers& numbers, std::size_t least, const std::string& place);

/// (place, reason) each.
py::list pairs_of(const Warnings& warnings);

/// The bridge between work in its own thread and the Python thread that waits for it.
class Watch {
  public:
    /// For the work: keeps reports until they are fetched, and says when to stop.
    Progress progress();
    /// For the waiting thread, which holds the GIL: hands on what was reported and looks for Ctrl-C. Once the
    /// callback or a signal has raised, or the callback has returned False, the work is asked to stop.
    void attend(const py::object& callback);
    /// Raises what stopped the work, if anything did.
    void rethrow() const {
        if (raised_) std::rethrow_exception(raised_);
    }

  private:
    void hand_on(const py::object& callback);
    std::mutex mutex_;
    std::vector<std::pair<std::string, double>> reports_;  ///< the latest of each run of the same `what`
    std::atomic<bool> stop_ = false;
    std::exception_ptr raised_;
};

/// work(Progress), in a thread of its own while the GIL is free. callback(what, share) is called from the
/// calling thread, about thirty times a second; None: nobody asks. An exception of the callback, or Ctrl-C,
/// stops the work and is raised when it has ended; a callback that returns False asks for the best so far.
template <class Work>
auto watched(const py::object& callback, const Work& work) {
    constexpr std::chrono::milliseconds pause(30);
    Watch watch;
    auto result = std::async(std::launch::async, [&] { return work(watch.progress()); });
    for (bool ready = false; !ready;) {
        {
            const py::gil_scoped_release released;
            ready = result.wait_for(pause) == std::future_status::ready;
        }
        watch.attend(callback);
    }
    watch.rethrow();
    return result.get();
}

// The parts of the module, a file each.
void add_calls(py::module_& module);
void add_plans(py::module_& module);
void add_simulation(py::module_& module);
void add_stages(py::module_& module);
void add_lists(py::module_& module);

}  // namespace strandline::python
