#include "plan/pipeline/unserved.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandline::pipeline {
namespace {

constexpr double whole_pins = 0.01;  // of a pin: a spacing that near to whole pins is

void mark(std::vector<bool>& used, const std::vector<bool>& here) {
    used.resize(std::max(used.size(), here.size()));
    for (std::size_t i = 0; i < here.size(); ++i) used[i] = used[i] || here[i];
}

void say_unused(const std::map<std::string, std::vector<bool>>& texts, const char* place, const char* what,
                const char* remedy, Warnings& warnings) {
    for (const auto& [text, used] : texts)
        for (std::size_t i = 0; i < used.size(); ++i)
            if (!used[i]) warnings.push_back({place, fmt::format("{} {} {}", what, i + 1, remedy)});
}

}  // namespace

void Unserved::add(const Options& wanted, const fill::Options& filling, const fill::Fill& filled) {
    bool zigzag = filling.style == fill::Style::zigzag;
    if (zigzag) mark(cuts_[wanted.fill.cuts], filled.cuts_used);
    if (zigzag) mark(segments_[wanted.fill.segments], filled.segments_used);
    for (const fill::Choice& choice : fill::choices_of(filling)) {
        Read& read = choices_[std::string(choice.name)];
        read.serves = choice.serves;
        read.read = read.read || choice.read;
    }
    if (zigzag && wanted.fill.best_direction && wanted.fill.direction != 0) direction_overruled_ = true;
}

Warnings Unserved::warnings() const {
    Warnings warnings;
    for (const auto& [name, choice] : choices_)
        if (!choice.read)
            warnings.push_back(
                {"fill." + name,
                 fmt::format("does nothing here: it serves {}, and no area is filled so", choice.serves)});
    say_unused(cuts_, "fill.cuts", "cut", "parts no area: draw it from edge to edge", warnings);
    say_unused(segments_, "fill.segments", "choice",
               "lies in no segment of any area: name a point inside of one", warnings);
    if (direction_overruled_)
        warnings.push_back(
            {"fill.direction",
             "is overruled by fill.best_direction=on, which was given after it: leave that out"});
    return warnings;
}

void Spacings::add(const fill::Options& filling) {
    if (!filling.masked) return;
    const double pitch = filling.width / filling.pins, pins = filling.spacing / pitch;
    if (std::abs(pins - std::round(pins)) > whole_pins) odd_.insert({filling.spacing, pitch, filling.width});
}

Warnings Spacings::warnings() const {
    Warnings warnings;
    for (const Grid& odd : odd_) {
        const double below = std::max(1.0, std::floor(odd.spacing / odd.pitch)) * odd.pitch;
        warnings.push_back(
            {"fill.spacing",
             fmt::format(
                 "{:.4g} m is no whole number of pins ({:.4g} m apart): between passes less than a pin is "
                 "raked twice or left bare; {:.4g} m or {:.4g} m are whole",
                 odd.spacing, odd.pitch, below, std::min(below + odd.pitch, odd.width))});
    }
    return warnings;
}

}  // namespace strandline::pipeline
