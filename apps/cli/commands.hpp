#pragma once
// What each command of the program takes (filled by main.cpp from the command line) and the function that does it. A command returns
// its exit code: 0 done, 1 the input is at fault, 2 the call is at fault, 3 done, but something falls short.
#include <optional>
#include <string>
#include <vector>

namespace strandline::cli {

enum Exit { done = 0, bad_input = 1, bad_call = 2, falls_short = 3 };

/// What every command understands.
struct Common {
    bool quiet = false, verbose = false, json = false;
};

struct TourArguments {
    std::string input, output = "-";
    unsigned long long moves = 0, seed = 1;
    std::string time_limit;                  ///< duration text, "" = none
};
int tour(const TourArguments& arguments, const Common& common);

struct FillArguments {
    std::string input, output = "-", style = "spiral", vehicle = "free", width, spacing;
};
int fill(const FillArguments& arguments, const Common& common);

struct ConnectArguments {
    std::string input, output = "-", style = "bounded", radius;
    std::optional<double> sharpness;
};
int connect(const ConnectArguments& arguments, const Common& common);

struct ConvertArguments {
    std::string input, output = "-", robot = "beachbot";
};
int convert(const ConvertArguments& arguments, const Common& common);

}  // namespace strandline::cli
