// Checks a map as an engine reads it: the numbers of the picture, decoded by its conventions, fetched and interpolated
// as a shader does, over the heights of the picture itself if it holds them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measuring/verify/certificate.h"
#include "measuring/verify/engine_bounds.h"
#include "measuring/verify/engine_march.h"
#include "relief/maps/engine_map.h"

namespace relief {

struct EngineCheckOptions {
    CertificateOptions rays;
    ConeFetch fetch = ConeFetch::Bilinear;
};

// One level of cones on the surface.
struct EngineConeCertificate {
    std::optional<EngineBoundCheck> bounds;  // std::nullopt: relaxed cones, or a surface of columns
    std::uint64_t texelsInCones = 0;
    std::uint64_t stalled = 0;  // texels whose cone has no width
    std::uint64_t rays = 0;     // seeded ones, and those aimed at texels within cones
    std::uint64_t aimed = 0;
    double longest = 0;
    double allowed = 0;
    std::uint64_t overshoots = 0;
    double worst = 0;
    std::optional<CounterExample> first;

    bool safe() const { return overshoots == 0; }
    bool proven() const { return safe() && bounds && bounds->open == 0; }
};

// Certifies the cones of a level over the heights that the engine draws. field: of the level's size. Throws Cancelled.
EngineConeCertificate certifyEngineCones(const HeightField& field, const EngineMap& map, int level,
                                         const EngineCheckOptions& options, Work& work);

// Returns what was checked, how, and the result; one fact per line.
std::string engineCertificateText(const EngineConeCertificate& certificate, const EngineCheckOptions& options);
std::string engineMaximaText(const LowMaxima& check);
// Returns the conventions in one line, as they were read or given.
std::string engineConventionsText(const EngineMap& map, const EngineCheckOptions& options);

}  // namespace relief
