#pragma once
// How every room says what went wrong, what was left out, and how far it has come.
#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace strandline {

/// Why something could not be done. Each part is a short phrase without a final stop.
/// place:  where, as the user knows it ("line 12, path #eye", "fill.spacing"); may be empty.
/// reason: what is wrong there ("the file ends inside a tag").
/// remedy: what the user can do; may be empty.
struct Error {
    std::string place, reason, remedy;
    bool operator==(const Error&) const = default;
};

/// Something that was left out, repaired or replaced, and where. Warnings are data: the apps show them.
struct Warning {
    std::string place, reason;
    bool operator==(const Warning&) const = default;
};
using Warnings = std::vector<Warning>;

/// A value, or the one Error that kept us from it.
template <class T>
using Outcome = tl::expected<T, Error>;

/// The error side of an Outcome: `return fail("line 3", "not a number", "write a number");`
inline tl::unexpected<Error> fail(std::string place, std::string reason, std::string remedy = {}) {
    return tl::unexpected<Error>(Error{std::move(place), std::move(reason), std::move(remedy)});
}

/// "place: reason; remedy": the one sentence an app prints.
std::string sentence(const Error& error);
std::string sentence(const Warning& warning);

/// Long work reports to this and asks it whether to go on. Default: silent and endless.
/// report(what, share): share in 0..1, monotone within one `what`.
/// stopped(): true once the user wants the best so far; asked often, so it must be cheap.
struct Progress {
    std::function<void(const std::string& what, double share)> report = [](const std::string&, double) {};
    std::function<bool()> stopped = [] { return false; };
    /// Share of a time limit used so far; empty: none is set. Whoever plans by it differs from run to run.
    std::function<double()> time_used = {};
};

}  // namespace strandline
