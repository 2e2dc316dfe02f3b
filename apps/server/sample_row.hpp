#pragma once
// The samples of a plan as they are sent: chunk by chunk, so that a page that has most of them gets the rest.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "plan/pipeline/pipeline.hpp"
#include "result/sketch/sketch.hpp"

namespace strandline::serve {

/// What is driven in one go, or between two such; times and strokes count from its own.
struct Chunk {
    std::uint32_t count = 0;
    std::vector<float> columns;  ///< t, x, y, heading, rake x, rake y: `count` values each
    std::vector<std::uint32_t> mask;
    std::vector<std::int32_t> stroke;  ///< -1: none
    std::vector<std::uint8_t> motion;
    std::vector<sketch::Run> runs;  ///< from sample to sample, the last one to what comes next
    std::uint64_t hash = 0;         ///< of all but the runs, which follow from it
};
struct PlacedChunk {
    std::shared_ptr<const Chunk> chunk;
    double t = 0;
    int stroke = 0;
    std::size_t first = 0;  ///< number of its first sample
};
/// The whole drive.
struct SampleRow {
    std::vector<PlacedChunk> chunks;
    std::size_t count = 0;
    std::string tag;  ///< of the content
};
/// As sketch::runs of all samples.
std::vector<sketch::Run> runs_of(const SampleRow& row);

/// Makes rows of plans. A chunk that is the same as in the row before is the same object.
class RowMaker {
  public:
    std::shared_ptr<const SampleRow> row_of(const Plan& plan);
    /// Of one whose samples are in pieces.
    std::shared_ptr<const SampleRow> row_of(const std::vector<trajectory::Placed>& pieces);

  private:
    std::shared_ptr<const Chunk> kept_or(Chunk made) const;
    std::shared_ptr<const SampleRow> finished(SampleRow row);
    struct Made {
        std::shared_ptr<const trajectory::Piece> piece;
        std::shared_ptr<const Chunk> chunk;
        bool used;
    };
    std::map<const trajectory::Piece*, Made> by_piece_;
    std::unordered_map<std::uint64_t, std::shared_ptr<const Chunk>> by_hash_;
};

/// Bytes that make `row` of `base`, which a page has; all of it where there is no base. Little-endian:
/// "SLS2"; uint32 samples n, ranges r, fresh samples m. Then r ranges of 24 bytes, together the n samples in
/// order: float64 t and int32 stroke to be added, uint32 count, int32 the first of them in the base (-1: the
/// next ones of the fresh), 4 bytes of nothing. Then the columns of the fresh, m values each: float32 t, x,
/// y, heading, rake x, rake y; uint32 mask; int32 stroke; uint8 motion (draw, lead, loop, connect, pivot).
/// Stroke -1 is none, and nothing is added to it.
std::string splice_text(const SampleRow& row, const SampleRow* base);

}  // namespace strandline::serve
