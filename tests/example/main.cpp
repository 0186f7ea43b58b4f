// Prints a pixel's ray, its hit on the relief, and every step of the tracer.
#include <iostream>

#include <relief/relief.h>

int main() {
    using namespace relief;
    const auto heights = std::make_shared<FloatImage>(makeRelief("bricks", 128, 128, 1));
    const HeightField field(heights, Surface::Bilinear, Address::Repeat, 0.1);
    const auto ray = floorRay(field, Camera{}, 800, 600, 400, 300);
    if (!ray) return 1;
    MapCache maps;
    Work work;
    RayBlock rays;
    rays.push(*ray);
    HitBlock hits;
    StepLog log;
    makeTracer({"max-pyramid", {}}, field, maps, work)->trace(rays, hits, log, work);
    for (const Step& step : log.steps) {
        std::cout << decisionName(step.decision) << " level " << step.level << " texel (" << step.i << "," << step.j
                  << ") lambda " << step.lambdaIn << " to " << step.lambdaOut << ", maximum " << step.value << "\n";
    }
    std::cout << "hit at texel (" << hits.s[0] << ", " << hits.t[0] << ")\n";
    return hits.outcome[0] == Outcome::Hit ? 0 : 1;
}
