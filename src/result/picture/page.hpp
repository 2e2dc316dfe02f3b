#pragma once
// Private to the room: what is painted on: a page of pixels and its PNG, a page of paper and its PDF.
#include <cairo.h>

#include <memory>
#include <string>

#include "base/outcome/outcome.hpp"

namespace strandline::picture {

class Page {
  public:
    Page(int columns, int rows);
    cairo_t* cairo() const { return cairo_.get(); }
    /// Four bytes a pixel (blue, green, red, unused), rows `stride` bytes apart. After writing: changed().
    unsigned char* bytes() const;
    int stride() const;
    void changed() const;
    Outcome<std::string> png() const;

  private:
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

/// A page of paper, in points (1/72 inch).
class Paper {
  public:
    Paper(double width, double height, const std::string& title);
    cairo_t* cairo() const { return cairo_.get(); }
    /// Ends the page: nothing can be painted after it.
    Outcome<std::string> pdf();

  private:
    std::unique_ptr<std::string> bytes_;  ///< its place stays when the paper moves
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

}  // namespace strandline::picture
