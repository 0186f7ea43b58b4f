#include "measuring/diagnose/conventions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace relief {

std::vector<TracerModel> directions(const TracerModel& begin) {
    std::vector<TracerModel> all;
    constexpr std::array<std::array<double, 3>, 5> kBases{{{0, 1, 1}, {1, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}}};
    for (const auto& [swapped, signA, signB] : kBases) {
        TracerModel base = begin;
        base.swapped = begin.swapped != (swapped > 0);
        base.signA *= signA;
        base.signB *= signB;
        all.push_back(base);
        TracerModel limited = base;
        limited.limited = true;
        all.push_back(limited);
        constexpr int kScales = 16;
        for (int n = -kScales; n <= kScales; ++n) {
            if (n == 0) continue;
            TracerModel scaled = base;
            scaled.runScale *= std::exp2(n / 8.0);
            all.push_back(scaled);
        }
    }
    for (const bool limited : {false, true}) {
        TracerModel one = begin;
        one.search = ModelSearch::OneSample;
        one.limited = limited;
        all.push_back(one);
    }
    constexpr int kTurn = 3;  // degrees
    for (int degrees = kTurn - 180; degrees < 180; degrees += kTurn) {
        if (degrees == 0) continue;
        TracerModel turned = begin;
        turned.turn += degrees * std::numbers::pi / 180;
        all.push_back(turned);
        TracerModel mirrored = turned;
        mirrored.signB = -mirrored.signB;
        all.push_back(mirrored);
        for (int n = -8; n <= 8; ++n) {
            TracerModel scaled = turned;
            scaled.runScale *= std::exp2(n / 8.0);
            if (n != 0) all.push_back(scaled);
        }
    }
    return all;
}

std::vector<TracerModel> readings(const HeightField& field) {
    std::vector<TracerModel> all;
    constexpr int kMips = 6;
    for (int mip = 0; mip <= kMips && (std::min(field.width(), field.height()) >> mip) >= 2; ++mip) {
        for (const int turned : {0, 1, 2}) {
            for (int shift = 0; shift < 9; ++shift) {
                TracerModel reading;
                reading.mip = mip;
                reading.flipped = turned == 1;
                reading.transposed = turned == 2;
                // 0: none.
                reading.shiftS = 0.5 * ((shift + 1) % 3 - 1);
                reading.shiftT = 0.5 * ((shift / 3 + 1) % 3 - 1);
                const int faults = (mip > 0 ? 1 : 0) + (turned > 0 ? 1 : 0) + (shift > 0 ? 1 : 0);
                if (faults <= 2) all.push_back(reading);
            }
        }
    }
    return all;
}

TracerModel joined(TracerModel direction, const TracerModel& reading) {
    if (reading.shiftS != 0 || reading.shiftT != 0) {
        direction.shiftS = reading.shiftS;
        direction.shiftT = reading.shiftT;
    }
    direction.flipped = direction.flipped != reading.flipped;
    direction.transposed = direction.transposed != reading.transposed;
    if (reading.mip > 0) direction.mip = reading.mip;
    return direction;
}

std::vector<TracerModel> reportedDirections(const AnsweredRays& given, const TracerModel& begin,
                                            const HeightField& field) {
    std::vector<TracerModel> found;
    using Complex = std::complex<double>;
    for (const bool limited : {false, true}) {
        for (const int mirror : {0, 1, 2, 3}) {
            Complex product = 0;
            double length = 0, error = 0, off = 0;
            std::vector<std::pair<Complex, Complex>> pairs;
            for (std::size_t r = 0; r < given.size(); ++r) {
                const Hit& hit = given.answers[r];
                if (hit.outcome != Outcome::Hit || !std::isfinite(hit.s) || !std::isfinite(hit.t)) continue;
                const double scale = limited ? limitedShare(given.rays[r], field) : 1;
                const Complex run(given.rays.a[r], given.rays.b[r]);
                const std::array<Complex, 4> mirrored{run, Complex(run.imag(), run.real()), -std::conj(run),
                                                      std::conj(run)};
                const Complex expected = mirrored[static_cast<std::size_t>(mirror)] * (scale * hit.lambda);
                const Complex moved(hit.s - given.rays.s0[r], hit.t - given.rays.t0[r]);
                pairs.emplace_back(expected, moved);
                product += moved * std::conj(expected);
                length += std::norm(expected);
                off += std::norm(moved - run * hit.lambda);
            }
            constexpr double kSame = 1e-4;
            if (pairs.size() < 8 || !(length > 0) || off <= kSame * length) continue;
            const Complex ratio = product / length;
            for (const auto& [expected, moved] : pairs) error += std::norm(moved - ratio * expected);
            if (error > kSame * length) continue;
            TracerModel model = begin;
            model.limited = limited;
            model.swapped = mirror == 1;
            if (mirror == 2) model.signA = -1;
            if (mirror == 3) model.signB = -1;
            model.turn = std::arg(ratio);
            model.runScale = std::abs(ratio);
            constexpr double kSmall = 1e-4;
            if (std::abs(model.turn) < kSmall) model.turn = 0;
            if (std::abs(std::abs(model.turn) - std::numbers::pi) < kSmall) {
                model.turn = 0;
                model.signA = -model.signA;
                model.signB = -model.signB;
            }
            if (std::abs(model.runScale - 1) < kSmall) model.runScale = 1;
            found.push_back(model);
        }
    }
    return found;
}

double conventionFaults(const TracerModel& model) {
    TracerModel plain = model;
    plain.gain = 1;
    plain.lift = 0;  // counted by Match::bits()
    return static_cast<double>(modelFaults(plain, plain.address.value_or(Address::Repeat)).size());
}

std::vector<TracerModel> singleFaults(const TracerModel& begin, const HeightField& field) {
    std::vector<TracerModel> models;
    const auto add = [&](TracerModel model) {
        models.push_back(model);
        model.lift += model.gain;
        model.gain = -model.gain;
        models.push_back(model);
    };
    add(begin);
    for (const TracerModel& direction : directions(begin)) {
        if (direction.runScale == begin.runScale && direction.turn == begin.turn && !(direction == begin)) {
            add(direction);
        }
    }
    for (const TracerModel& reading : readings(field)) {
        const TracerModel model = joined(begin, reading);
        if (conventionFaults(model) == conventionFaults(begin) + 1) add(model);
    }
    models.erase(models.begin());  // begin itself
    return models;
}

}  // namespace relief
