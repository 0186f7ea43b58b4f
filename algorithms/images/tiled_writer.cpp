#include "images/tiled_writer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <utility>

#include <nlohmann/json.hpp>

#include "images/tiled_pages.h"
#include "relief/memory.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

std::size_t numbersBytes(const TiledLayout& layout, int rows) {
    return static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(rows) * numberBytes(layout.type);
}

TiledLayout checkedLayout(const HeightRows& source, const std::string& path) {
    if (std::max(source.width(), source.height()) > kMostTiledSide)
        throw InputError(path,
                         Message(MessageId::TiledSides,
                                 {{"width", source.width()}, {"height", source.height()}, {"limit", kMostTiledSide}}));
    return tiledLayout(source.width(), source.height(), source.type());
}

// What FILE.part is made of.
std::string workText(const HeightRows& source) {
    return nlohmann::ordered_json{{"version", kTiledFileVersion},
                                  {"size", {source.width(), source.height()}},
                                  {"type", static_cast<int>(source.type())},
                                  {"heights", source.identity()}}
        .dump();
}

// Copies texels of a row to a row of a tile and repeats the last one up to the tile's side.
template <class Number>
void copyRow(const std::byte* from, std::size_t count, std::byte* to) {
    std::memcpy(to, from, count * sizeof(Number));
    Number last;
    std::memcpy(&last, from + (count - 1) * sizeof(Number), sizeof last);
    for (std::size_t x = count; x < kTileSide; ++x) std::memcpy(to + x * sizeof(Number), &last, sizeof last);
}

void copyRow(NumberType type, const std::byte* from, std::size_t count, std::byte* to) {
    if (type == NumberType::UInt8) return copyRow<std::uint8_t>(from, count, to);
    if (type == NumberType::UInt16) return copyRow<std::uint16_t>(from, count, to);
    copyRow<float>(from, count, to);
}

}  // namespace

TiledWriter::TiledWriter(HeightRows& source, const std::string& path, const TiledWriting& how)
    : source_(source),
      path_(path),
      how_(how),
      layout_(checkedLayout(source, path)),
      part_(path, layout_, workText(source), how.earlier),
      bands_((layout_.height + kTileSide - 1) / kTileSide) {
    const std::size_t band = numbersBytes(layout_, std::min(kTileSide, layout_.height));
    requireMemory(byteSum({byteProduct({2, band}), TiledLevels::memoryBytes(layout_)}), path_,
                  MemoryHint::SmallerPicture);
    band_.resize(band);
    nextBand_.resize(band);
    levels_ = TiledLevels::of(layout_);
    if (!part_.earlier()) return;
    done_ = part_.earlier()->bands;
    learned_ = part_.earlier()->learned;
    if (done_ > bands_ || (done_ > 0 && !levels_->restore(part_.earlier()->levels)))
        throw InputError(part_.path(), Message(MessageId::SweepOther));
}

int TiledWriter::rowsOf(std::int64_t band) const {
    return static_cast<int>(std::min<std::int64_t>(kTileSide, layout_.height - band * kTileSide));
}

// Writes the neighbouring tiles of one group that stand in the row of tiles from firstRow on.
void TiledWriter::putGroup(const TilePage& page, int firstRow, int count, const std::byte* rows, int groupColumn) {
    alignas(8) std::array<std::byte, kGroupBytes / 2> tiles;
    const std::size_t bytes = page.tileBytes() / kTileTexels;
    const int first = groupColumn << page.acrossShift;
    const int last = std::min(first + (1 << page.acrossShift), page.tilesAcross());
    for (int x = first; x < last; ++x) {
        const int left = x * kTileSide;
        const auto texels = static_cast<std::size_t>(std::min(kTileSide, page.width - left));
        std::byte* to = tiles.data() + static_cast<std::size_t>(x - first) * page.tileBytes();
        for (int y = 0; y < kTileSide; ++y, to += kTileSide * bytes) {
            if (y >= count) {
                std::memcpy(to, to - kTileSide * bytes, kTileSide * bytes);
                continue;
            }
            const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(page.width);
            copyRow(page.type, rows + (row + static_cast<std::size_t>(left)) * bytes, texels, to);
        }
    }
    const std::size_t all = static_cast<std::size_t>(last - first) * page.tileBytes();
    part_.writeTiles(page, page.tileOffset(first, firstRow >> kTileShift), {tiles.data(), all});
}

