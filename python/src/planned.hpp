#pragma once
// A plan as Python holds it.
#include <memory>
#include <mutex>
#include <string>

#include "bridge.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline::python {

/// The drawing that plans are made of, and what of it is kept from one plan to the next.
struct Workshop {
    std::string bytes, title, place;
    Robot robot;
    Warnings granted;  ///< what the call took for granted before anything was planned
    Planner planner;
    std::mutex mutex;  ///< the planner serves one thread at a time
};

/// A finished plan; never changed.
struct Planned {
    std::shared_ptr<const Plan> plan;
    std::shared_ptr<Workshop> workshop;  ///< null: read from a plan file, which does not hold the drawing
};

// What of a plan there is to read, a file each.
void add_columns(py::class_<Planned>& type);
void add_results(py::class_<Planned>& type);

}  // namespace strandline::python
