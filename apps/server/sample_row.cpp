#include "sample_row.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

namespace strandline::serve {
namespace {

constexpr std::size_t floats = 6;

/// Eight bytes at a time (FNV-1a's step, with what it leaves out folded in).
class Hash {
  public:
    void add(std::uint64_t value) {
        state_ = (state_ ^ value) * 1099511628211u;
        state_ ^= state_ >> 29;
    }
    template <class Value>
    void add(const std::vector<Value>& values) {
        const auto* bytes = reinterpret_cast<const char*>(values.data());
        for (std::size_t at = 0, size = values.size() * sizeof(Value); at < size; at += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes + at, std::min<std::size_t>(8, size - at));
            add(word);
        }
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 14695981039346656037u;
};

/// To a hundredth of a millisecond: times of the same drive that were summed up another way are the same.
double shown_time(double seconds) { return std::round(seconds * 1e5) / 1e5; }

/// `t` and `stroke`: of the first one.
Chunk chunk_of(std::span<const Sample> samples, double t, int stroke) {
    Chunk chunk;
    const std::size_t n = samples.size();
    chunk.count = static_cast<std::uint32_t>(n);
    chunk.columns.resize(floats * n);
    for (std::size_t i = 0; i < n; ++i) {
        const Sample& s = samples[i];
        const double values[floats] = {shown_time(s.t - t), s.pose.at.x, s.pose.at.y,
                                       s.pose.heading,      s.rake.x,    s.rake.y};
        for (std::size_t k = 0; k < floats; ++k) chunk.columns[k * n + i] = static_cast<float>(values[k]);
        const int own = s.stroke < 0 ? -1 : s.stroke - stroke;
        chunk.mask.push_back(s.mask);
        chunk.stroke.push_back(own);
        chunk.motion.push_back(static_cast<std::uint8_t>(s.motion));
        const bool draws = s.motion == Motion::draw;
        const sketch::Run step{i, i + 1, s.mask, draws || s.mask != 0 ? own : -1, draws};
        if (!chunk.runs.empty() && chunk.runs.back().mask == step.mask &&
            chunk.runs.back().stroke == step.stroke && chunk.runs.back().draws == draws)
            chunk.runs.back().last = step.last;
        else
            chunk.runs.push_back(step);
    }
    Hash hash;
    hash.add(n);
    hash.add(chunk.columns);
    hash.add(chunk.mask);
    hash.add(chunk.stroke);
    hash.add(chunk.motion);
    chunk.hash = hash.value();
    return chunk;
}

/// Two that differ may have one hash.
bool same_chunk(const Chunk& a, const Chunk& b) {
    return &a == &b || (a.hash == b.hash && a.count == b.count && a.columns == b.columns &&
                        a.mask == b.mask && a.stroke == b.stroke && a.motion == b.motion);
}

bool between(const Sample& sample) { return sample.motion == Motion::connect; }

template <class Number>
void put(std::string& bytes, Number value) {
    static_assert(std::endian::native == std::endian::little);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

struct Range {
    double t;
    std::int32_t stroke;
    std::uint32_t count;
    std::int32_t from;
};

std::vector<Range> ranges_of(const SampleRow& row, const SampleRow& base, std::vector<const Chunk*>& fresh) {
    std::unordered_map<std::uint64_t, std::size_t> known;
    for (std::size_t k = 0; k < base.chunks.size(); ++k) known.try_emplace(base.chunks[k].chunk->hash, k);
    std::vector<Range> ranges;
    const auto unknown = base.chunks.size();
    std::size_t next = 0;  // in the base
    for (const PlacedChunk& placed : row.chunks) {
        const Chunk& chunk = *placed.chunk;
        std::size_t same = next;
        if (same >= unknown || !same_chunk(*base.chunks[same].chunk, chunk)) {
            const auto found = known.find(chunk.hash);
            same = found == known.end() || !same_chunk(*base.chunks[found->second].chunk, chunk)
                       ? unknown
                       : found->second;
        }
        if (same == unknown) {
            ranges.push_back({placed.t, placed.stroke, chunk.count, -1});
            fresh.push_back(&chunk);
            next = unknown;
            continue;
        }
        const PlacedChunk& old = base.chunks[same];
        const Range range{placed.t - old.t, placed.stroke - old.stroke, chunk.count,
                          static_cast<std::int32_t>(old.first)};
        constexpr double rounding = 1e-6;  // s
        if (!ranges.empty() && same == next && ranges.back().from >= 0 &&
            ranges.back().stroke == range.stroke && std::abs(ranges.back().t - range.t) < rounding)
            ranges.back().count += range.count;
        else
            ranges.push_back(range);
        next = same + 1;
    }
    return ranges;
}

}  // namespace

std::vector<sketch::Run> runs_of(const SampleRow& row) {
    std::vector<sketch::Run> runs;
    for (const PlacedChunk& placed : row.chunks)
        for (const sketch::Run& own : placed.chunk->runs) {
            sketch::Run run = own;
            run.first += placed.first;
            run.last += placed.first;
            if (run.stroke >= 0) run.stroke += placed.stroke;
            if (run.last == row.count) --run.last;  // behind the last sample there is none
            if (run.last == run.first) continue;
            if (!runs.empty() && runs.back().mask == run.mask && runs.back().stroke == run.stroke &&
                runs.back().draws == run.draws)
                runs.back().last = run.last;
            else
                runs.push_back(run);
        }
    return runs;
}

std::shared_ptr<const SampleRow> RowMaker::row_of(const Plan& plan) {
    SampleRow row;
    const std::vector<Sample>& samples = plan.samples;
    for (std::size_t first = 0; first < samples.size();) {
        std::size_t end = first + 1;
        while (end < samples.size() && between(samples[end]) == between(samples[first])) ++end;
        int stroke = 0;
        for (std::size_t i = end; i-- > first;)
            if (samples[i].stroke >= 0) stroke = samples[i].stroke;
        const double t = samples[first].t;
        row.chunks.push_back(
            {kept_or(chunk_of({samples.data() + first, end - first}, t, stroke)), t, stroke, first});
        first = end;
    }
    by_piece_.clear();
    return finished(std::move(row));
}

std::shared_ptr<const SampleRow> RowMaker::row_of(const std::vector<trajectory::Placed>& pieces) {
    SampleRow row;
    for (auto& [piece, made] : by_piece_) made.used = false;
    std::size_t first = 0;
    for (const trajectory::Placed& placed : pieces) {
        Made& made = by_piece_[placed.piece.get()];
        if (!made.chunk) {
            made.piece = placed.piece;
            made.chunk = kept_or(chunk_of(placed.piece->samples, 0, 0));
        }
        made.used = true;
        row.chunks.push_back({made.chunk, placed.t, placed.stroke, first});
        first += made.chunk->count;
    }
    std::erase_if(by_piece_, [](const auto& entry) { return !entry.second.used; });
    return finished(std::move(row));
}

/// The same as in the row before, or this one.
std::shared_ptr<const Chunk> RowMaker::kept_or(Chunk made) const {
    const auto known = by_hash_.find(made.hash);
    if (known != by_hash_.end() && same_chunk(*known->second, made)) return known->second;
    return std::make_shared<const Chunk>(std::move(made));
}

std::shared_ptr<const SampleRow> RowMaker::finished(SampleRow row) {
    Hash hash;
    by_hash_.clear();
    for (const PlacedChunk& placed : row.chunks) {
        hash.add(placed.chunk->hash);
        hash.add(std::bit_cast<std::uint64_t>(placed.t));
        hash.add(static_cast<std::uint64_t>(placed.stroke));
        by_hash_.try_emplace(placed.chunk->hash, placed.chunk);
        row.count += placed.chunk->count;
    }
    row.tag = fmt::format("{:016x}", hash.value());
    return std::make_shared<const SampleRow>(std::move(row));
}

std::string splice_text(const SampleRow& row, const SampleRow* base) {
    std::vector<const Chunk*> fresh;
    const std::vector<Range> ranges = ranges_of(row, base ? *base : SampleRow{}, fresh);
    std::size_t count = 0;
    for (const Chunk* chunk : fresh) count += chunk->count;
    std::string bytes = "SLS2";
    bytes.reserve(16 + ranges.size() * 24 + count * 33);
    put(bytes, static_cast<std::uint32_t>(row.count));
    put(bytes, static_cast<std::uint32_t>(ranges.size()));
    put(bytes, static_cast<std::uint32_t>(count));
    for (const Range& range : ranges) {
        put(bytes, range.t);
        put(bytes, range.stroke);
        put(bytes, range.count);
        put(bytes, range.from);
        put(bytes, std::uint32_t{0});
    }
    const auto column = [&](auto first, std::size_t size) {
        for (const Chunk* chunk : fresh)
            bytes.append(reinterpret_cast<const char*>(first(*chunk)), chunk->count * size);
    };
    for (std::size_t k = 0; k < floats; ++k)
        column([k](const Chunk& chunk) { return chunk.columns.data() + k * chunk.count; }, sizeof(float));
    column([](const Chunk& chunk) { return chunk.mask.data(); }, sizeof(std::uint32_t));
    column([](const Chunk& chunk) { return chunk.stroke.data(); }, sizeof(std::int32_t));
    column([](const Chunk& chunk) { return chunk.motion.data(); }, sizeof(std::uint8_t));
    return bytes;
}

}  // namespace strandline::serve