void TiledWriter::putTiles(const TilePage& page, int firstRow, int count, const std::byte* rows, ThreadTeam& threads) {
    threads.run(page.groupsAcross, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t x = begin; x < end; ++x) putGroup(page, firstRow, count, rows, static_cast<int>(x));
    });
}

// Returns the exception that reading ends with, so that the band in work can be completed first.
std::exception_ptr TiledWriter::readBand(std::int64_t band, std::vector<std::byte>& rows, Work& work) {
    try {
        source_.read(static_cast<int>(band * kTileSide), rowsOf(band), rows.data(), work);
        return nullptr;
    } catch (...) {
        return std::current_exception();
    }
}

// Writes the band in band_. The loops do not heed the stop token: a band is done wholly or, after an exception, not at
// all.
void TiledWriter::writeBand(Work& work) {
    ThreadTeam& threads = work.threads();
    putTiles(layout_.pages.front(), static_cast<int>(done_ * kTileSide), rowsOf(done_), band_.data(), threads);
    levels_->add(band_.data(), rowsOf(done_), threads);
}

void TiledWriter::keep() {
    part_.keep({done_, learned_, levels_->save()});
}

void TiledWriter::writeBands(Work& work) {
    ThreadTeam& threads = work.threads();
    const auto flush = [&] {
        levels_->flush(threads, [&](const TilePage& page, int firstRow, int count, const std::byte* rows) {
            putTiles(page, firstRow, count, rows, threads);
        });
    };
    // Rows that were complete when an earlier run failed.
    flush();
    if (done_ == bands_) return;
    auto keptAt = Clock::now();
    std::exception_ptr failure = readBand(done_, band_, work);
    while (!failure) {
        std::string learned = source_.learned();
        const bool more = done_ + 1 < bands_;
        // The next band is read while this one is written.
        threads.run(2, 1, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                if (i == 0 && more) failure = readBand(done_ + 1, nextBand_, work);
                if (i == 1) writeBand(work);
            }
        });
        ++done_;
        learned_ = std::move(learned);
        flush();
        work.progress().advance(1);
        if (!more) return;
        std::swap(band_, nextBand_);
        if (work.stopped() && !failure) failure = std::make_exception_ptr(Cancelled());
        if (!failure && std::chrono::duration<double>(Clock::now() - keptAt).count() < how_.keepEverySeconds) continue;
        if (failure) break;
        keep();
        keptAt = Clock::now();
    }
    std::rethrow_exception(failure);
}

void TiledWriter::write(Work& work) {
    const auto kept = [&](const InputError& error) {
        const MessageValue why("why", error.message());
        return Message(MessageId::SweepFailed, {why, {"done", keptBands()}, {"total", bands()}, {"part", partPath()}});
    };
    // Keeps what is done; where that fails, too, what was kept before counts.
    const auto keepAfterFailure = [&] {
        if (done_ == keptBands()) return;
        try {
            keep();
        } catch (const WorkError&) {
        }
    };
    try {
        if (part_.earlier() && done_ > 0)
            source_.restore(learned_);
        else
            source_.prepare(work);
        learned_ = source_.learned();
        work.progress().begin("tiling", bands_ - done_);
        writeBands(work);
        part_.finish();
    } catch (const Cancelled&) {
        keepAfterFailure();
        throw;
    } catch (const WorkError& error) {
        keepAfterFailure();
        if (keptBands() == 0) throw;
        throw WorkError(error.subject(), kept(error));
    } catch (const MemoryError&) {
        keepAfterFailure();
        throw;
    } catch (const InputError& error) {
        keepAfterFailure();
        if (keptBands() == 0) throw;
        throw InputError(error.subject(), kept(error));
    }
}

}  // namespace relief
