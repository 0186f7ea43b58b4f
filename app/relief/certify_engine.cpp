#include "certify_engine.h"

#include <algorithm>
#include <cmath>

#include "measuring/verify/engine_certificate.h"
#include "output.h"
#include "relief/maps/engine_builders.h"
#include "relief/tracers/map_choice.h"

namespace relief::app {

namespace {

EngineConventions conventionsOf(const std::string& path, const ScenarioOptions& scenarioOptions,
                                const EngineOptions& engine) {
    EngineConventions c;
    if (const auto stated = readEngineConventions(path)) {
        c = *stated;
    } else {
        if (!engine.statesChannels()) {
            throw InputError(path, Message(MessageId::EngineNoConventions, {{"sidecar", engineSidecar(path)}}));
        }
        if (scenarioOptions.heightsGiven()) {
            const Scenario scenario = scenarioOptions.scenario();
            c.surface = scenario.surface;
            c.wrap = scenario.address;
            c.reliefDepth = scenario.reliefDepth;
        }
    }
    engine.apply(c);
    scenarioOptions.applyRelief(c.surface, c.wrap, c.reliefDepth);
    return c;
}

// What is certified: the picture, and the surface that the engine draws.
struct Subject {
    std::string path;
    EngineMap map;
    std::shared_ptr<const FloatImage> heights;  // of level 0
    EngineCheckOptions options;

    // Throws InputError if the picture has no heights.
    FloatImage heightsOfLevel(int level) const {
        auto own = map.heights(level);
        if (!own) throw InputError(path, Message(MessageId::EngineNoHeights));
        return std::move(*own);
    }
    HeightField field(std::shared_ptr<const FloatImage> of) const {
        const EngineConventions& c = map.conventions;
        return {std::move(of), c.surface, c.wrap, c.reliefDepth};
    }
};

// Loads the height map that was given; null if none was.
std::shared_ptr<const FloatImage> givenHeights(const ScenarioOptions& scenarioOptions, Session& session) {
    if (!scenarioOptions.heightsGiven()) return nullptr;
    const Scenario scenario = scenarioOptions.scenario();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, session.work());
    noteHeights(session, assets, scenario);
    return assets.heights;
}

// Sets the heights, those of the picture if it has any; returns a line on how they differ from the given ones.
std::string chooseHeights(Subject& subject, const std::shared_ptr<const FloatImage>& given) {
    auto own = subject.map.heights();
    if (!own) {
        if (!given) throw InputError(subject.path, Message(MessageId::EngineNoHeights));
        subject.heights = given;
        return {};
    }
    subject.heights = std::make_shared<const FloatImage>(std::move(*own));
    if (!given) return "heights: those of the picture\n";
    requireSize(subject.path, *subject.heights, given->width(), given->height());
    double largest = 0;
    for (std::size_t i = 0; i < given->size(); ++i) {
        largest = std::max(largest, static_cast<double>(std::abs(given->pixels()[i] - subject.heights->pixels()[i])));
    }
    constexpr int kDigits = 4;
    return "heights: those of the picture, which differ from the height map by at most " +
           numberText(largest, kDigits) + "\n";
}

int statusOf(bool safe, bool proven) {
    return !safe ? kFailed : proven ? kDone : kUndecided;
}

int certifyCones(const Subject& subject, std::string text, Session& session) {
    bool safe = true;
    bool proven = true;
    const int levels = static_cast<int>(subject.map.levels.size());
    for (int l = 0; l < levels; ++l) {
        const auto heights = l == 0 ? subject.heights : std::make_shared<const FloatImage>(subject.heightsOfLevel(l));
        requireSize(subject.path, *subject.map.channel(EngineRole::Cone, l), heights->width(), heights->height());
        // In proportion to the texels of the level.
        constexpr std::uint64_t kFewestRays = 1000;
        EngineCheckOptions options = subject.options;
        options.rays.rays = std::max(options.rays.rays >> (2 * l), std::min(options.rays.rays, kFewestRays));
        const auto certificate = certifyEngineCones(subject.field(heights), subject.map, l, options, session.work());
        if (levels > 1) {
            text += "level " + std::to_string(l) + ", " + std::to_string(heights->width()) + "x" +
                    std::to_string(heights->height()) + "\n";
        }
        text += engineCertificateText(certificate, options);
        safe = safe && certificate.safe();
        proven = proven && certificate.proven();
    }
    session.eraseBar();
    writeStandardOutput(text);
    return statusOf(safe, proven);
}

int certifyMaxima(const Subject& subject, const std::string& text, const FloatImage& heights, Session& session) {
    std::vector<FloatImage> levels;
    for (int l = 0; l < static_cast<int>(subject.map.levels.size()); ++l) {
        levels.push_back(subject.heightsOfLevel(l));
        requireSize(subject.path, levels.back(), ((heights.width() - 1) >> l) + 1, ((heights.height() - 1) >> l) + 1);
    }
    const LowMaxima check = checkEngineMaxima(heights, levels, session.work());
    session.eraseBar();
    writeStandardOutput(text + engineMaximaText(check));
    return statusOf(check.low == 0, true);
}

// A map that one of our tracers walks: certified like a stored one.
int certifyStored(const Subject& subject, const StoredMap& map, const std::string& text, Session& session) {
    const HeightField field = subject.field(subject.heights);
    MapCache maps;
    MethodChoice method{methodOfMap(mapKindName(map)), {}};
    method = useMap(subject.path, map, withStoredMap(method), field, maps);
    const Certificate certificate = certify(method, field, subject.options.rays, maps, session.work());
    session.eraseBar();
    writeStandardOutput(text + certificateText(certificate, field));
    return statusOf(certificate.safe(), certificate.proven());
}

}  // namespace

int certifyEngineMap(const ScenarioOptions& scenarioOptions, const EngineOptions& engine,
                     const CertificateOptions& rays, Session& session) {
    Subject subject;
    subject.path = *scenarioOptions.map();
    subject.options = {rays, engine.fetch()};
    const EngineConventions conventions = conventionsOf(subject.path, scenarioOptions, engine);
    subject.map = readEngineMap(subject.path, conventions, session.work());
    const EngineConventions& c = subject.map.conventions;
    const bool pyramid = c.kind == "max-pyramid";
    if (c.kind == "mean-pyramid" ||
        (!pyramid && !packs(c.channels, EngineRole::Cone) && !packs(c.channels, EngineRole::Distance))) {
        throw InputError(subject.path, Message(MessageId::EngineNoBounds, {{"kind", c.kind}}));
    }
    const std::shared_ptr<const FloatImage> given = givenHeights(scenarioOptions, session);
    std::string text = engineConventionsText(subject.map, subject.options) + "\n";
    // The maxima must bound the given heights, not their own level 0.
    if (pyramid && given) return certifyMaxima(subject, text, *given, session);
    text += chooseHeights(subject, given);
    if (pyramid) return certifyMaxima(subject, text, *subject.heights, session);
    const HeightField field = subject.field(subject.heights);
    if (const auto distances = distancesOfEngine(subject.map, field, subject.path)) {
        return certifyStored(subject, std::make_shared<const DistanceMap>(*distances), text, session);
    }
    if (const auto cones = cellConesOfEngine(subject.map, field, subject.path)) {
        return certifyStored(subject, std::make_shared<const ConeMap>(*cones), text, session);
    }
    return certifyCones(subject, text, session);
}

}  // namespace relief::app
