#include "bridge.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::python {
namespace {

/// "--keep-out 1,2" -> "keep_out 1,2"; "--noise, --wander" -> "noise, wander".
std::string as_argument(std::string place) {
    constexpr std::string_view dashes = "--";
    for (std::size_t at = 0; (at = place.find(dashes, at)) != std::string::npos;) {
        if (at > 0 && place[at - 1] != ' ') {
            at += dashes.size();
            continue;
        }
        place.erase(at, dashes.size());
        for (; at < place.size() && place[at] != ' '; ++at)
            if (place[at] == '-') place[at] = '_';
    }
    return place;
}

}  // namespace

void add_errors() {
    py::register_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Refused& refused) {
            const py::object type = py::module_::import("strandline._errors").attr("InputError");
            const Error& e = refused.error;
            PyErr_SetObject(type.ptr(), type(as_argument(e.place), e.reason, e.remedy).ptr());
        }
    });
}

py::array_t<double> array_of(std::span<const Point> points) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
    double* out = array.mutable_data();
    for (const Point p : points) {
        *out++ = p.x;
        *out++ = p.y;
    }
    return array;
}

std::vector<py::array_t<double>> arrays_of(const std::vector<std::vector<Point>>& lines) {
    std::vector<py::array_t<double>> arrays;
    arrays.reserve(lines.size());
    for (const auto& line : lines) arrays.push_back(array_of(line));
    return arrays;
}

void need_rows(const Numbers& numbers, py::ssize_t columns, const std::string& place) {
    if (numbers.ndim() != 2 || numbers.shape(1) != columns)
        throw Refused{{place, "is not an array of shape (N, " + std::to_string(columns) + ")", ""}};
    const std::span<const double> all(numbers.data(), static_cast<std::size_t>(numbers.size()));
    if (!std::ranges::all_of(all, [](double x) { return std::isfinite(x); }))
        throw Refused{{place, "holds a number that is not finite", "remove nan and inf"}};
}

std::vector<Point> points_of(const Numbers& numbers, std::size_t least, const std::string& place) {
    need_rows(numbers, 2, place);
    std::vector<Point> points;
    const auto view = numbers.unchecked<2>();
    for (py::ssize_t i = 0; i < view.shape(0); ++i) points.push_back({view(i, 0), view(i, 1)});
    if (points.size() < least)
        throw Refused{{place,
                       "has " + std::to_string(points.size()) + " points; it needs " + std::to_string(least) +
                           " or more",
                       ""}};
    return points;
}

py::list pairs_of(const Warnings& warnings) {
    py::list list;
    for (const Warning& w : warnings) list.append(py::make_tuple(w.place, w.reason));
    return list;
}

Progress Watch::progress() {
    Progress progress;
    progress.report = [this](const std::string& what, double share) {
        const std::lock_guard lock(mutex_);
        if (reports_.empty() || reports_.back().first != what)
            reports_.emplace_back(what, share);
        else
            reports_.back().second = share;
    };
    progress.stopped = [this] { return stop_.load(std::memory_order_relaxed); };
    return progress;
}

namespace {

/// NumPy's False too: what a comparison of its numbers gives.
bool is_false(const py::object& answer) {
    if (answer.is(py::bool_(false))) return true;
    if (answer.is_none() || answer.is(py::bool_(true))) return false;
    return py::isinstance(answer, py::module_::import("numpy").attr("bool_")) && !answer.cast<bool>();
}

}  // namespace

void Watch::hand_on(const py::object& callback) {
    std::vector<std::pair<std::string, double>> reports;
    {
        const std::lock_guard lock(mutex_);
        reports.swap(reports_);
    }
    if (callback.is_none()) return;
    for (const auto& [what, share] : reports) {
        const py::object answer = callback(what, share);
        if (is_false(answer)) stop_ = true;
    }
}

void Watch::attend(const py::object& callback) {
    if (raised_) return;  // what stopped the work is the first that was raised
    try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        hand_on(callback);
    } catch (...) {
        raised_ = std::current_exception();
        stop_ = true;
    }
}

}  // namespace strandline::python
