// Builds maps in the form that engines read (engine_map.h).
//
// If a picture holds heights as well, they are rounded to its bits first, and the map is built over the rounded
// surface, which is the one that the engine draws; rounding outward then keeps every value a bound.
#pragma once

#include "images/pyramid.h"
#include "relief/maps/cone_map.h"
#include "relief/maps/engine_map.h"

namespace relief {

// Cones, one per texel. Conservative: surface_cones.h, on the surface itself, or with a channel of apexes those of
// cone_map.h, one per cell of cell_grid.h, for shaders that step from cell to cell. Dummer, relaxed: as published, with
// apexes on the surface. levels: of MIP levels; the heights of a level are the maxima of 2 x 2 heights below it, and
// its cones are those of that surface. Throws Cancelled, MemoryError.
EngineMap buildEngineCones(ConeKind kind, const ConeParameters& parameters, const HeightField& field,
                           EngineConventions conventions, int levels, Work& work);
// Normals (and heights), in MIP levels as above.
EngineMap buildEngineNormals(const HeightField& field, EngineConventions conventions, int levels, Work& work);
// All levels of the pyramid of maxima, rounded up, or of means, rounded to the nearest.
EngineMap buildEnginePyramid(PyramidKind kind, const HeightField& field, EngineConventions conventions, Work& work);
// The distances of a map of this field, in one channel.
EngineMap buildEngineDistances(const DistanceMap& map, const HeightField& field, EngineConventions conventions,
                               Work& work);

// Number of MIP levels whose texels are 2 x 2 texels of the level below: until a side is odd.
int mostMipLevels(int width, int height);

// The maps of our own tracers that an engine's map holds: a distance map, or a cone map with an apex in a channel.
// std::nullopt for others. The field is that of the heights. Throws InputError naming `path` if sizes do not fit.
std::optional<DistanceMap> distancesOfEngine(const EngineMap& map, const HeightField& field, const std::string& path);
std::optional<ConeMap> cellConesOfEngine(const EngineMap& map, const HeightField& field, const std::string& path);

}  // namespace relief
