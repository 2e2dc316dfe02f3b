#pragma once
// The drawing as it appears, the robot to scale: a drive as pictures one after the other, and as a GIF.
#include <functional>
#include <string>

#include "result/shade/shade.hpp"

namespace strandline::film {

struct Options {
    double cell = 0.01;   ///< metres, of the raster
    double seconds = 15;  ///< of the film, whatever the drive takes
    double rate = 12;     ///< pictures a second
    double rest = 2;      ///< s that the last picture stays
};
/// A picture and what of it differs from the one before, pixels: [left, right) x [top, bottom).
struct Frame {
    shade::Image image;
    int left = 0, top = 0, right = 0, bottom = 0;
    bool last = false;
};
/// Calls what(frame) with each picture in order; false from it ends the film. Pictures are evenly spaced in
/// the drive's own time; the last shows the sand without the robot. O(drive + frames x changed pixels).
void for_frames(const surface::Drive& drive, const shade::View& view, const Options& options,
                const std::function<bool(const Frame&)>& what);

/// GIF 89a, endless, of at most 256 colours (those of the final sand that are met most). Error: more than
/// 65,535 pixels a side, or the encoder's.
Outcome<std::string> gif(const surface::Drive& drive, const shade::View& view, const Options& options,
                         const Progress& progress = {});

}  // namespace strandline::film
