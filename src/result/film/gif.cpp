// Frames -> GIF, by giflib: a palette for the whole film, and of each frame only what changed.
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "result/film/film.hpp"

namespace strandline::film {
namespace {

using shade::Image;
using shade::Rgb;

constexpr int colours = 256, most_side = 65'535;
/// Colours are told apart by their five upper bits.
constexpr int levels = 32, cube = levels * levels * levels;

std::size_t place_in_cube(Rgb c) {
    return static_cast<std::size_t>(c.r >> 3) * levels * levels +
           static_cast<std::size_t>(c.g >> 3) * levels + static_cast<std::size_t>(c.b >> 3);
}

/// The colours met most, and for each place in the cube the nearest of them.
class Palette {
  public:
    void count(const Image& image) {
        for (const Rgb& c : image.pixels) ++met_[place_in_cube(c)];
    }
    void settle() {
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < cube; ++k)
            if (met_[k] > 0) order.push_back(k);
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return met_[a] > met_[b]; });
        order.resize(std::min<std::size_t>(order.size(), colours));
        for (const std::size_t k : order) chosen_.push_back(middle_of(k));
        for (std::size_t k = 0; k < cube; ++k) nearest_[k] = nearest(middle_of(k));
    }
    GifByteType index(Rgb c) const { return nearest_[place_in_cube(c)]; }
    const std::vector<Rgb>& chosen() const { return chosen_; }

  private:
    static Rgb middle_of(std::size_t k) {
        const auto level = [](std::size_t x) { return static_cast<std::uint8_t>(x % levels * 8 + 4); };
        return {level(k / (levels * levels)), level(k / levels), level(k)};
    }
    GifByteType nearest(Rgb c) const {
        std::size_t best = 0;
        int least = 1 << 30;
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            const int r = c.r - chosen_[k].r, g = c.g - chosen_[k].g, b = c.b - chosen_[k].b;
            const int off = 2 * r * r + 4 * g * g + b * b;
            if (off >= least) continue;
            least = off;
            best = k;
        }
        return static_cast<GifByteType>(best);
    }
    std::vector<int> met_ = std::vector<int>(cube, 0);
    std::vector<Rgb> chosen_;
    std::vector<GifByteType> nearest_ = std::vector<GifByteType>(cube, 0);
};

int append(GifFileType* file, const GifByteType* data, int count) {
    static_cast<std::string*>(file->UserData)->append(data, data + count);
    return count;
}

/// giflib's writer; it closes what it opened.
class Writer {
  public:
    Writer() : file_(EGifOpen(&bytes_, append, &error_)) {}
    ~Writer() {
        if (file_ != nullptr) EGifCloseFile(file_, nullptr);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    bool begin(int columns, int rows, const std::vector<Rgb>& palette) {
        if (file_ == nullptr) return false;
        std::array<GifColorType, colours> map{};
        for (std::size_t k = 0; k < palette.size(); ++k) map[k] = {palette[k].r, palette[k].g, palette[k].b};
        const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> object(
            GifMakeMapObject(colours, map.data()), GifFreeMapObject);
        EGifSetGifVersion(file_, true);
        constexpr GifByteType endless[] = {1, 0, 0};
        constexpr int bits = 8;
        return EGifPutScreenDesc(file_, columns, rows, bits, 0, object.get()) == GIF_OK &&
               EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
               EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0") == GIF_OK &&
               EGifPutExtensionBlock(file_, sizeof endless, endless) == GIF_OK &&
               EGifPutExtensionTrailer(file_) == GIF_OK;
    }
    bool add(const Frame& frame, const Palette& palette, double seconds) {
        const GraphicsControlBlock control{
            DISPOSE_DO_NOT, false, static_cast<int>(std::lround(100 * seconds)), NO_TRANSPARENT_COLOR};
        std::array<GifByteType, 4> packed{};
        EGifGCBToExtension(&control, packed.data());
        const int width = frame.right - frame.left, height = frame.bottom - frame.top;
        if (EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, 4, packed.data()) != GIF_OK ||
            EGifPutImageDesc(file_, frame.left, frame.top, width, height, false, nullptr) != GIF_OK)
            return false;
        std::vector<GifByteType> line(static_cast<std::size_t>(width));
        for (int row = frame.top; row < frame.bottom; ++row) {
            for (int k = 0; k < width; ++k)
                line[static_cast<std::size_t>(k)] = palette.index(frame.image.at(frame.left + k, row));
            if (EGifPutLine(file_, line.data(), width) != GIF_OK) return false;
        }
        return true;
    }
    std::string close() {
        EGifCloseFile(file_, &error_);
        file_ = nullptr;
        return std::move(bytes_);
    }
    std::string trouble() const {
        const char* text = GifErrorString(file_ != nullptr && file_->Error != 0 ? file_->Error : error_);
        return text != nullptr ? text : "the encoder gives no reason";
    }

  private:
    std::string bytes_;
    int error_ = 0;
    GifFileType* file_;
};

}  // namespace

Outcome<std::string> gif(const surface::Drive& drive, const shade::View& view, const Options& options,
                         const Progress& progress) {
    if (view.columns() > most_side || view.rows() > most_side)
        return fail("film", "has more pixels a side than a GIF can hold", "use fewer pixels");
    // First the colours: those of the whole sand at the end, and of the robot at the start.
    Palette palette;
    for_frames(drive, view, {options.cell, 1, 2, 0}, [&](const Frame& frame) {
        palette.count(frame.image);
        return true;
    });
    palette.settle();
    Writer writer;
    if (!writer.begin(view.columns(), view.rows(), palette.chosen()))
        return fail("film", writer.trouble(), "use fewer pixels");
    bool written = true;
    double done = 0;
    for_frames(drive, view, options, [&](const Frame& frame) {
        written = writer.add(frame, palette, frame.last ? options.rest : 1 / options.rate);
        progress.report("film", std::min(1.0, ++done / (options.seconds * options.rate)));
        return written && !progress.stopped();
    });
    if (!written) return fail("film", writer.trouble(), "use fewer pixels");
    return writer.close();
}

}  // namespace strandline::film
