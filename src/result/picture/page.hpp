#pragma once
// Private to the room: a page of pixels to paint on, and its PNG.
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

}  // namespace strandline::picture
