#pragma once
// What is asked of fills and no area of the drawing can serve.
#include <map>
#include <set>

#include "path/fill/fill.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Gathered area by area: a cut, a segment or a choice that only some areas have a use for is no mistake.
class Unserved {
  public:
    void add(const Options& wanted, const fill::Options& filling, const fill::Fill& filled);
    /// One for each that none of the areas served.
    Warnings warnings() const;

  private:
    struct Read {
        std::string serves;
        bool read = false;
    };
    std::map<std::string, std::vector<bool>> cuts_, segments_;  ///< by their text: which were of use
    std::map<std::string, Read> choices_;
    bool direction_overruled_ = false;
};

/// Spacings that no whole number of pins fills, among the areas whose pins lift one by one: nearest whole
/// ones.
class Spacings {
  public:
    void add(const fill::Options& filling);
    Warnings warnings() const;

  private:
    struct Grid {
        double spacing, pitch, width;
        auto operator<=>(const Grid&) const = default;
    };
    std::set<Grid> odd_;
};

}  // namespace strandline::pipeline
