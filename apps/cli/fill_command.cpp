// `strandline fill POLYGON.json`: one polygon to strokes.
#include <fmt/core.h>

#include "apps/cli/commands.hpp"
#include "apps/cli/console.hpp"
#include "base/units/units.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {
namespace {

int refuse(const Error& error, Exit exit) {
    complain(error);
    return exit;
}

/// A length on the command line: a bare number is in the file's unit.
Outcome<double> positive(const std::string& text, const std::string& option) {
    const auto value = parse_length(text);
    if (!value) return fail(option, value.error().reason, value.error().remedy);
    if (!(*value > 0) || !std::isfinite(*value)) return fail(option, "must be above 0");
    return *value;
}

}  // namespace

int fill(const FillArguments& arguments, const Common& common) {
    fill::Options options;
}

}  // namespace strandline::cli
