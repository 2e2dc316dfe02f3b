#include "result/picture/page.hpp"

namespace strandline::picture {
namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(bytes)->append(data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Page::Page(int columns, int rows)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy) {}

unsigned char* Page::bytes() const {
    cairo_surface_flush(surface_.get());
    return cairo_image_surface_get_data(surface_.get());
}
int Page::stride() const { return cairo_image_surface_get_stride(surface_.get()); }
void Page::changed() const { cairo_surface_mark_dirty(surface_.get()); }

Outcome<std::string> Page::png() const {
    std::string bytes;
    cairo_status_t status = cairo_status(cairo_.get());
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
    if (status != CAIRO_STATUS_SUCCESS)
        return fail("picture", cairo_status_to_string(status), "make the picture smaller");
    return bytes;
}

}  // namespace strandline::picture
