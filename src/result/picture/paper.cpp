// A page of paper: PDF.
#include <cairo-pdf.h>

#include "result/picture/page.hpp"

namespace strandline::picture {
namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Paper::Paper(double width, double height, const std::string& title)
    : bytes_(std::make_unique<std::string>()),
      surface_(cairo_pdf_surface_create_for_stream(append, bytes_.get(), width, height),
               cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
    // The same bytes tomorrow: else the file says when it was made.
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE, "1980-01-01T00:00:00Z");
}

Outcome<std::string> Paper::pdf() {
    cairo_show_page(cairo_.get());
    cairo_surface_finish(surface_.get());
    const cairo_status_t page = cairo_status(cairo_.get()), file = cairo_surface_status(surface_.get());
    if (page != CAIRO_STATUS_SUCCESS || file != CAIRO_STATUS_SUCCESS)
        return fail("picture", cairo_status_to_string(page != CAIRO_STATUS_SUCCESS ? page : file),
                    "make the picture smaller");
    return std::move(*bytes_);
}

}  // namespace strandline::picture
