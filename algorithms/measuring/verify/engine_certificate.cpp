#include "measuring/verify/engine_certificate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "measuring/verify/certificate_rays.h"
#include "relief/tracers.h"

namespace relief {

namespace {

constexpr int kDigits = 4;

class ConeRays {
  public:
    ConeRays(const HeightField& field, const FloatImage& codes, const EngineConventions& conventions, ConeFetch fetch,
             EngineConeCertificate& result, Work& work)
        : field_(field),
          march_(field, codes, conventions.cone, conventions.relaxed, fetch),
          exact_(makeTracer({"exact", {}}, field, maps_, work)),
          result_(result),
          work_(work) {}

    void trace(const RayBlock& rays) {
        HitBlock truth;
        NullSink sink;
        exact_->trace(rays, truth, sink, work_);
        HitBlock found(rays.size());
        constexpr int kGrain = 64;
        parallelFor(
            work_, rays.size(), [&](std::size_t r) { found.set(r, march_.trace(rays[r])); }, kGrain);
        for (std::size_t r = 0; r < rays.size(); ++r) {
            const double texels = texelsPast(field_, rays[r], truth[r], found[r]);
            if (!(texels > result_.allowed)) continue;
            ++result_.overshoots;
            result_.worst = std::max(result_.worst, texels);
            if (result_.first) continue;
            result_.first =
                counterExample(field_, rays[r], truth[r], found[r], march_.stepPast(rays[r], truth[r].lambda));
        }
        result_.rays += rays.size();
    }

  private:
    const HeightField& field_;
    MapCache maps_;
    EngineMarch march_;
    std::unique_ptr<Tracer> exact_;
    EngineConeCertificate& result_;
    Work& work_;
};

std::string countText(std::uint64_t count) {
    return count == 0 ? "none" : std::to_string(count);
}

}  // namespace

EngineConeCertificate certifyEngineCones(const HeightField& field, const EngineMap& map, int level,
                                         const EngineCheckOptions& options, Work& work) {
    const EngineConventions& c = map.conventions;
    const FloatImage& codes = *map.channel(EngineRole::Cone, level);
    EngineConeCertificate result;
    result.longest = field.slabTexels() / std::tan(kFlattestCertified * std::numbers::pi / 180);
    result.allowed = c.relaxed ? kCoarseTexels : kRoundingTexels;
    for (const float code : codes.pixels()) {
        if (c.cone.stalls(code)) ++result.stalled;
    }
    ConeRays tracing(field, codes, c, options.fetch, result, work);
    if (!c.relaxed && field.surface() == Surface::Bilinear) {
        result.bounds = checkEngineCones(field, codes, c.cone, work);
        const EngineViolations found = violationsOfTexels(field, codes, c.cone, result.longest, work);
        result.texelsInCones = found.texels;
        result.aimed = found.rays.size();
        if (found.rays.size() > 0) tracing.trace(found.rays);
    }
    const CertificateRays seeded(field, result.longest);
    work.progress().begin("comparing rays with exact", static_cast<std::int64_t>(options.rays.rays));
    for (std::uint64_t done = 0; done < options.rays.rays; done += kCertificateBlock) {
        work.throwIfStopped();
        const auto count = static_cast<std::size_t>(std::min(kCertificateBlock, options.rays.rays - done));
        tracing.trace(seeded.block(seedFor(options.rays.seed, done), count));
        work.progress().advance(static_cast<std::int64_t>(count));
    }
    return result;
}

std::string engineCertificateText(const EngineConeCertificate& certificate, const EngineCheckOptions& options) {
    std::string text;
    if (certificate.bounds) {
        const EngineBoundCheck& bounds = *certificate.bounds;
        text += "cones: the widest that a shader can fetch in each of " + std::to_string(bounds.cells) +
                " cells, compared with bounds from the surrounding cells; not proven: " + countText(bounds.open);
        if (bounds.first) {
            text += ", the first in cell (" + std::to_string(bounds.first->x) + ", " + std::to_string(bounds.first->y) +
                    "): slope " + numberText(bounds.first->slope, kDigits) + ", proven from " +
                    numberText(bounds.first->needed, kDigits) + " because of cell (" +
                    std::to_string(bounds.first->otherX) + ", " + std::to_string(bounds.first->otherY) + ")";
        }
        text += "\ntexels whose own cone holds a higher texel: " + countText(certificate.texelsInCones) + "\n";
    } else {
        text += "cones: none compared with bounds, which only conservative cones on a bilinear surface have\n";
    }
    if (certificate.stalled > 0) {
        text += "texels whose cone has no width, where rays stop: " + std::to_string(certificate.stalled) + "\n";
    }
    text +=
        "rays: " + std::to_string(certificate.rays) + " compared with exact, seed " + std::to_string(options.rays.seed);
    if (certificate.aimed > 0) text += ", " + std::to_string(certificate.aimed) + " of them aimed at such texels";
    text += " (horizontal lengths up to " + numberText(certificate.longest, kDigits) +
            " texels); rays that end more than " + numberText(certificate.allowed, kDigits) +
            " texels past the first hit: " + countText(certificate.overshoots);
    if (certificate.overshoots > 0) text += ", at worst " + texelsPastText(certificate.worst);
    text += "\n";
    if (certificate.proven()) return text + "safe: proven by the cones; no ray contradicts it\n";
    if (certificate.safe()) {
        return text + "not decided: no ray contradicts safety, but rays are evidence, not a proof\n";
    }
    return text + "NOT SAFE\n  first ray: " + certificate.first->where + "\n" +
           exampleText(*certificate.first, "answer");
}

std::string engineMaximaText(const LowMaxima& check) {
    std::string text = "values: all " + std::to_string(check.values) +
                       " maxima compared with the heights below them; too low: " + countText(check.low) + "\n";
    if (check.low == 0) return text + "safe: proven by the values\n";
    return text + "NOT SAFE\n  first value: level " + std::to_string(check.level) + ", texel (" +
           std::to_string(check.x) + ", " + std::to_string(check.y) + "): " + numberText(check.stored, 6) +
           " is stored, but must be at least " + numberText(check.height, 6) + "\n";
}

std::string engineConventionsText(const EngineMap& map, const EngineCheckOptions& options) {
    const EngineConventions& c = map.conventions;
    std::string text = c.kind + ", " + enginePackText(c.channels) + ", " + engineBitsText(c.bits);
    if (packs(c.channels, EngineRole::Cone)) {
        text += ", cones as " + std::string(coneUnitName(c.cone.unit)) + " (scale " + numberText(c.cone.scale, 6) +
                ", lengths in " + (c.cone.length == ConeLength::Uv ? "texture coordinates" : "texture widths") + ")";
        if (c.relaxed) text += ", relaxed";
        if (!packs(c.channels, EngineRole::Apex)) text += ", fetched " + std::string(coneFetchName(options.fetch));
    }
    return text + ", " + std::string(surfaceName(c.surface)) + ", " + std::string(addressName(c.wrap)) +
           ", relief depth " + numberText(c.reliefDepth);
}

}  // namespace relief
